#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/image_value.hpp"
#include "raster/table/stored_grid.hpp"

namespace sarsim::raster {

/// How one component of a sample is stored.
enum class RawNumber { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of it.
[[nodiscard]] std::size_t bytes_of(RawNumber number);
/// "int8" and so on.
[[nodiscard]] std::string_view name_of(RawNumber number);

/// A file of samples that somebody else made: a header, then rows of samples without anything between.
struct RawLayout {
  std::uint64_t header_bytes = 0;
  std::size_t width = 512;  ///< Samples of a row.
  std::size_t height = 0;   ///< Rows; 0: as many as the file holds.
  double offset = 0.0;      ///< Subtracted from every component.
  RawNumber number = RawNumber::uint8;
  ImageValue value = ImageValue::complex;  ///< Complex samples are two components, the others one; never rgb.
  bool big_endian = false;
  bool q_first = false;  ///< Complex: Q before I.

  [[nodiscard]] std::size_t sample_bytes() const { return bytes_of(number) * (value == ImageValue::complex ? 2U : 1U); }
  friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

/// A layout in words: "complex float32, little-endian, 1024 samples of a row after 32 bytes".
[[nodiscard]] std::string to_string(const RawLayout& layout);

/// Everything that is wrong with a layout for a file of so many bytes: errors where it cannot be read, a warning where
/// fewer rows are there than it says, a note where bytes are left over.
[[nodiscard]] core::Problems check_raw_layout(const RawLayout& layout, const std::string& file,
                                              std::uint64_t file_bytes);

/// Whole rows that a file of so many bytes holds, at most `height`. The layout has passed `check_raw_layout`.
[[nodiscard]] std::size_t raw_rows(const RawLayout& layout, std::uint64_t file_bytes);

/// How windows of it are read.
[[nodiscard]] StoredGrid grid_of(const RawLayout& layout);

struct EnviHeader;

/// The layout that an ENVI header gives: one band of float or complex float.
[[nodiscard]] RawLayout layout_of(const EnviHeader& header);

/// How a data file that has a sound ENVI header beside it is laid out; nothing for other files.
[[nodiscard]] std::optional<RawLayout> envi_layout(const std::filesystem::path& data);

/// A layout that a file may have, and why.
struct RawGuess {
  RawLayout layout;
  double likelihood = 0.0;  ///< 0 to 1, for the order only.
  std::string reason;
};

/// Likely layouts of a file, likeliest first, at most ten: the type of numbers from how floating-point exponents and
/// integers spread, complex or real from how neighbours agree, the width from the spacing at which samples agree most
/// (rows beside each other look alike) and from the file's size. Reads a few MB at most. Empty for an empty file;
/// a problem where it cannot be opened; std::system_error where the disk fails.
[[nodiscard]] std::variant<std::vector<RawGuess>, core::Problem> guess_raw_layout(const std::filesystem::path& path);

}  // namespace sarsim::raster
