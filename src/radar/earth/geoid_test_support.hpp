#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include <fmt/format.h>

/// Small made-up grids in all formats.
namespace sarsim::radar::geoid_test {

/// Adds the bytes of a number, the highest first.
template <class Bits>
void append_bytes(std::string& bytes, Bits bits) {
  for (std::size_t i = sizeof(Bits); i-- > 0;) bytes += static_cast<char>((bits >> (8 * i)) & 255U);
}

/// The level of a pixel of `pgm_bytes`; one for each pole.
inline std::uint16_t pgm_level(int row, int column) {
  const int longitude = row == 0 || row == 6 ? 0 : column;
  return static_cast<std::uint16_t>((row * 7919 + longitude * 10007 + 12345) % 65536);
}

/// A grid of GeographicLib with a node every 30 deg.
inline std::string pgm_bytes() {
  std::string bytes = "P5\n# Geoid file made for a test\n# Offset -108\n# Scale 0.003\n12 7\n65535\n";
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 12; ++column) append_bytes(bytes, pgm_level(row, column));
  return bytes;
}

/// The header of a GTX file.
inline std::string gtx_header(double south, double west, double dlat, double dlon, std::int32_t rows,
                              std::int32_t columns) {
  std::string bytes;
  for (const double value : {south, west, dlat, dlon}) append_bytes(bytes, std::bit_cast<std::uint64_t>(value));
  for (const std::int32_t count : {rows, columns}) append_bytes(bytes, std::bit_cast<std::uint32_t>(count));
  return bytes;
}

/// Adds a float to a GTX file.
inline void append_float(std::string& bytes, float value) { append_bytes(bytes, std::bit_cast<std::uint32_t>(value)); }

/// A region, 10 to 12 deg north and 200 to 201.5 deg east, every half degree: latitude + longitude/100 in m. The node
/// at the north-east corner has no value.
inline std::string gtx_bytes() {
  std::string bytes = gtx_header(10.0, 200.0, 0.5, 0.5, 5, 4);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 4; ++column)
      append_float(bytes, row == 4 && column == 3
                              ? -88.8888F
                              : static_cast<float>(10.0 + 0.5 * row + 0.01 * (200.0 + 0.5 * column)));
  return bytes;
}

/// Cells of 1 deg whose south-west corner is at (50, 7): centres at 50.5, 51.5 and 7.5, 8.5, 9.5; one has no value.
inline std::string ascii_text() {
  return "ncols 3\nNROWS 2\nxllcorner 7\nyllcorner 50\ncellsize 1\nNODATA_value -9999\n"
         "47.5 48.5 49.5\n46.5 -9999 48.25\n";
}

}  // namespace sarsim::radar::geoid_test
