#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raster/hdf5/hdf5_library.hpp"
#include "raster/table/array_attributes.hpp"

namespace sarsim::raster {

/// Name and value of attributes, in the order of their names.
using AttributeTexts = std::vector<std::pair<std::string, std::string>>;

/// The attributes of an object as text: strings as they are, numbers in decimal; others by their names alone. At most
/// 1000 attributes, none longer than `longest` bytes.
/// @param lists  also lists of up to 16 numbers, as one text separated by commas
[[nodiscard]] ArrayAttributes read_attributes(hid_t object, std::uint64_t longest, bool lists);

/// The names of the dimensions of a dataset by its attribute DIMENSION_LIST, which refers to dimension scales; without
/// a slash, empty for dimensions without a scale, none where the attribute is missing or of another type.
[[nodiscard]] std::vector<std::string> dimension_names(hid_t dataset);

/// The value of an attribute by its exact name.
[[nodiscard]] std::optional<std::string> find_attribute(const AttributeTexts& attributes, std::string_view name);

}  // namespace sarsim::raster
