#include "radar/motion/ship.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {
namespace ship_test {

constexpr double deg = core::rad_per_deg;
constexpr Hull hull{110.0, 15.0, 5.0, 1.2, 0.1};
constexpr Sea state_5{3.25, 9.7};

core::RandomStream stream(std::uint64_t seed = 1) { return {seed, core::RandomKind::position_envelope, 7}; }

// Integral of |response|^2 S over frequency, on a fine grid up to 40 times the peak.
double spectral_variance(const Course& course, SineAxis axis) {
  constexpr int panels = 100'000;
  const double step = 40.0 * 2.0 * core::pi / state_5.peak_period_s / panels;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double w = (i + 0.5) * step;
    const WaveResponse r = response_of(hull, course, w);
    const auto amplitude =
        axis == SineAxis::z ? r.heave : (axis == SineAxis::roll ? r.roll_rad_per_m : r.pitch_rad_per_m);
    sum += std::norm(amplitude) * wave_spectrum(state_5, w) * step;
  }
  return sum;
}

TEST(RollPeriod, HasTheNumberOfTheRule) { EXPECT_NEAR(roll_period_s(hull), 10.809, 5e-4); }

TEST(EncounterFrequency, FollowsTheCourse) {
  EXPECT_NEAR(encounter_frequency_rad_per_s({10.0, core::pi}, 0.6), 0.6 + 0.36 * 10.0 / standard_gravity_mps2, 1e-12);
  EXPECT_NEAR(encounter_frequency_rad_per_s({10.0, 0.5 * core::pi}, 0.6), 0.6, 1e-12);
  EXPECT_LT(encounter_frequency_rad_per_s({20.0, 0.0}, 0.6), 0.0);
}

// Waves of 1 km: the ship goes with the surface and its slope, and rolls with it below resonance.
TEST(WaveResponse, FollowsLongWaves) {
  const double w = std::sqrt(2.0 * core::pi * standard_gravity_mps2 / 1000.0);
  const double k = 2.0 * core::pi / 1000.0;
  const WaveResponse head = response_of(hull, {0.0, core::pi}, w), beam = response_of(hull, {0.0, 0.5 * core::pi}, w);
  EXPECT_NEAR(head.heave.real(), 1.0, 0.05);
  EXPECT_NEAR(std::abs(head.pitch_rad_per_m), k, 0.05 * k);
  EXPECT_NEAR(std::abs(head.roll_rad_per_m), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(beam.pitch_rad_per_m), 0.0, 1e-12);
  const double w0 = 2.0 * core::pi / 10.809;
  EXPECT_NEAR(std::abs(beam.roll_rad_per_m), k / (1.0 - w * w / (w0 * w0)), 0.05 * k);
}

TEST(WaveResponse, HardlyMovesInShortWaves) {
  const WaveResponse r = response_of(hull, {0.0, 3.0}, 3.0);  // waves of 7 m
  EXPECT_LT(std::abs(r.heave), 0.05);
  EXPECT_LT(std::abs(r.pitch_rad_per_m), 1e-3);
  EXPECT_LT(std::abs(r.roll_rad_per_m), 5e-3);
}

// At resonance the roll is the slope over twice the damping.
TEST(WaveResponse, RollsAtItsResonance) {
  const double w0 = 2.0 * core::pi / roll_period_s(hull);
  const Course beam{0.0, 0.5 * core::pi};
  Hull stiff = hull;
  stiff.roll_damping = 1e6;
  const double forced = std::abs(response_of(stiff, beam, w0).roll_rad_per_m) * 2e6;
  EXPECT_NEAR(std::abs(response_of(hull, beam, w0).roll_rad_per_m), forced / 0.2, 1e-9);
  for (const double factor : {0.8, 1.2})
    EXPECT_LT(std::abs(response_of(hull, beam, factor * w0).roll_rad_per_m), 0.6 * forced / 0.2);
}

// A head sea, the ship at rest: a quarter of a period after the crest the surface falls at the middle, and the next
// crest stands ahead of the bow: the bow is up.
TEST(WaveResponse, LiftsTheBowBeforeTheCrest) {
  const double w = 0.4;
  const WaveResponse r = response_of(hull, {0.0, core::pi}, w);
  const auto at = [w](std::complex<double> a, double t) { return (a * std::polar(1.0, w * t)).real(); };
  const double quarter = 0.5 * core::pi / w;
  EXPECT_GT(at(r.pitch_rad_per_m, -quarter), 0.0);  // before the crest comes to the middle it is at the bow
  EXPECT_LT(at(r.pitch_rad_per_m, quarter), 0.0);
  // Waves from starboard to port: before the crest, starboard is up and port is down: roll is positive.
  const WaveResponse beam = response_of(hull, {0.0, 0.5 * core::pi}, 0.2);
  EXPECT_GT((beam.roll_rad_per_m * std::polar(1.0, -0.5 * core::pi)).real(), 0.0);
}

