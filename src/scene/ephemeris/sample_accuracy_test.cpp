#include "scene/ephemeris/sample_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "scene/ephemeris/sample_test_support.hpp"

namespace sarsim::scene {

namespace sample_accuracy_test {

using namespace sample_test;

// The largest distance of a table from the motion, in the intervals that have a part of a time.
double true_error(const SmoothMotion& motion, const radar::StateSamples& samples,
                  const radar::StateInterpolation& interpolation, const radar::TimeSpan& within) {
  const auto made = radar::StateTable::from(samples, interpolation);
  const auto& table = std::get<radar::StateTable>(made);
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < samples.time_s.size(); ++i) {
    if (samples.time_s[i + 1] <= within.first_s || samples.time_s[i] >= within.last_s) continue;
    for (int k = 1; k < 200; ++k) {
      const double time_s = samples.time_s[i] + (samples.time_s[i + 1] - samples.time_s[i]) * k / 200.0;
      worst = std::max(worst, core::norm(table.at(time_s)->position_m - motion(time_s).position_m));
    }
  }
  return worst;
}

// The largest distance of a table from the motion within all intervals, and the root of the mean square.
std::pair<double, double> worst_and_mean(const SmoothMotion& motion, const radar::StateSamples& samples,
                                         const radar::StateInterpolation& interpolation) {
  const auto made = radar::StateTable::from(samples, interpolation);
  const auto& table = std::get<radar::StateTable>(made);
  double worst = 0.0, squares = 0.0;
  int places = 0;
  for (std::size_t i = 0; i + 1 < samples.time_s.size(); ++i)
    for (int k = 0; k <= 20; ++k, ++places) {
      const double time_s = samples.time_s[i] + (samples.time_s[i + 1] - samples.time_s[i]) * k / 20.0;
      const double off = core::norm(table.at(time_s)->position_m - motion(time_s).position_m);
      worst = std::max(worst, off);
      squares += off * off;
    }
  return {worst, std::sqrt(squares / places)};
}

// The error is known from outside: 9.8 km, 34 to 44 m by the phase of the orbit, 1.6 m, 7 mm.
TEST(SampleAccuracy, IsTheErrorOfALowOrbitWithFewStates) {
  const SmoothMotion motion = orbit({6786137.0, 0.0005, 51.6 * core::rad_per_deg, 1.0, 2.0, 3.0});
  const std::pair<double, double> known[] = {{1800.0, 9.8e3}, {900.0, 40.0}, {600.0, 1.7}, {300.0, 7.5e-3}};
  for (const auto& [step_s, error_m] : known) {
    const radar::StateSamples samples = samples_of(motion, -6.0 * step_s, step_s, 13, true);
    const radar::TimeSpan within{-0.9 * step_s, 0.9 * step_s};
    const auto found = accuracy_between(samples, radar::hermite_degree_7, within);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::log(found->error / error_m), 0.0, std::log(1.5)) << step_s;
    const double truth = true_error(motion, samples, radar::hermite_degree_7, within);
    EXPECT_NEAR(found->error / truth, 1.0, 0.1) << step_s;
    EXPECT_EQ(found->spacing_s, step_s);
  }
}

// Three and a half states a turn and more; a third of the intervals lie at the ends, where polynomials are one-sided.
TEST(SampleAccuracy, IsWithinAFactorOfThreeForMostRandomMotions) {
  Draw draw(54);
  int compared = 0, far = 0, low = 0;
  for (int k = 0; k < 900; ++k) {
    const auto [motion, turn_s, is_orbit] = drawn_motion(draw, k);
    const double step_s = turn_s / draw.log(3.5, 60.0);
    const auto count = static_cast<std::size_t>(draw(10.0, 40.0));
    const bool velocities = k % 2 == 1;
    radar::StateInterpolation interpolation = velocities ? radar::hermite_degree_7 : radar::lagrange_8_points;
    if (k % 6 == 1) interpolation = radar::hermite_cubic;
    const radar::StateSamples samples = samples_of(motion, draw(-1.0, 1.0) * turn_s, step_s, count, velocities);
    const double middle_s = draw(samples.time_s.front(), samples.time_s.back());
    const radar::TimeSpan within{middle_s - draw(0.0, 3.0) * step_s, middle_s + draw(0.01, 3.0) * step_s};
    const double truth = true_error(motion, samples, interpolation, within);
    if (truth < 1e-6) continue;  // rounding
    const auto found = accuracy_between(samples, interpolation, within);
    ASSERT_TRUE(found);
    ++compared;
    if (found->error > 3.0 * truth || found->error < truth / 3.0) ++far;
    if (found->error < truth / 3.0) ++low;
    EXPECT_GT(found->error, truth / 10.0) << k;
  }
  EXPECT_GT(compared, 500);
  EXPECT_LT(far, compared / 10);
  EXPECT_LT(low, compared / 100);
}

