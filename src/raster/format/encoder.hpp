#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// How the rows of a recording become bytes.
struct Encoding {
  scene::FileFormat format = scene::FileFormat::binary;
  bool counts = true;  ///< Integer counts rather than volts; text and BINARY are always counts.
  int bits = 8;        ///< Of the A/D converter, 1 to 64.
  bool minus_zero =
      false;             ///< ASCII and BRACKET write "-0" for a negative component that rounds to 0 (classic profile).
  bool doubles = false;  ///< Volts in HDF5 and NPY in double precision.
};

/// Bytes of a component (I or Q) in BINARY: ceil(bits/8).
[[nodiscard]] std::size_t binary_component_bytes(const Encoding& encoding);
/// The same in HDF5 and NPY: 4 (float32 or int32) or, for counts of more than 31 bits and volts in
/// double precision, 8.
[[nodiscard]] std::size_t array_component_bytes(const Encoding& encoding);

/// The bytes of a block in each format; `encode_rows` chooses. HDF5 and NPY store the same array. The rules are those
/// of `encode_rows`.
[[nodiscard]] std::vector<std::byte> encode_ascii(const Encoding& encoding, const Block& block);
/// See `encode_ascii`.
[[nodiscard]] std::vector<std::byte> encode_bracket(const Encoding& encoding, const Block& block);
/// See `encode_ascii`.
[[nodiscard]] std::vector<std::byte> encode_csv(const Encoding& encoding, const Block& block);
/// See `encode_ascii`.
[[nodiscard]] std::vector<std::byte> encode_binary(const Encoding& encoding, const Block& block);
/// See `encode_ascii`.
[[nodiscard]] std::vector<std::byte> encode_array(const Encoding& encoding, const Block& block);

/// The header line of a CSV file, "I0,Q0,I1,Q1,..." with a line feed.
[[nodiscard]] std::string csv_header(std::size_t columns);

}  // namespace sarsim::raster
