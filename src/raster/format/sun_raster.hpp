#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <variant>
#include <vector>

#include "core/os/input_file.hpp"
#include "core/report/problem.hpp"
#include "raster/table/image_value.hpp"

namespace sarsim::raster {

/// How the pixels of a Sun raster file are stored.
enum class SunType : std::uint32_t {
  old = 0,         ///< As `standard`; the length in the header may be 0.
  standard = 1,    ///< Colours in the order blue, green, red.
  run_length = 2,  ///< Run-length encoded, colours as `standard`.
  rgb = 3,         ///< Colours in the order red, green, blue.
};

/// The header of a Sun raster file: eight 32-bit numbers, most significant byte first, of which the first is the magic
/// number 59 A6 6A 95. Reference: SunOS, rasterfile(5), <rasterfile.h>; docs/formats/images.md.
struct SunRasterHeader {
  static constexpr std::uint32_t magic = 0x59a66a95U;
  static constexpr std::size_t bytes = 32;

  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t depth = 0;  ///< Bits of a pixel: 1, 8, 24 or 32.
  std::uint32_t length = 0;
  SunType type = SunType::standard;
  std::uint32_t map_type = 0;  ///< 0 none, 1 red, green and blue one after the other, 2 unknown to readers.
  std::uint32_t map_length = 0;

  /// Bytes of a row: rows end at a multiple of 16 bits.
  [[nodiscard]] std::uint64_t row_bytes() const { return (std::uint64_t{width} * depth + 15) / 16 * 2; }
  [[nodiscard]] std::uint64_t data_offset() const { return bytes + std::uint64_t{map_length}; }
};

/// Reads and checks the header: every size is held against the file's, so that whoever trusts it need not. The pixels
/// of a compressed file may still end early. Other types and depths are refused with their names.
[[nodiscard]] std::variant<SunRasterHeader, core::Problem> read_sun_header(const core::InputFile& file);

/// Turns the stored pixels of a raster into grey levels or colours.
class SunPixels {
 public:
  /// Reads the colour map where there is one. std::runtime_error where the file has become shorter.
  SunPixels(const core::InputFile& file, const SunRasterHeader& header);

  /// Whether every pixel is a grey level: no map, or a map of greys only.
  [[nodiscard]] bool grey() const { return grey_; }
  [[nodiscard]] const SunRasterHeader& header() const { return header_; }
  /// The pixel `column` of a row of which `bytes` holds what begins at byte `first_byte`. A number that the map does
  /// not hold is black. Of one bit without a map, 1 is black and 0 white.
  [[nodiscard]] Rgb colour(std::span<const std::byte> bytes, std::uint64_t first_byte, std::uint64_t column) const;

 private:
  SunRasterHeader header_;
  std::array<Rgb, 256> map_{};  // Depth 1 and 8.
  bool grey_ = true;
};

/// Writes a picture of grey levels (type 1, depth 8, without a map), rows from the top, width * height values.
/// The file appears when it is complete, an existing one is replaced only with `replace`. std::invalid_argument for
/// sizes that the format cannot hold or that do not fit the values, std::system_error where the disk fails.
void write_sun_raster(const std::filesystem::path& path, std::size_t width, std::size_t height,
                      std::span<const std::uint8_t> grey, bool replace = false);
/// The same in colour (type 1, depth 24).
void write_sun_raster(const std::filesystem::path& path, std::size_t width, std::size_t height,
                      std::span<const Rgb> colour, bool replace = false);

}  // namespace sarsim::raster
