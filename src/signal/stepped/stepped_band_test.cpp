#include "signal/stepped/stepped_band.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/maths/window.hpp"
#include "signal/stepped/profile_maker.hpp"
#include "signal/stepped/stepped_test_support.hpp"

namespace sarsim::signal {
namespace stepped_band_test {

using test::burst_echoes;
using test::moving_point;

constexpr double c = core::exact_light_speed_mps;
constexpr double interval_s = 200e-6;
using Row = std::vector<std::complex<double>>;

Row profile_of(const SteppedBand& band, const BurstEchoes& echoes, const std::vector<PulseMotion>& motion,
               double from_m, double to_m, ProfileAxis& axis) {
  const ProfileMaker maker(band, core::hamming_window, from_m, to_m, 8);
  axis = maker.axis();
  Row row(axis.count);
  maker.make(echoes.values, motion, row);
  return row;
}

// Eight chirps of 12 MHz, 10 MHz apart: 82 MHz about 9.035 GHz.
struct Stitched {
  radar::Pulse pulse = test::chirp_of(12e6, 10e-6);
  SteppedBand band{test::chirped_waveform(pulse, 9e9, 10e6, 8, 20e6, 2900.0, 64)};
};

TEST(SteppedBand, OfChirpsReachesFromTheFirstSubBandToTheLast) {
  const Stitched s;
  EXPECT_NEAR(s.band.frequency_hz(0), 9e9 - 6e6, s.band.cell_hz());
  EXPECT_NEAR(s.band.band_hz(), 82e6, 2.0 * s.band.cell_hz());
  EXPECT_NEAR(s.band.centre_hz(), 9.035e9, s.band.cell_hz());
  EXPECT_EQ(s.band.gap_share(), 0.0);
  EXPECT_EQ(s.band.gates(), 1u);
}

TEST(SteppedBand, OfChirpsHoldsTheSameSpectrumAtEveryCell) {
  const Stitched s;
  const double range_m = 2950.0 + 1.234;
  const BurstEchoes echoes = burst_echoes(s.band, &s.pulse, {moving_point(range_m, 0.0, 2.0)}, 0.0, interval_s);
  Row joined(s.band.cells());
  s.band.join(echoes.values, {}, joined);
  // Sub-bands are hard-edged chirps, whose spectrum beyond the sampled band folds back: hundredths, tenths at the ends.
  for (std::size_t k = 0; k < joined.size(); ++k) {
    const std::complex<double> expected = 2.0 * test::carrier_turn(s.band.frequency_hz(k) * 2.0 * range_m / c);
    const bool at_end = k < joined.size() / 16 || k > joined.size() - joined.size() / 16;
    EXPECT_LT(std::abs(joined[k] - expected), at_end ? 0.5 : 0.12) << k;
  }
}

TEST(SteppedBand, StitchesTheProfileOfAChirpOfTheWholeBand) {
  const Stitched s;
  const radar::Pulse wide_pulse = test::chirp_of(82e6, 10e-6);
  const SteppedBand wide(test::chirped_waveform(wide_pulse, 9.035e9, 0.0, 1, 120e6, 2900.0, 384));
  const std::vector<test::SteppedPoint> points{moving_point(2940.0, 0.0), moving_point(2945.5, 0.0, 0.6),
                                               moving_point(2961.2, 0.0, 0.3)};
  ProfileAxis axis, wide_axis;
  const Row row = profile_of(s.band, burst_echoes(s.band, &s.pulse, points, 0.0, interval_s), {}, 2930.0, 2970.0, axis);
  const Row reference =
      profile_of(wide, burst_echoes(wide, &wide_pulse, points, 0.0, interval_s), {}, 2930.0, 2970.0, wide_axis);
  for (const auto& point : points) {
    const auto peak = peak_near(row, axis, point.range_m(0.0), 1.0);
    const auto wide_peak = peak_near(reference, wide_axis, point.range_m(0.0), 1.0);
    ASSERT_TRUE(peak && wide_peak);
    const double cell_m = c / (2.0 * 82e6);
    EXPECT_NEAR(peak->range_m, wide_peak->range_m, 0.01 * cell_m);
    EXPECT_NEAR(peak->amplitude, wide_peak->amplitude, 0.02 * point.amplitude);
    EXPECT_NEAR(peak->width_m, wide_peak->width_m, 0.02 * cell_m);
    // Each has the phase of the middle of its own band, whose cells are its own.
    const double between_hz = s.band.centre_hz() - wide.centre_hz();
    const double phase = -4.0 * core::pi * between_hz * point.range_m(0.0) / c;
    EXPECT_NEAR(std::remainder(peak->phase_rad - wide_peak->phase_rad - phase, 2.0 * core::pi), 0.0, 0.02);
    EXPECT_NEAR(peak->range_m, point.range_m(0.0), 0.02 * cell_m);
  }
  // Between the targets, 40 dB down: both profiles have the sidelobes of the window and no others.
  const auto quiet = static_cast<std::size_t>(axis.index_of(2953.0));
  EXPECT_LT(std::abs(row[quiet]), 0.01);
}

TEST(SteppedBand, TakesTheSpeedOutOfChirps) {
  const Stitched s;
  for (const double v : {250.0, -180.0}) {
    const BurstEchoes echoes = burst_echoes(s.band, &s.pulse, {moving_point(2950.0, v)}, 0.0, interval_s);
    const double middle_s = middle_of(echoes.time_s);
    ProfileAxis axis;
    const Row row = profile_of(s.band, echoes, motion_of_speed(echoes.time_s, middle_s, v, c), 2930.0, 2970.0, axis);
    const double expected_m = (2950.0 + v * middle_s) / (1.0 - v / c);
    const auto peak = peak_near(row, axis, expected_m, 1.0);
    ASSERT_TRUE(peak);
    const double cell_m = c / (2.0 * 82e6);
    // Without the coupling of Doppler and delay the peak would be fd/K = 12.6 ns or 1.9 m off.
    EXPECT_NEAR(peak->range_m, expected_m, 0.02 * cell_m) << v;
    EXPECT_NEAR(peak->amplitude, 1.0, 0.02);
    EXPECT_NEAR(peak->width_m, 1.303 * cell_m, 0.03 * cell_m);
    const double phase = -2.0 * core::pi * std::remainder(s.band.centre_hz() * 2.0 * expected_m / c, 1.0);
    EXPECT_NEAR(std::remainder(peak->phase_rad - phase, 2.0 * core::pi), 0.0, 0.1);
  }
}

// 6 km/s: the Doppler shift turns a compressed chirp by pi fd^2/K = 0.34 rad.
TEST(SteppedBand, TakesTheTurnOfTheDopplerShiftOut) {
  const Stitched s;
  const double v = 6000.0;
  const BurstEchoes echoes = burst_echoes(s.band, &s.pulse, {moving_point(2950.0, v)}, 0.0, interval_s);
  const double middle_s = middle_of(echoes.time_s);
  ProfileAxis axis;
  const Row row = profile_of(s.band, echoes, motion_of_speed(echoes.time_s, middle_s, v, c), 2930.0, 2970.0, axis);
  const double expected_m = (2950.0 + v * middle_s) / (1.0 - v / c);
  const auto peak = peak_near(row, axis, expected_m, 1.0);
  ASSERT_TRUE(peak);
  const double phase = -2.0 * core::pi * std::remainder(s.band.centre_hz() * 2.0 * expected_m / c, 1.0);
  EXPECT_NEAR(std::remainder(peak->phase_rad - phase, 2.0 * core::pi), 0.0, 0.1);
}

TEST(SteppedBand, HasGapsWhereStepsAreWiderThanTheChirps) {
  const radar::Pulse pulse = test::chirp_of(8e6, 10e-6);
  const SteppedBand band(test::chirped_waveform(pulse, 9e9, 10e6, 8, 20e6, 2900.0, 64));
  EXPECT_NEAR(band.gap_share(), 14.0 / 78.0, 0.02);
  const BurstEchoes echoes = burst_echoes(band, &pulse, {moving_point(2950.0, 0.0)}, 0.0, interval_s);
  ProfileAxis axis;
  const Row row = profile_of(band, echoes, {}, 2920.0, 2980.0, axis);
  EXPECT_NEAR(peak_near(row, axis, 2950.0, 1.0).value().amplitude, 1.0, 0.02);
  // Grating lobes c/(2 df) away.
  EXPECT_GT(peak_near(row, axis, 2950.0 + c / 20e6, 1.0).value().amplitude, 0.1);
}

TEST(SteppedBand, ShowsADelayByTheSampleInTheMiddleOfItsEcho) {
  const SteppedBand band(test::sampled_waveform(3000.0, 4));  // Gates at 3000, 3015, 3030, 3045 m; they see 15 m about.
  const auto gate = [&](double range_m) { return band.gate_of(2.0 * range_m / c); };
  EXPECT_EQ(gate(2992.0), 0u);
  EXPECT_EQ(gate(3006.0), 0u);
  EXPECT_EQ(gate(3008.0), 1u);
  EXPECT_EQ(gate(3044.0), 3u);
  EXPECT_EQ(gate(3055.0), 3u);
  EXPECT_EQ(gate(2980.0), band.gates());
  EXPECT_EQ(gate(3070.0), band.gates());
}

TEST(SteppedBand, SeesTheDelaysThatHaveAGate) {
  const radar::Pulse pulse = test::chirp_of(8e6, 10e-6);
  SteppedWaveform compressed = test::chirped_waveform(pulse, 9e9, 8e6, 8, 20e6, 2900.0, 64);
  compressed.filter.clear();
  SteppedWaveform begin = test::sampled_waveform(3000.0, 4);  // Echoes begin at the delay, not half a pulse before it.
  begin.seen_from_s = 0.0;
  begin.seen_to_s = 200e-9;
  for (const SteppedWaveform& w : {test::sampled_waveform(3000.0, 4), begin, compressed,
                                   test::chirped_waveform(pulse, 9e9, 8e6, 8, 20e6, 2900.0, 64)}) {
    const SteppedBand band(w);
    const SeenDelays seen = band.seen_delays();
    constexpr double beside_s = 1e-9;  // 15 cm
    EXPECT_LT(seen.first_s, seen.last_s);
    EXPECT_LT(band.gate_of(seen.first_s + beside_s), band.gates());
    EXPECT_EQ(band.gate_of(seen.first_s - beside_s), band.gates());
    EXPECT_LT(band.gate_of(seen.last_s - beside_s), band.gates());
    EXPECT_EQ(band.gate_of(seen.last_s + beside_s), band.gates());
  }
}

TEST(SteppedBand, RefusesWaveformsThatMakeNoBand) {
  const auto refused = [](auto change) {
    SteppedWaveform w = test::sampled_waveform(3000.0, 4);
    change(w);
    EXPECT_THROW(SteppedBand{w}, std::invalid_argument);
  };
  refused([](SteppedWaveform& w) { w.steps = 0; });
  refused([](SteppedWaveform& w) { w.steps = 1; });
  refused([](SteppedWaveform& w) { w.samples = 0; });
  refused([](SteppedWaveform& w) { w.carrier_step_hz = 0.0; });
  refused([](SteppedWaveform& w) { w.light_speed_mps = 0.0; });
  refused([](SteppedWaveform& w) { w.subband_hz = 5e6; });
}

}  // namespace stepped_band_test
}  // namespace sarsim::signal