// An ellipse by Kepler's equation, in axes that turn with the Earth; the perigee is passed at time 0.
SmoothMotion kepler_ellipse(double axis_m, double eccentricity, const core::Mat3& turn) {
  constexpr double mu = 3.986004418e14;
  const double mean_rate = std::sqrt(mu / (axis_m * axis_m * axis_m));
  const double minor_m = axis_m * std::sqrt(1.0 - eccentricity * eccentricity);
  return [=](double time_s) -> radar::OrbitState {
    const double mean = std::remainder(mean_rate * time_s, 2.0 * core::pi);
    double eccentric = mean + std::copysign(0.85 * eccentricity, mean);
    for (int i = 0; i < 12; ++i)
      eccentric -= (eccentric - eccentricity * std::sin(eccentric) - mean) / (1.0 - eccentricity * std::cos(eccentric));
    const double c = std::cos(eccentric), s = std::sin(eccentric);
    const double rate = mean_rate / (1.0 - eccentricity * c);
    const radar::StateVector state =
        radar::turning_about_z(radar::earth_rate_rad_per_s * time_s, radar::earth_rate_rad_per_s)
            .to({turn * core::Vec3{axis_m * (c - eccentricity), minor_m * s, 0.0},
                 turn * core::Vec3{-axis_m * rate * s, minor_m * rate * c, 0.0}});
    return {state.position_m, state.velocity_mps};
  };
}

SmoothMotion drawn_ellipse(Draw& draw, double& period_s) {
  const double eccentricity = draw(0.0, 0.8);
  const double axis_m = (6378e3 + draw(200e3, 1500e3)) / (1.0 - eccentricity);
  period_s = 2.0 * core::pi * std::sqrt(axis_m * axis_m * axis_m / 3.986004418e14);
  const double node = draw(0.0, 6.28), tilt = draw(0.0, core::pi), perigee = draw(0.0, 6.28);
  const auto about_z = [](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return core::Mat3{{core::Vec3{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}}};
  };
  const double c = std::cos(tilt), s = std::sin(tilt);
  const core::Mat3 about_x{{core::Vec3{1.0, 0.0, 0.0}, {0.0, c, -s}, {0.0, s, c}}};
  return kepler_ellipse(axis_m, eccentricity, about_z(node) * about_x * about_z(perigee));
}

// Files of 4 to 30 states, with and without velocities, around the perigee and elsewhere; looked at as a whole, within
// a few states, and at an end, where polynomials are one-sided.
TEST(SampleAccuracy, OfLongEllipsesIsNeitherFarTooLargeNorTooSmall) {
  Draw draw(26);
  struct Count {
    int files = 0, low = 0, high = 0;
  };
  Count counts[2][2];  // by velocities, and by fewer than 11 states
  for (int k = 0; k < 2400; ++k) {
    double period_s = 0.0;
    const SmoothMotion motion = drawn_ellipse(draw, period_s);
    const double step_s = draw.log(10.0, 300.0);
    const auto count = static_cast<std::size_t>(draw(4.0, 30.99));
    const bool velocities = k % 2 == 1;
    radar::StateInterpolation interpolation = velocities ? radar::hermite_degree_7 : radar::lagrange_8_points;
    if (k % 10 == 1) interpolation = radar::hermite_cubic;
    if (count < interpolation.states) continue;
    const double length_s = step_s * static_cast<double>(count - 1);
    const double first_s = k % 4 < 2 ? -draw(0.0, 1.0) * length_s : draw(-0.5, 0.5) * period_s;
    const radar::StateSamples samples = samples_of(motion, first_s, step_s, count, velocities);
    const double middle_s = first_s + draw(0.0, 1.0) * length_s;
    const radar::TimeSpan spans[] = {{first_s, first_s + length_s},
                                     {middle_s - draw(0.0, 2.0) * step_s, middle_s + draw(0.01, 2.0) * step_s},
                                     {first_s + length_s - draw(0.1, 1.5) * step_s, first_s + length_s}};
    const radar::TimeSpan within = spans[k % 3];
    const double truth = true_error(motion, samples, interpolation, within);
    if (truth < 1e-6) continue;  // rounding
    const auto found = accuracy_between(samples, interpolation, within);
    if (!found) continue;
    Count& one = counts[velocities ? 1 : 0][count < 11 ? 1 : 0];
    ++one.files;
    one.low += found->error < 0.5 * truth ? 1 : 0;
    one.high += found->error > 10.0 * truth ? 1 : 0;
  }
  for (const auto& of_kind : counts)
    for (const Count& one : of_kind) {
      EXPECT_GT(one.files, 70);
      EXPECT_LE(one.low + one.high, one.files / 50) << one.low << " too small, " << one.high << " too large";
    }
}

