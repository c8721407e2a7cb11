#include "signal/stepped/velocity_search.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "core/maths/window.hpp"
#include "signal/stepped/profile_sets.hpp"
#include "signal/stepped/stepped_limits.hpp"
#include "signal/stepped/stepped_test_support.hpp"

namespace sarsim::signal {
namespace velocity_search_test {

using test::burst_echoes;
using test::moving_point;

constexpr double interval_s = 250e-6;
const core::WorkControl one{1, nullptr};

std::vector<test::SteppedPoint> aircraft(double range_m, double speed_mps) {
  return {moving_point(range_m, speed_mps), moving_point(range_m + 4.1, speed_mps, 0.6),
          moving_point(range_m + 9.7, speed_mps, 0.8), moving_point(range_m - 5.3, speed_mps, 0.4)};
}

TEST(EstimateVelocity, FindsTheSpeedOfOneBurstByItsSmear) {
  const SteppedBand band(test::sampled_waveform(2940.0, 12));
  const ProfileMaker maker(band, core::hamming_window, 2950.0, 3100.0, 4);
  const double tolerable = limits_of(band, interval_s).tolerable_mps;
  for (const double v : {0.0, 212.3, -97.0}) {
    const BurstEchoes echoes = burst_echoes(band, nullptr, aircraft(3020.0, v), 0.0, interval_s);
    const VelocityEstimate estimate = estimate_velocity(maker, echoes, -400.0, 400.0, one);
    // Half a cell of smear is what needs no compensation.
    EXPECT_NEAR(estimate.speed_mps, v, tolerable) << v;
    EXPECT_LE(estimate.entropy, estimate.entropy_at_rest + 1e-6);
  }
}

TEST(EstimateVelocity, FindsTheSpeedOfManyBurstsByTheirWalk) {
  const SteppedBand band(test::sampled_waveform(2940.0, 12));
  const ProfileMaker maker(band, core::hamming_window, 2950.0, 3100.0, 4);
  const double v = -153.7;
  const BurstEchoes echoes = burst_echoes(band, nullptr, aircraft(3020.0, v), 0.0, interval_s, 12);
  const VelocityEstimate estimate = estimate_velocity(maker, echoes, -400.0, 400.0, one);
  // 0.19 s: a tenth of a cell (0.47 m) of walk is 0.25 m/s, where one burst alone gives a few m/s.
  EXPECT_NEAR(estimate.speed_mps, v, 0.25);
  EXPECT_LT(estimate.entropy, estimate.entropy_at_rest - 0.5);
  EXPECT_LT(estimate.uncertainty_mps, 1.0);
  const VelocityEstimate again = estimate_velocity(maker, echoes, -400.0, 400.0, {3, nullptr});
  EXPECT_EQ(again.speed_mps, estimate.speed_mps);
}

// Twelve steps last 2.75 ms: their smear tells 227 m/s apart at best, and more than one speed looks sharp at first.
TEST(EstimateVelocity, FindsTheSpeedWhereOneBurstDoesNotTellIt) {
  SteppedWaveform w = test::sampled_waveform(2940.0, 12);
  w.steps = 12;
  const SteppedBand band(w);
  const ProfileMaker maker(band, core::hamming_window, 2950.0, 3100.0, 4);
  for (const double v : {-153.7, 12.0, 333.0, 421.0}) {
    const BurstEchoes echoes = burst_echoes(band, nullptr, aircraft(3020.0, v), 0.0, interval_s, 40);
    EXPECT_NEAR(estimate_velocity(maker, echoes, -500.0, 500.0, one).speed_mps, v, 2.0) << v;
  }
}

// Noise as strong as the weakest part in every sample of every gate, also of those that hold nothing else.
TEST(EstimateVelocity, WorksInNoise) {
  const SteppedBand band(test::sampled_waveform(2500.0, 60));
  const ProfileMaker maker(band, core::hamming_window, 2510.0, 3390.0, 4);
  const double v = -153.7;
  BurstEchoes echoes = burst_echoes(band, nullptr, aircraft(3020.0, v), 0.0, interval_s, 12);
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.4 / std::sqrt(2.0));
  for (auto& value : echoes.values) value += std::complex<double>(normal(random), normal(random));
  EXPECT_NEAR(estimate_velocity(maker, echoes, -400.0, 400.0, one).speed_mps, v, 0.5);
}

TEST(EstimateVelocity, EndsAtTheEdgeOfItsInterval) {
  const SteppedBand band(test::sampled_waveform(2940.0, 12));
  const ProfileMaker maker(band, core::hamming_window, 2950.0, 3100.0, 4);
  const BurstEchoes echoes = burst_echoes(band, nullptr, aircraft(3020.0, 60.0), 0.0, interval_s);
  EXPECT_LE(estimate_velocity(maker, echoes, -40.0, 40.0, one).speed_mps, 40.0);
}

TEST(EstimateVelocity, RefusesEchoesOfPartsOfBurstsAndEmptyIntervals) {
  const SteppedBand band(test::sampled_waveform(3000.0, 2));
  const ProfileMaker maker(band, {}, 3000.0, 3010.0, 2);
  BurstEchoes echoes = burst_echoes(band, nullptr, {moving_point(3005.0, 0.0)}, 0.0, interval_s);
  EXPECT_THROW((void)estimate_velocity(maker, echoes, 5.0, 5.0, one), std::invalid_argument);
  echoes.values.pop_back();
  EXPECT_THROW((void)estimate_velocity(maker, echoes, -5.0, 5.0, one), std::invalid_argument);
  EXPECT_THROW((void)estimate_velocity(maker, {}, -5.0, 5.0, one), std::invalid_argument);
}

TEST(EstimateVelocity, RefusesIntervalsOfTooManySpeeds) {
  const SteppedBand band(test::sampled_waveform(3000.0, 2));
  const ProfileMaker maker(band, {}, 3000.0, 3010.0, 2);
  const BurstEchoes echoes = burst_echoes(band, nullptr, {moving_point(3005.0, 0.0)}, 0.0, interval_s);
  // c/(8 B) over the burst.
  const double span_s = echoes.time_s.back() - echoes.time_s.front();
  const double step_mps = first_speed_step_mps(band, span_s);
  EXPECT_NEAR(step_mps, core::exact_light_speed_mps / (8.0 * band.band_hz()) / span_s, 1e-9);
  const double max_mps = 0.5 * max_searched_speeds * step_mps;
  EXPECT_THROW((void)estimate_velocity(maker, echoes, -1.01 * max_mps, 1.01 * max_mps, one), std::invalid_argument);
}

TEST(EstimateVelocity, EndsWhenAskedTo) {
  const SteppedBand band(test::sampled_waveform(3000.0, 2));
  const ProfileMaker maker(band, {}, 3000.0, 3010.0, 2);
  const BurstEchoes echoes = burst_echoes(band, nullptr, {moving_point(3005.0, 0.0)}, 0.0, interval_s);
  core::StopFlag stop;
  stop.request();
  EXPECT_THROW((void)estimate_velocity(maker, echoes, -5.0, 5.0, {2, &stop}), core::Interrupted);
}

TEST(ScansOf, AreRunsOfIlluminatedBursts) {
  const auto scans = scans_of(std::vector<double>{0.1, 0.3, 1.0, 0.25, 0.2, 0.9, 0.24}, 0.25);
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_EQ(scans[0].first, 1u);
  EXPECT_EQ(scans[0].last, 3u);
  EXPECT_EQ(scans[0].count(), 3u);
  EXPECT_EQ(scans[1].first, 5u);
  EXPECT_EQ(scans[1].last, 5u);
  EXPECT_TRUE(scans_of(std::vector<double>(3), 0.5).empty());
  EXPECT_TRUE(scans_of({}, 0.5).empty());
  EXPECT_EQ(scans_of(std::vector<double>(5, 2.0), 1.0).size(), 1u);
}

TEST(MeanProfile, IsTheRootMeanSquareOfTheMagnitudes) {
  const std::vector<std::complex<double>> profiles{{3.0, 0.0}, {0.0, 1.0}, {0.0, -4.0}, {7.0, 0.0}};
  const auto mean = mean_profile(profiles, 2);
  EXPECT_NEAR(mean[0].real(), std::sqrt(12.5), 1e-12);
  EXPECT_NEAR(mean[1].real(), 5.0, 1e-12);
  EXPECT_EQ(mean_profile({}, 3), std::vector<std::complex<double>>(3));
}

TEST(ShiftOnto, IsByHowManyBinsAProfileIsEarlier) {
  std::vector<std::complex<double>> here(50), there(50);
  for (const auto& [bin, value] : {std::pair{10, 1.0}, {13, 0.4}, {19, -0.7}}) {
    here[static_cast<std::size_t>(bin)] = {0.0, value};
    there[static_cast<std::size_t>(bin) + 17] = 3.0 * value;
  }
  EXPECT_EQ(shift_onto(here, there), 17);
  EXPECT_EQ(shift_onto(there, here), -17);
  EXPECT_EQ(shift_onto(here, here), 0);
  EXPECT_EQ(shift_onto({}, {}), 0);
  EXPECT_THROW((void)shift_onto(here, {}), std::invalid_argument);
}

}  // namespace velocity_search_test
}  // namespace sarsim::signal
