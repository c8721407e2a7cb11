#include "signal/stepped/profile_maker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/maths/window.hpp"
#include "signal/stepped/range_profile.hpp"
#include "signal/stepped/stepped_limits.hpp"
#include "signal/stepped/stepped_test_support.hpp"

namespace sarsim::signal {
namespace profile_maker_test {

using test::burst_echoes;
using test::moving_point;

constexpr double c = core::exact_light_speed_mps;
constexpr double interval_s = 250e-6;
constexpr double cell_m = c / (2.0 * 64 * 5e6);
using Row = std::vector<std::complex<double>>;

Row profile_of(const ProfileMaker& maker, const BurstEchoes& echoes, const std::vector<PulseMotion>& motion = {}) {
  Row row(maker.axis().count);
  maker.make(echoes.values, motion, row);
  return row;
}

ProfilePeak peak_of(const ProfileMaker& maker, const Row& row, double near_m, double search_m) {
  return peak_near(row, maker.axis(), near_m, search_m).value();
}

double phase_at(double hz, double range_m) { return -2.0 * core::pi * std::remainder(2.0 * hz * range_m / c, 1.0); }

TEST(ProfileMaker, ShowsARestingTargetAtItsRangeWithItsAmplitudeAndItsPhaseAtTheMiddleOfTheBand) {
  const SteppedBand band(test::sampled_waveform(2970.0, 8));
  const ProfileMaker maker(band, {}, 2980.0, 3060.0, 16);
  EXPECT_NEAR(band.centre_hz(), 9e9 + 31.5 * 5e6, 1e-3);
  EXPECT_NEAR(band.band_hz(), 320e6, 1e-3);
  for (const double range_m : {2991.3, 3010.0, 3033.77}) {
    const Row row = profile_of(maker, burst_echoes(band, nullptr, {moving_point(range_m, 0.0, 3.0)}, 0.0, interval_s));
    const ProfilePeak peak = peak_of(maker, row, range_m, 2.0 * cell_m);
    EXPECT_NEAR(peak.range_m, range_m, 0.002 * cell_m);
    EXPECT_NEAR(peak.amplitude, 3.0, 1e-3);
    EXPECT_NEAR(std::remainder(peak.phase_rad - phase_at(band.centre_hz(), range_m), 2.0 * core::pi), 0.0, 1e-6);
    // The -3 dB width of an evenly filled band: 0.886 c/(2 B).
    EXPECT_NEAR(peak.width_m, 0.886 * cell_m, 0.003 * cell_m);
  }
}

TEST(ProfileMaker, IsTheProfileOfASingleGateThere) {
  const SteppedBand band(test::sampled_waveform(3000.0, 1));
  const ProfileMaker maker(band, core::hamming_window, 3000.0, 3005.0, 1);
  const BurstEchoes echoes = burst_echoes(band, nullptr, {moving_point(3002.0, 0.0)}, 0.0, interval_s);
  const Row row = profile_of(maker, echoes);
  const RangeProfiler profiler({3000.0}, 64, 5e6, core::hamming_window, c);
  Row bins(64);
  profiler.profile(echoes.values, bins);
  for (std::size_t k = 0; k < row.size(); ++k) EXPECT_NEAR(std::abs(row[k]), std::abs(bins[k]), 1e-9) << k;
}

TEST(ProfileMaker, KeepsTargetsApartThatLieAWholeAmbiguityFromEachOther) {
  const SteppedBand band(test::sampled_waveform(2970.0, 12));
  const ProfileMaker maker(band, core::hamming_window, 2980.0, 3100.0, 8);
  const double away_m = c / (2.0 * 5e6);
  const Row row = profile_of(
      maker, burst_echoes(band, nullptr, {moving_point(3000.0, 0.0), moving_point(3000.0 + 2.0 * away_m, 0.0, 0.5)},
                          0.0, interval_s));
  EXPECT_NEAR(peak_of(maker, row, 3000.0, 1.0).amplitude, 1.0, 1e-3);
  EXPECT_NEAR(peak_of(maker, row, 3000.0 + 2.0 * away_m, 1.0).amplitude, 0.5, 1e-3);
  const auto between = static_cast<std::size_t>(maker.axis().index_of(3000.0 + away_m));
  EXPECT_LT(std::abs(row[between]), 1e-6);
}

TEST(ProfileMaker, IsSilentWhereNoGateHoldsAnEcho) {
  const SteppedBand band(test::sampled_waveform(3000.0, 2));
  const ProfileMaker maker(band, {}, 2900.0, 3100.0, 16);
  const Row row = profile_of(maker, burst_echoes(band, nullptr, {moving_point(3005.0, 0.0)}, 0.0, interval_s));
  EXPECT_EQ(row[static_cast<std::size_t>(maker.axis().index_of(2980.0))], 0.0);
  EXPECT_EQ(row[static_cast<std::size_t>(maker.axis().index_of(3040.0))], 0.0);
  EXPECT_NEAR(peak_of(maker, row, 3005.0, 1.0).amplitude, 1.0, 1e-3);
}

TEST(ProfileMaker, TakesStepsDownwardsToo) {
  SteppedWaveform w = test::sampled_waveform(2985.0, 4);
  w.first_carrier_hz = 9.315e9;
  w.carrier_step_hz = -5e6;
  const SteppedBand band(w);
  EXPECT_NEAR(band.frequency_hz(0), 9e9, 1e-3);
  const ProfileMaker maker(band, {}, 2990.0, 3020.0, 8);
  const Row row = profile_of(maker, burst_echoes(band, nullptr, {moving_point(3004.4, 0.0)}, 0.0, interval_s));
  EXPECT_NEAR(peak_of(maker, row, 3004.4, 1.0).range_m, 3004.4, 0.002 * cell_m);
}

TEST(ProfileMaker, AveragesThePulsesOfAStep) {
  const SteppedBand band(test::sampled_waveform(2985.0, 4, 3));
  const ProfileMaker maker(band, {}, 2990.0, 3020.0, 8);
  const Row row = profile_of(maker, burst_echoes(band, nullptr, {moving_point(3004.4, 0.0, 2.0)}, 0.0, interval_s));
  EXPECT_NEAR(peak_of(maker, row, 3004.4, 1.0).amplitude, 2.0, 1e-3);
}

// The closed forms of a target of constant speed: shift f T/df v from where it is in the middle of the burst, smear
// 2 (S - 1) T v.
TEST(ProfileMaker, ShiftsAMovingTargetByCarrierOverStepAndSmearsItByTwiceItsWay) {
  const SteppedBand band(test::sampled_waveform(2970.0, 8));
  const SteppedLimits limits = limits_of(band, interval_s);
  EXPECT_NEAR(limits.shift_m_per_mps, (9e9 + 31.5 * 5e6) * interval_s / 5e6, 1e-9);
  EXPECT_NEAR(limits.smear_m_per_mps, 2.0 * 63 * interval_s, 1e-12);
  EXPECT_NEAR(limits.resolution_m, cell_m, 1e-9);
  EXPECT_NEAR(limits.unambiguous_range_m, c / 10e6, 1e-9);
  EXPECT_NEAR(limits.ambiguous_mps, limits.unambiguous_range_m / limits.shift_m_per_mps, 1e-9);
  const ProfileMaker maker(band, {}, 2980.0, 3060.0, 16);
  for (const double v : {5.0, -8.0}) {
    const double middle_m = 3020.0;
    const double start_s = -31.5 * interval_s;
    const Row row = profile_of(maker, burst_echoes(band, nullptr, {moving_point(middle_m, v)}, start_s, interval_s));
    const double expected_m = middle_m + limits.shift_m(v);
    EXPECT_NEAR(peak_of(maker, row, expected_m, cell_m).range_m, expected_m, 0.02 * cell_m) << v;
    EXPECT_LT(limits.smear_cells(v), 0.6);
  }
  // A smear of twelve cells shows as the width of what lies above half of its mean power.
  const double v = 12.0 * cell_m / limits.smear_m_per_mps;
  EXPECT_NEAR(limits.smear_cells(v), 12.0, 1e-9);
  const BurstEchoes fast = burst_echoes(band, nullptr, {moving_point(3030.0, v)}, -31.5 * interval_s, interval_s);
  std::vector<double> power(maker.period());
  maker.add_power(fast.values, {}, power);
  double energy = 0.0, largest = 0.0;
  for (const double p : power) energy += p, largest = std::max(largest, p);
  std::size_t wide = 0;
  for (const double p : power)
    if (p > 0.25 * largest) ++wide;
  EXPECT_NEAR(static_cast<double>(wide) * maker.axis().step_m, 12.0 * cell_m, 2.0 * cell_m);
}

TEST(ProfileMaker, RestoresWidthPlaceAndAmplitudeOfATargetWhoseSpeedIsTakenOut) {
  const SteppedBand band(test::sampled_waveform(2970.0, 8, 2));
  const ProfileMaker maker(band, {}, 2980.0, 3060.0, 16);
  for (const double v : {310.0, -240.0}) {
    const BurstEchoes echoes = burst_echoes(band, nullptr, {moving_point(3020.0, v)}, 0.0, interval_s);
    const double middle_s = middle_of(echoes.time_s);
    const Row row = profile_of(maker, echoes, motion_of_speed(echoes.time_s, middle_s, v, c));
    const double expected_m = (3020.0 + v * middle_s) / (1.0 - v / c);
    const ProfilePeak peak = peak_of(maker, row, expected_m, cell_m);
    EXPECT_NEAR(peak.range_m, expected_m, 0.002 * cell_m);
    EXPECT_NEAR(peak.width_m, 0.886 * cell_m, 0.003 * cell_m);
    EXPECT_NEAR(peak.amplitude, 1.0, 1e-3);
    // The same burst, shown where the target is at another time.
    const Row later = profile_of(maker, echoes, motion_of_speed(echoes.time_s, middle_s + 0.02, v, c));
    EXPECT_NEAR(peak_of(maker, later, expected_m + 0.02 * v, cell_m).range_m, expected_m + 0.02 * v, 0.002 * cell_m);
  }
}

TEST(PeakNear, FindsNothingAtTheEdgeOfItsStretch) {
  const Row row{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_FALSE(peak_near(row, {0.0, 1.0, 6}, 2.5, 1.0));
  EXPECT_FALSE(peak_near(row, {0.0, 1.0, 6}, 100.0, 1.0));
}

TEST(HighestPeaks, AreStrongestFirstAndKeepTheirDistance) {
  const Row row{0.0, 2.0, 0.0, 3.0, 0.0, 1.0, 0.0, 0.1, 0.0};
  const auto peaks = highest_peaks(row, {0.0, 1.0, row.size()}, 10, 2.5, 0.2);
  ASSERT_EQ(peaks.size(), 1u);  // Those at 1 and 5 are nearer than 2.5, that at 7 is too weak.
  EXPECT_NEAR(peaks[0].range_m, 3.0, 0.2);
  EXPECT_EQ(highest_peaks(row, {0.0, 1.0, row.size()}, 2, 1.0, 0.2).size(), 2u);
}

TEST(EntropyOf, IsTheLogarithmOfTheNumberOfEqualBins) {
  EXPECT_NEAR(entropy_of(std::vector<double>(40, 2.5)), std::log(40.0), 1e-12);
  EXPECT_NEAR(entropy_of(std::vector<double>{0.0, 7.0, 0.0}), 0.0, 1e-12);
  EXPECT_EQ(entropy_of(std::vector<double>(3)), 0.0);
}

TEST(ProfileMaker, RefusesWhatMakesNoProfile) {
  const SteppedBand band(test::sampled_waveform(3000.0, 1));
  EXPECT_THROW(ProfileMaker(band, {}, 3000.0, 2999.0, 1), std::invalid_argument);
  EXPECT_THROW(ProfileMaker(band, {}, 3000.0, 3001.0, 0), std::invalid_argument);
}

}  // namespace profile_maker_test
}  // namespace sarsim::signal