// Three and a half states a turn: with velocities, positions whose differences do not fall are no noise.
TEST(SampleAccuracy, OfFewStatesAroundThePerigeeIsNoNoise) {
  Draw draw(27);
  int files = 0, high = 0;
  for (int k = 0; k < 500; ++k) {
    double period_s = 0.0;
    const SmoothMotion motion = drawn_ellipse(draw, period_s);
    const double step_s = draw(300.0, 1500.0);
    const auto count = static_cast<std::size_t>(draw(5.0, 10.99));
    const radar::StateSamples samples =
        samples_of(motion, -draw(0.0, 1.0) * step_s * static_cast<double>(count - 1), step_s, count, true);
    const radar::TimeSpan within{samples.time_s.front(), samples.time_s.back()};
    const double truth = true_error(motion, samples, radar::hermite_degree_7, within);
    const auto found = accuracy_between(samples, radar::hermite_degree_7, within);
    ASSERT_TRUE(found);
    ++files;
    high += found->error > 10.0 * truth + 1e-6 ? 1 : 0;
    EXPECT_LT(found->error, 1000.0 * truth + 1e-6) << k;
  }
  EXPECT_LE(high, files / 10);
}

TEST(SampleAccuracy, ACircleOfFourPointsIsFarOff) {
  const SmoothMotion motion = circle(1000.0, 120.0, 0.3);
  const radar::StateSamples samples = samples_of(motion, -240.0, 30.0, 17, false);
  const auto inside = accuracy_between(samples, radar::lagrange_8_points, {-10.0, 10.0});
  const auto at_end = accuracy_between(samples, radar::lagrange_8_points, {-240.0, 240.0});
  ASSERT_TRUE(inside && at_end);
  EXPECT_GT(inside->error, 10.0);
  EXPECT_GT(at_end->error, 100.0);
}

TEST(SampleAccuracy, StatesWithoutMoreAroundThemAreJudgedByFewer) {
  const SmoothMotion motion = circle(1000.0, 120.0, 0.3);
  for (const std::size_t count : {2U, 3U, 4U, 5U, 8U, 9U}) {
    const radar::StateSamples samples = samples_of(motion, 0.0, 10.0, count, true);
    EXPECT_TRUE(accuracy_between(samples, radar::hermite_degree_7, {0.0, 5.0})) << count;
    EXPECT_TRUE(accuracy_between(samples, radar::lagrange_8_points, {0.0, 5.0})) << count;
  }
  EXPECT_FALSE(accuracy_between(samples_of(motion, 0.0, 10.0, 1, true), radar::hermite_degree_7, {0.0, 5.0}));
  EXPECT_FALSE(accuracy_between(samples_of(motion, 0.0, 10.0, 9, true), radar::hermite_degree_7, {90.0, 95.0}));
}

radar::Quaternion about(const core::Vec3& axis, double angle_rad) {
  const double s = std::sin(0.5 * angle_rad) / core::norm(axis);
  return {std::cos(0.5 * angle_rad), s * axis.x, s * axis.y, s * axis.z};
}

