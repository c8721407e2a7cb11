#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/maths/fft.hpp"
#include "signal/compress/range_compression.hpp"

namespace sarsim::signal {

/// Applies a filter to rows of one length by fast convolution, as RangeCompressor does, in single precision: within
/// 1e-6 of the largest sample.
class FloatCompressor {
 public:
  /// @param input_count   samples of a raw row
  /// @param output_count  of the samples that are wanted, from the first one on; at most input_count
  FloatCompressor(const CompressionFilter& filter, std::size_t input_count, std::size_t output_count);

  [[nodiscard]] std::size_t input_count() const { return input_count_; }
  [[nodiscard]] std::size_t output_count() const { return output_count_; }
  /// Length of the scratch space that `compress` needs.
  [[nodiscard]] std::size_t scratch_size() const { return fft_.size(); }

  /// @param raw      input_count samples; samples beyond them count as 0
  /// @param[out] out output_count samples
  /// @param scratch  scratch_size values, overwritten
  void compress(std::span<const std::complex<double>> raw, std::span<std::complex<float>> out,
                std::span<std::complex<float>> scratch) const;

 private:
  std::size_t input_count_;
  std::size_t output_count_;
  core::BasicFft<float> fft_;
  std::vector<std::complex<float>> response_;
};

}  // namespace sarsim::signal
