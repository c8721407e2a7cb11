#include "picture/colour/decibel_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace sarsim::picture::decibel_levels_test {

namespace {

constexpr std::size_t levels = 256;

TEST(DecibelLevels, AreThoseOfLogarithms) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anything_db(-90.0, 10.0);
  for (const float reference : {1.0F, 3.7e-9F, 2.5e12F})
    for (const ColourLimits& limits : {ColourLimits{-50.0, 0.0}, ColourLimits{-3.0, 0.0}, ColourLimits{-200.0, 20.0}}) {
      const DecibelLevels fast(reference, limits, levels);
      for (int k = 0; k < 20'000; ++k) {
        const auto magnitude =
            static_cast<float>(static_cast<double>(reference) * std::pow(10.0, anything_db(random) / 20.0));
        const auto index = [&](double factor) {
          const double db = 20.0 * std::log10(factor * static_cast<double>(magnitude) / static_cast<double>(reference));
          return colour_index(db, limits, levels);
        };
        // A rounding of the magnitude may lead over the edge of a level.
        ASSERT_GE(fast(magnitude), index(1.0 - 1e-6)) << magnitude;
        ASSERT_LE(fast(magnitude), index(1.0 + 1e-6)) << magnitude;
      }
    }
}

TEST(DecibelLevels, EndWithTheTable) {
  const DecibelLevels fast(1.0F, {-50.0, 0.0}, levels);
  EXPECT_EQ(fast(0.0F), 0U);
  EXPECT_EQ(fast(-1.0F), 0U);
  EXPECT_EQ(fast(std::numeric_limits<float>::denorm_min()), 0U);
  EXPECT_EQ(fast(std::numeric_limits<float>::quiet_NaN()), 0U);
  EXPECT_EQ(fast(1.0F), levels - 1);
  EXPECT_EQ(fast(std::numeric_limits<float>::max()), levels - 1);
  EXPECT_EQ(fast(std::numeric_limits<float>::infinity()), levels - 1);
}

TEST(DecibelLevels, OfNothingAreTheLowest) {
  for (const float reference : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(DecibelLevels(reference, {-50.0, 0.0}, levels)(1.0F), 0U);
  EXPECT_EQ(DecibelLevels(1.0F, {-50.0, 0.0}, 1)(1.0F), 0U);
  EXPECT_THROW(DecibelLevels(1.0F, {-50.0, 0.0}, 0), std::invalid_argument);
}

}  // namespace

}  // namespace sarsim::picture::decibel_levels_test