// Swinging about a skew axis: known at every time.
TEST(SampleAccuracy, OfAttitudesIsTheAngleOfTheSplinesError) {
  Draw draw(7);
  int far = 0;
  for (int k = 0; k < 100; ++k) {
    const core::Vec3 axis{draw(-1.0, 1.0), draw(-1.0, 1.0), draw(0.1, 1.0)};
    const double swing = draw(0.01, 1.0), rate = 2.0 * core::pi / draw(20.0, 100.0);
    const auto truth = [&](double time_s) { return about(axis, swing * std::sin(rate * time_s)); };
    const double step_s = 2.0 * core::pi / rate / draw.log(8.0, 40.0);
    radar::AttitudeSamples samples;
    for (int i = -12; i <= 12; ++i) {
      samples.time_s.push_back(step_s * i);
      samples.world_from_platform.push_back(truth(step_s * i));
    }
    const radar::TimeSpan within{-3.5 * step_s, 3.5 * step_s};
    const auto made = radar::AttitudeTable::from(samples);
    double worst = 0.0;
    for (int i = -800; i <= 800; ++i) {
      const double time_s = step_s * i / 200.0;
      const core::Mat3 a = std::get<radar::AttitudeTable>(made).turning_at(time_s).matrix;
      const core::Mat3 off = a * core::transposed(radar::matrix_of(truth(time_s)));
      const core::Vec3 axis_part{off.row[2].y - off.row[1].z, off.row[0].z - off.row[2].x, off.row[1].x - off.row[0].y};
      worst = std::max(worst, 0.5 * core::norm(axis_part));
    }
    if (worst < 1e-9) continue;
    const auto found = accuracy_between(samples, within);
    ASSERT_TRUE(found);
    const double off = std::abs(std::log(found->error / worst));
    EXPECT_LT(off, std::log(5.0)) << k << ' ' << worst;
    far += off > std::log(3.0) ? 1 : 0;
  }
  EXPECT_LE(far, 5);
}

// What may be wrong with the states of a file.
enum class Fault { noise, noise_of_both, noise_of_velocities, by_turns, velocities_by_turns, one_state, rounding };

void spoil(radar::StateSamples& samples, Fault fault, double size_m, double step_s, Draw& draw) {
  const core::Vec3 off_m = draw.noise(size_m);
  const auto bad = static_cast<std::size_t>(draw(0.0, static_cast<double>(samples.time_s.size()) - 1e-9));
  const double unit_m = std::pow(10.0, std::floor(draw(-3.0, 1.0)));  // 1 mm to 1 m
  const auto rounded = [](const core::Vec3& v, double unit) {
    return core::Vec3{std::round(v.x / unit) * unit, std::round(v.y / unit) * unit, std::round(v.z / unit) * unit};
  };
  for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
    core::Vec3& position_m = samples.position_m[i];
    core::Vec3 velocity_mps = samples.velocity_mps.empty() ? core::Vec3{} : samples.velocity_mps[i];
    if (fault == Fault::noise || fault == Fault::noise_of_both) position_m = position_m + draw.noise(size_m);
    if (fault == Fault::noise_of_both) velocity_mps = velocity_mps + draw.noise(0.4 * size_m / step_s);
    if (fault == Fault::noise_of_velocities) velocity_mps = velocity_mps + draw.noise(size_m / step_s);
    if (fault == Fault::by_turns && i % 2 == 1) position_m = position_m + off_m;
    if (fault == Fault::velocities_by_turns && i % 2 == 1) velocity_mps = velocity_mps + (1.0 / step_s) * off_m;
    if (fault == Fault::one_state && i == bad) position_m = position_m + off_m;
    if (fault == Fault::rounding) position_m = rounded(position_m, unit_m);
    if (fault == Fault::rounding) velocity_mps = rounded(velocity_mps, 1e-3 * unit_m);
    if (!samples.velocity_mps.empty()) samples.velocity_mps[i] = velocity_mps;
  }
}

