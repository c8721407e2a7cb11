#include "radar/motion/sea.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace sea_test {

constexpr Sea state_5{3.25, 9.7};

core::RandomStream stream(std::uint64_t seed = 1) { return {seed, core::RandomKind::position_envelope, 7}; }

// Integral of w^n S by the midpoint rule up to 40 times the peak; the tail of S falls as w^-5.
double moment(const Sea& sea, int n, double from_rad_per_s, double to_rad_per_s) {
  constexpr int panels = 200'000;
  const double step = (to_rad_per_s - from_rad_per_s) / panels;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double w = from_rad_per_s + (i + 0.5) * step;
    sum += std::pow(w, n) * wave_spectrum(sea, w) * step;
  }
  return sum;
}

TEST(SeaOfState, LiesWithinTheBandsOfTheCode) {
  constexpr double upper[] = {0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0};  // WMO 3700
  for (int state = 2; state <= 8; ++state) {
    const auto sea = sea_of_state(state);
    ASSERT_TRUE(sea.has_value());
    EXPECT_GT(sea->significant_height_m, upper[state - 1]);
    EXPECT_LT(sea->significant_height_m, upper[state]);
    EXPECT_GE(sea->peak_period_s, sea_of_state(state - 1)->peak_period_s);
  }
  EXPECT_EQ(sea_of_state(5)->significant_height_m, 3.25);
  EXPECT_FALSE(sea_of_state(9).has_value());
  EXPECT_FALSE(sea_of_state(-1).has_value());
}

TEST(WaveSpectrum, HoldsTheVariance) {
  EXPECT_NEAR(wave_variance_m2(state_5), 0.66016, 5e-6);
  const double peak = 2.0 * core::pi / 9.7;
  EXPECT_NEAR(moment(state_5, 0, 0.0, 40.0 * peak), 0.66016, 1e-5);
  EXPECT_NEAR(4.0 * std::sqrt(wave_variance_m2(state_5)), 3.25, 1e-12);
  EXPECT_EQ(wave_spectrum(state_5, 0.0), 0.0);
}

TEST(WaveSpectrum, PeaksAtItsPeriod) {
  const double peak = 2.0 * core::pi / 9.7;
  for (const double factor : {0.99, 1.01})
    EXPECT_LT(wave_spectrum(state_5, factor * peak), wave_spectrum(state_5, peak));
}

// m2 converges as 1/w^2: 40 peaks leave 1/1600 * 1.25/sqrt(1.25 pi) of it.
TEST(WaveSpectrum, HasTheMeanPeriodOfTheRule) {
  const double peak = 2.0 * core::pi / 9.7;
  const double m0 = moment(state_5, 0, 0.0, 40.0 * peak), m2 = moment(state_5, 2, 0.0, 40.0 * peak);
  EXPECT_NEAR(zero_crossing_period_s(state_5), 2.0 * core::pi * std::sqrt(m0 / m2), 5e-3);
  EXPECT_NEAR(zero_crossing_period_s(state_5) / 9.7, 0.71, 5e-4);
}

TEST(FrequencyOfShare, CutsTheVariance) {
  for (const double share : {0.05, 0.3, 0.8})
    EXPECT_NEAR(moment(state_5, 0, 0.0, frequency_of_share_rad_per_s(state_5, share)),
                share * wave_variance_m2(state_5), 1e-6);
}

TEST(WavesOf, ShareTheSpectrumOut) {
  const auto waves = waves_of(state_5, 30, stream());
  ASSERT_EQ(waves.size(), 30U);
  for (std::size_t i = 0; i < waves.size(); ++i) {
    EXPECT_GT(waves[i].frequency_rad_per_s, frequency_of_share_rad_per_s(state_5, waves[i].from_share + 1e-12));
    EXPECT_LT(waves[i].frequency_rad_per_s, frequency_of_share_rad_per_s(state_5, waves[i].to_share - 1e-12));
    EXPECT_NEAR(waves[i].to_share - waves[i].from_share, 1.0 / 30.0, 1e-15);
  }
  EXPECT_EQ(waves.back().to_share, 1.0);
}

TEST(WavesOf, AreTheSameForTheSameStream) {
  const auto a = waves_of(state_5, 20, stream()), b = waves_of(state_5, 20, stream()),
             c = waves_of(state_5, 20, stream(2));
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].phase_rad, b[i].phase_rad);
    EXPECT_EQ(a[i].frequency_rad_per_s, b[i].frequency_rad_per_s);
    EXPECT_NE(a[i].phase_rad, c[i].phase_rad);
  }
}

}  // namespace sea_test
}  // namespace sarsim::radar
