#include "core/maths/upsample.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::core {
namespace upsample_test {

using Samples = std::vector<std::complex<double>>;

// Two tones of whole cycles in `count` samples, seen `per_sample` times as finely.
Samples tones(std::size_t count, std::size_t per_sample, double first, double second) {
  Samples samples;
  for (std::size_t i = 0; i < count * per_sample; ++i) {
    const double x = 2.0 * pi * static_cast<double>(i) / static_cast<double>(count * per_sample);
    samples.push_back(std::polar(1.0, first * x) + std::polar(0.5, second * x + 0.3));
  }
  return samples;
}

void expect_same(const Samples& found, const Samples& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(std::abs(found[i] - wanted[i]), 0.0, 1e-12) << i;
}

TEST(UpsampledSamples, AreThoseOfTheSameTones) {
  expect_same(upsample(tones(16, 1, 3.0, -7.0), 0.0, 4), tones(16, 4, 3.0, -7.0));
  expect_same(upsample(tones(15, 1, 7.0, -7.0), 0.0, 3), tones(15, 3, 7.0, -7.0));
}

TEST(UpsampledSamples, FollowABandThatIsNotAboutZero) {
  // Twelve and eighteen cycles in sixteen samples: the band is about fifteen.
  expect_same(upsample(tones(16, 1, 12.0, 18.0), 15.0 / 16.0, 8), tones(16, 8, 12.0, 18.0));
}

TEST(UpsampledSamples, HaveTheGivenOnesAmongThem) {
  const Samples samples{{1.0, 2.0}, {-3.0, 0.5}, {0.0, 0.0}, {4.0, -1.0}, {2.0, 2.0}, {0.1, 0.2}};
  const Samples fine = upsample(samples, 0.21, 5);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_NEAR(std::abs(fine[5 * i] - samples[i]), 0.0, 1e-12) << i;
}

TEST(UpsampledSamples, OfFactorOneAreTheSame) {
  const Samples samples{{1.0, 2.0}, {-3.0, 0.5}, {4.0, -1.0}, {0.5, 0.0}};
  expect_same(upsample(samples, 0.1, 1), samples);
  EXPECT_TRUE(upsample(Samples(), 0.0, 4).empty());
  expect_same(upsample(Samples{{2.0, 1.0}}, 0.0, 3), Samples(3, {2.0, 1.0}));
}

}  // namespace upsample_test
}  // namespace sarsim::core