// Motions that are sampled closely enough, but wrongly: the error is that of the states.
TEST(SampleAccuracy, CountsWhatStatesAreOff) {
  Draw draw(61);
  constexpr Fault faults[] = {Fault::noise,    Fault::noise_of_both,       Fault::noise_of_velocities,
                              Fault::by_turns, Fault::velocities_by_turns, Fault::one_state,
                              Fault::rounding};
  for (const Fault fault : faults) {
    constexpr int files = 240;
    int low = 0, high = 0;
    const bool needs_velocities =
        fault == Fault::noise_of_both || fault == Fault::noise_of_velocities || fault == Fault::velocities_by_turns;
    for (int k = 0; k < files; ++k) {
      const bool velocities = needs_velocities || k / 3 % 2 == 1;
      radar::StateInterpolation interpolation = velocities ? radar::hermite_degree_7 : radar::lagrange_8_points;
      if (velocities && k % 7 == 1) interpolation = radar::hermite_cubic;
      const auto [motion, turn_s, is_orbit] = drawn_motion(draw, fault == Fault::rounding ? 2 * k - 2 * k % 3 : k);
      const double step_s = fault == Fault::rounding ? draw(10.0, 60.0) : turn_s / draw.log(20.0, 500.0);
      radar::StateSamples samples =
          samples_of(motion, draw(-1.0, 1.0) * turn_s, step_s, static_cast<std::size_t>(draw(14.0, 60.0)), velocities);
      const bool is_noise = fault == Fault::noise || needs_velocities;
      spoil(samples, fault, is_noise ? draw.log(1e-2, 20.0) : draw.log(1.0, 3000.0), step_s, draw);
      const double length_s = samples.time_s.back() - samples.time_s.front();
      // Away from the ends, nothing of what goes by turns is left in the differences of polynomials.
      const double margin_s = fault == Fault::by_turns ? 0.25 * length_s : 0.0;
      const radar::TimeSpan within{samples.time_s.front() + margin_s, samples.time_s.back() - margin_s};
      const auto found = accuracy_between(samples, interpolation, within);
      ASSERT_TRUE(found);
      const auto [worst, mean] = worst_and_mean(motion, samples, interpolation);
      low += found->error < 0.5 * mean ? 1 : 0;
      high += found->error > 2.0 * worst ? 1 : 0;
    }
    EXPECT_LE(low, files / 50) << static_cast<int>(fault);
    EXPECT_LE(high, files / 20) << static_cast<int>(fault);
  }
}

// Far from it, one wrong state is nothing.
TEST(SampleAccuracy, IsThatOfTheStatesAroundTheTime) {
  Draw draw(62);
  radar::StateSamples samples = samples_of(orbit(7078e3, 0.001, draw), 0.0, 10.0, 101, true);
  samples.position_m[50].y += 1000.0;
  EXPECT_NEAR(accuracy_between(samples, radar::hermite_degree_7, {470.0, 530.0})->error, 1000.0, 100.0);
  EXPECT_LT(accuracy_between(samples, radar::hermite_degree_7, {100.0, 300.0})->error, 1e-6);
}

// White noise of the attitudes: 3.46 times the angle about each axis is the largest of a hundred or so.
TEST(SampleAccuracy, OfAttitudesCountsTheirNoise) {
  Draw draw(63);
  for (int k = 0; k < 60; ++k) {
    const double noise_rad = draw.log(1e-6, 1e-2), rate = 2.0 * core::pi / draw.log(30.0, 300.0);
    radar::AttitudeSamples samples;
    for (int i = 0; i < 80; ++i) {
      samples.time_s.push_back(i);
      const core::Vec3 off = draw.noise(noise_rad);
      const double swing = 0.2 * std::sin(rate * i);
      samples.world_from_platform.push_back(radar::quaternion_of(radar::matrix_of(about({0.3, 0.1, 1.0}, swing)) *
                                                                 radar::matrix_of(about(off, core::norm(off)))));
    }
    const auto found = accuracy_between(samples, {5.0, 75.0});
    ASSERT_TRUE(found);
    EXPECT_GT(found->error, 0.5 * std::sqrt(3.0) * noise_rad) << k;
    EXPECT_LT(found->error, 2.0 * 4.0 * noise_rad) << k;
  }
}

TEST(SampleAccuracy, TurnsAreThoseFromOneAttitudeToTheNext) {
  radar::AttitudeSamples samples;
  for (int i = 0; i < 6; ++i) {
    samples.time_s.push_back(i);
    samples.world_from_platform.push_back(about({0.0, 0.0, 1.0}, i == 3 ? core::pi : 0.1 * i));
  }
  EXPECT_NEAR(largest_turn(samples, {0.0, 1.5})->step, 0.1, 1e-12);
  const auto turn = largest_turn(samples, {0.0, 5.0});
  EXPECT_NEAR(turn->step, core::pi - 0.2, 1e-9);
  EXPECT_EQ(turn->at_s, 2.0);
}

}  // namespace sample_accuracy_test

}  // namespace sarsim::scene
