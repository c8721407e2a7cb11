#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/array_attributes.hpp"
#include "raster/table/product_attributes.hpp"
#include "raster/table/raster.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// What an attribute holds.
using AttributeValue = std::variant<double, std::int32_t, std::uint64_t, std::string>;
/// Attributes with their names, in their order.
using Attributes = std::vector<std::pair<std::string, AttributeValue>>;

/// What goes along a dimension of a product.
enum class Along { rows, columns, nothing };

/// An array beside the samples: numbers for each row or column, or the words of a dimension.
struct DescribedArray {
  std::string name;
  std::vector<std::string> dimensions;  ///< A name for each.
  Attributes attributes = {};
  Along along = Along::nothing;
  std::size_t width = 1;  ///< Numbers for each row or column.
  /// Puts the `width` numbers of a row or column.
  std::function<void(std::size_t index, std::span<double> numbers)> values = {};
  std::vector<std::string> words = {};  ///< Letters that it holds instead of numbers.

  /// Whether it gives its dimension coordinates.
  [[nodiscard]] bool is_coordinate() const { return dimensions.size() == 1 && dimensions.front() == name; }
};

/// Everything that a self-describing file says of a product (docs/formats/samples.md), for HDF5 and Zarr.
struct DescribedProduct {
  Attributes root;
  std::string down;    ///< Names of the dimensions of the samples.
  std::string across;  ///< The same.
  std::vector<DescribedArray> arrays;
  Attributes samples;  ///< Attributes of the samples.
  Attributes map;      ///< Those of the array `map_name`, which holds nothing else; none where it is empty.
};

/// Name of the array that says how an image lies on a map.
inline constexpr const char* map_name = "utm";

/// Describes a product, but for what nobody knows of it.
/// @param option_words  of its options, each an attribute
/// @param counts        the samples are counts of the converter
[[nodiscard]] DescribedProduct describe(const Product& product, const FileAttributes& option_words, bool counts);

/// What is wrong with the attributes of the root of a file: a `format_version` of ours that is not known, or one that
/// cannot be read and says LSB, sampling rate, bits or, in files of ours, processing is refused by its name. A problem
/// without a place.
[[nodiscard]] std::optional<core::Problem> problem_of_root(const ArrayAttributes& root);

/// Takes bits, LSB and sampling rate from the attributes of a file of this layout.
void take_known_attributes(RasterInfo& info);

/// Reads an array of numbers, `width` for each of `length`; nothing where it is not there or not of that shape.
using AxisReader =
    std::function<std::optional<std::vector<double>>(const std::string& name, std::size_t length, std::size_t width)>;

/// The axes of a file of this layout; nothing where it lacks times, carriers or places of columns.
[[nodiscard]] std::optional<RasterAxes> read_axes(std::size_t rows, std::size_t columns, const AxisReader& read);

}  // namespace sarsim::raster