TEST(SurfaceSines, HaveTheVarianceOfTheSea) {
  for (const int count : {20, 40})
    EXPECT_NEAR(variance(surface_sines(state_5, {}, count, stream()), SineAxis::z), 0.66016, 5e-6);
}

// In time: 40 000 s, some 6000 waves; lines a hundredth of the spectrum apart leave a few per cent.
TEST(SurfaceSines, HaveItsVarianceAndPeriodInTime) {
  const auto sines = surface_sines(state_5, {}, 30, stream());
  double sum = 0.0, last = 0.0;
  int crossings = 0;
  constexpr int looks = 80'000;
  for (int i = 0; i < looks; ++i) {
    const double z = sines_at(sines, 0.5 * i).position_m[2].value;
    sum += z * z;
    if (last < 0.0 && z >= 0.0) ++crossings;
    last = z;
  }
  EXPECT_NEAR(sum / looks, 0.66016, 0.66016 * 0.05);
  EXPECT_NEAR(0.5 * looks / crossings, zero_crossing_period_s(state_5), 0.08 * zero_crossing_period_s(state_5));
}

TEST(ShipSines, HaveTheVarianceOfTheWholeSpectrum) {
  for (const Course& course : {Course{8.0, 120.0 * deg}, Course{0.0, 90.0 * deg}, Course{5.0, 45.0 * deg}}) {
    const auto sines = ship_sines(hull, course, state_5, 30, stream());
    EXPECT_EQ(sines.size(), 90U);
    for (const SineAxis axis : {SineAxis::z, SineAxis::roll, SineAxis::pitch}) {
      const double expected = spectral_variance(course, axis);
      EXPECT_NEAR(variance(sines, axis), expected, 0.01 * expected + 1e-12);
    }
  }
}

// The table of docs/theory/motion.md, to its last digit: heave in m, roll and pitch in degrees, at 10 m/s.
TEST(ShipSines, AreThoseOfTheTheorysTable) {
  struct Row {
    double to_deg, heave_m, roll_deg, pitch_deg;
  };
  for (const Row& row : {Row{0.0, 0.23, 0.0, 0.69}, Row{60.0, 0.45, 2.4, 0.72}, Row{90.0, 0.65, 4.0, 0.0},
                         Row{120.0, 0.45, 1.1, 0.72}, Row{180.0, 0.23, 0.0, 0.69}}) {
    const Course course{10.0, row.to_deg * deg};
    EXPECT_NEAR(std::sqrt(spectral_variance(course, SineAxis::z)), row.heave_m, 0.005) << row.to_deg;
    EXPECT_NEAR(std::sqrt(spectral_variance(course, SineAxis::roll)) / deg, row.roll_deg, 0.05) << row.to_deg;
    EXPECT_NEAR(std::sqrt(spectral_variance(course, SineAxis::pitch)) / deg, row.pitch_deg, 0.005) << row.to_deg;
  }
}

TEST(ShipSines, KeepTheBandsOfARealShip) {
  const auto sines = ship_sines(hull, {8.0, 100.0 * deg}, state_5, 30, stream());
  const double roll_deg = std::sqrt(variance(sines, SineAxis::roll)) / deg;
  EXPECT_GT(roll_deg, 2.0);
  EXPECT_LT(roll_deg, 15.0);
}

// The first sine of each axis belongs to the first wave, and has its encounter frequency.
TEST(ShipSines, MoveWithTheSurface) {
  const Course course{6.0, 150.0 * deg};
  const auto surface = surface_sines(state_5, course, 25, stream());
  const auto ship = ship_sines(hull, course, state_5, 25, stream());
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(ship[3 * i + axis].frequency_hz, surface[i].frequency_hz);
  EXPECT_EQ(ship[0].axis, SineAxis::z);
  EXPECT_EQ(ship[0].phase_rad, surface[0].phase_rad);  // long waves: heave goes with the surface
}

}  // namespace ship_test
}  // namespace sarsim::radar
