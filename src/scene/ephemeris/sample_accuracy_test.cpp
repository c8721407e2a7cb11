#include "scene/ephemeris/sample_accuracy.hpp"

#include <algorithm>
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
TEST(SampleAccuracy, IsWithinAFactorOfThreeForRandomMotions) {
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
  EXPECT_LE(far, compared / 20);
  EXPECT_LT(low, compared / 100);
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
    EXPECT_LT(std::abs(std::log(found->error / worst)), std::log(3.0)) << k << ' ' << worst;
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
