#include "signal/compress/float_compression.hpp"

#include <algorithm>

#include "core/report/expect.hpp"
#include "signal/row/row_kernels.hpp"

namespace sarsim::signal {

FloatCompressor::FloatCompressor(const CompressionFilter& filter, std::size_t input_count, std::size_t output_count)
    : input_count_(input_count),
      output_count_(output_count),
      fft_(core::fast_fft_size(input_count + filter.taps.size())) {
  CORE_EXPECT(!filter.taps.empty());
  CORE_EXPECT(input_count > 0);
  CORE_EXPECT(output_count <= input_count);
  // Correlation: multiply by the transform of the filter run backwards in time.
  const std::size_t size = fft_.size();
  const core::Fft exact(size);
  std::vector<std::complex<double>> response(size);
  const double scale = 1.0 / static_cast<double>(size);
  for (std::size_t k = 0; k < filter.taps.size(); ++k) response[(size - k) % size] = scale * filter.taps[k];
  exact.forward(response);
  response_.assign(response.begin(), response.end());
}

void FloatCompressor::compress(std::span<const std::complex<double>> raw, std::span<std::complex<float>> out,
                               std::span<std::complex<float>> scratch) const {
  CORE_EXPECT(raw.size() == input_count_);
  CORE_EXPECT(out.size() == output_count_);
  CORE_EXPECT(scratch.size() >= scratch_size());
  const auto work = scratch.first(scratch_size());
  for (std::size_t n = 0; n < raw.size(); ++n) work[n] = std::complex<float>(raw[n]);
  std::fill(work.begin() + static_cast<std::ptrdiff_t>(raw.size()), work.end(), std::complex<float>());
  fft_.forward(work);
  multiply_row(work, response_);
  fft_.inverse(work);
  std::copy_n(work.begin(), out.size(), out.begin());
}

}  // namespace sarsim::signal
