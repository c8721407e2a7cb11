#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "simulate/plan/sink.hpp"

namespace sarsim::raster {

/// How the rows of a recording become bytes.
struct Encoding {
  scene::FileFormat format = scene::FileFormat::binary;
  bool counts = true;  ///< Integer counts rather than volts; text and BINARY are always counts.
  int bits = 8;        ///< Of the A/D converter, 1 to 64.
  bool minus_zero =
      false;  ///< ASCII and BRACKET write "-0" for a negative component that rounds to 0 (classic profile).
};

/// Bytes of a component (I or Q) in the formats of fixed size: BINARY ceil(bits/8); HDF5 and NPY 4 (float32 or int32)
/// or, for counts of more than 31 bits, 8. Zero for text.
[[nodiscard]] std::size_t component_bytes(const Encoding& encoding);

/// The bytes of a block as docs/formats/samples.md lays them out. Text: about 300 MB/s or more on one core. Throws
/// std::invalid_argument where the block's spans have not the size that its shape asks for, and std::out_of_range for
/// a count outside the converter's range. May run on many threads at once.
[[nodiscard]] std::vector<std::byte> encode_rows(const Encoding& encoding, const simulate::Block& block);

/// The header line of a CSV file, "I0,Q0,I1,Q1,..." with a line feed.
[[nodiscard]] std::string csv_header(std::size_t columns);

}  // namespace sarsim::raster
