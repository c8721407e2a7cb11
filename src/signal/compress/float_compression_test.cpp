#include "signal/compress/float_compression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace sarsim::signal {
namespace float_compression_test {

TEST(FloatCompressor, GivesWhatTheCompressorInDoublePrecisionGives) {
  CompressionFilter filter;
  for (int k = 0; k < 37; ++k) filter.taps.push_back(std::polar(1.0 / 37.0, 0.02 * k * k));
  constexpr std::size_t raw_count = 250;
  constexpr std::size_t count = 201;
  std::vector<std::complex<double>> raw(raw_count);
  for (std::size_t i = 0; i < raw_count; ++i) raw[i] = std::polar(1.0, 0.3 * static_cast<double>(i * i % 97));
  std::vector<std::size_t> index(count);
  std::iota(index.begin(), index.end(), std::size_t{0});
  const RangeCompressor exact(filter, raw_count, index);
  std::vector<std::complex<double>> expected(count);
  std::vector<std::complex<double>> exact_scratch(exact.scratch_size());
  exact.compress(raw, expected, exact_scratch);

  const FloatCompressor compressor(filter, raw_count, count);
  std::vector<std::complex<float>> out(count);
  std::vector<std::complex<float>> scratch(compressor.scratch_size(), {9.0F, 9.0F});
  compressor.compress(raw, out, scratch);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_NEAR(std::abs(std::complex<double>(out[i]) - expected[i]), 0.0, 1e-6) << i;
}

}  // namespace float_compression_test
}  // namespace sarsim::signal
