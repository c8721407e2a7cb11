#pragma once

#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "signal/compress/range_compression.hpp"
#include "simulate/plan/acquisition.hpp"

namespace sarsim::simulate {

/// The matched filter of a plan's pulse, whose output begins at the first sample of the echo.
/// @param window       weights of the filter
/// @param raw_samples  of a row
/// @param samples      of them that are wanted compressed
[[nodiscard]] std::shared_ptr<const signal::RangeCompressor> compressor_of(const Acquisition& acquisition,
                                                                           const signal::WindowFunction& window,
                                                                           std::size_t raw_samples,
                                                                           std::size_t samples);

/// Room to compress rows in; one for each thread, used again.
struct RowSpace {
  std::vector<std::complex<double>> raw;  ///< What is compressed.
  std::vector<std::complex<double>> compressed;
  std::vector<std::complex<double>> scratch;

  /// Compresses `raw` into `out`, at most as long as the compressor's output.
  void compress(const signal::RangeCompressor& compressor, std::span<std::complex<float>> out);
};

/// Copies as many samples as `to` holds, each part rounded to the nearest float.
void to_float(std::span<const std::complex<double>> from, std::span<std::complex<float>> to);

}  // namespace sarsim::simulate
