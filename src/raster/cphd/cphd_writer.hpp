#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

#include "core/os/output_file.hpp"
#include "raster/cphd/block_file.hpp"
#include "raster/cphd/cphd_description.hpp"

namespace sarsim::raster {

/// A vector and its samples as bytes.
struct EncodedVector {
  std::vector<std::byte> pvp;
  std::vector<std::byte> signal;
};

/// Samples as bytes, and what a reader has to multiply integers by: the largest I or Q fills them. Floats and zeros
/// have the scale 1.
[[nodiscard]] std::pair<std::vector<std::byte>, double> encode_samples(std::span<const std::complex<double>> samples,
                                                                       SignalEncoding encoding);

/// Encodes samples, of integers scaled so that the largest I or Q of the vector fills them; sets `vector.amplitude`
/// then. A vector of zeros has the scale 1.
[[nodiscard]] EncodedVector encode_vector(PhaseVector vector, std::span<const std::complex<double>> samples,
                                          SignalEncoding encoding);

/// Writes a CPHD file of one channel, vector by vector (docs/formats/cphd.md). The file appears under its name with
/// `finish`; destroyed before, it leaves nothing. Memory does not grow with the number of vectors; the same input gives
/// the same bytes.
class CphdWriter {
 public:
  /// Begins the file. Sizes and offsets of the description's channel are filled in. std::system_error where the file
  /// cannot be made, or is a pipe.
  CphdWriter(const std::filesystem::path& path, CphdDescription description, bool replace);

  /// Adds the next vector; std::logic_error where it has another size or there are too many.
  void append(const EncodedVector& vector);
  /// Gives the file its name; std::logic_error where vectors are missing.
  void finish();

 private:
  core::OutputFile file_;
  CphdDescription description_;
  FileBlock pvp_;
  FileBlock signal_;
  std::size_t signal_bytes_ = 0;  // of a vector
  std::size_t written_ = 0;
};

}  // namespace sarsim::raster
