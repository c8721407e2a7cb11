#include "radar/receiver/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radar/simd/simd_test_support.hpp"

namespace sarsim::radar {
namespace noise_test {

using Row = std::vector<std::complex<double>>;
constexpr std::size_t count = 100'000;
constexpr double stddev_v = 3.0;

core::RandomStream stream(std::uint64_t seed = 1) {
  return {seed, core::RandomKind::receiver_noise, core::name_key("Radar1")};
}

Row noise(std::int64_t pulse, std::int64_t first_sample, std::size_t size, std::uint64_t seed = 1) {
  Row row(size);
  add_noise(row, stddev_v, stream(seed), pulse, first_sample);
  return row;
}

// Mean of a conj(b) over the variance; for independent noises its parts have standard deviation sqrt(2/n).
std::complex<double> correlation(const Row& a, const Row& b, std::size_t lag) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i + lag < a.size(); ++i) sum += a[i] * std::conj(b[i + lag]);
  return sum / (static_cast<double>(a.size()) * stddev_v * stddev_v);
}

TEST(AddNoise, HasTheGivenVarianceInIAndInQ) {
  const Row row = noise(3, -50'000, count);
  double i2 = 0.0, q2 = 0.0, iq = 0.0;
  std::complex<double> mean = 0.0;
  for (const auto& s : row) {
    mean += s;
    i2 += s.real() * s.real();
    q2 += s.imag() * s.imag();
    iq += s.real() * s.imag();
  }
  const double n = count, variance = stddev_v * stddev_v;
  EXPECT_NEAR(mean.real() / n, 0.0, 5.0 * stddev_v / std::sqrt(n));
  EXPECT_NEAR(mean.imag() / n, 0.0, 5.0 * stddev_v / std::sqrt(n));
  EXPECT_NEAR(i2 / n, variance, 5.0 * variance * std::sqrt(2.0 / n));
  EXPECT_NEAR(q2 / n, variance, 5.0 * variance * std::sqrt(2.0 / n));
  EXPECT_NEAR(iq / n, 0.0, 5.0 * variance / std::sqrt(n));
}

TEST(AddNoise, IsWhiteAlongARow) {
  const Row row = noise(0, 0, count);
  for (const std::size_t lag : {1u, 2u, 3u, 64u}) {
    EXPECT_NEAR(correlation(row, row, lag).real(), 0.0, 5.0 * std::sqrt(2.0 / count));
    EXPECT_NEAR(correlation(row, row, lag).imag(), 0.0, 5.0 * std::sqrt(2.0 / count));
  }
}

TEST(AddNoise, OfTwoPulsesOrSeedsIsIndependent) {
  const Row row = noise(0, 0, count);
  for (const Row& other : {noise(1, 0, count), noise(-1, 0, count), noise(0, 0, count, 2)})
    for (const std::size_t lag : {0u, 1u}) {
      EXPECT_NEAR(correlation(row, other, lag).real(), 0.0, 5.0 * std::sqrt(2.0 / count));
      EXPECT_NEAR(correlation(row, other, lag).imag(), 0.0, 5.0 * std::sqrt(2.0 / count));
    }
}

TEST(AddNoise, StaysWithItsSampleWhenTheWindowMoves) {
  const Row wide = noise(12, -10, 100);
  const Row part = noise(12, 25, 30);
  for (std::size_t i = 0; i < part.size(); ++i) EXPECT_EQ(part[i], wide[35 + i]);
}

// Of rows of any length, which end within a vector.
TEST(AddNoise, IsWhatTheStreamGivesForEachSample) {
  at_every_simd_level([] {
    for (const std::size_t size : {1u, 2u, 3u, 7u, 8u, 9u, 33u}) {
      const std::int64_t pulse = (std::int64_t{1} << 40) + 7;
      const std::int64_t first_sample = -5;
      const Row row = noise(pulse, first_sample, size);
      for (std::size_t i = 0; i < size; ++i) {
        const auto [a, b] = stream().normals(pulse, first_sample + static_cast<std::int64_t>(i));
        ASSERT_NEAR(row[i].real(), stddev_v * a, stddev_v * 2e-14) << size << ' ' << i;
        ASSERT_NEAR(row[i].imag(), stddev_v * b, stddev_v * 2e-14) << size << ' ' << i;
      }
    }
  });
}

TEST(AddNoise, AddsToWhatIsThereAndScalesWithTheStandardDeviation) {
  Row row(50, {1.0, 2.0});
  add_noise(row, 2.0 * stddev_v, stream(), 0, 0);
  const Row plain = noise(0, 0, 50);
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_LT(std::abs(row[i] - (std::complex(1.0, 2.0) + 2.0 * plain[i])), 1e-14);
}

TEST(AddNoise, OfNoDeviationLeavesTheRowAlone) {
  Row row(5, {1.0, 2.0});
  add_noise(row, 0.0, stream(), 0, 0);
  EXPECT_EQ(row, Row(5, {1.0, 2.0}));
}

}  // namespace noise_test
}  // namespace sarsim::radar
