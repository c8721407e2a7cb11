#include "scene/ephemeris/interpolation_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "scene/ephemeris/motion_test_support.hpp"

namespace sarsim::scene {

namespace interpolation_error_test {

using namespace motion_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

InterpolationError error_of(const MotionPath& path, const std::vector<double>& time_s, Reconstruction reconstruction,
                            std::size_t every = 1) {
  const auto found = interpolation_error(path, time_s, reconstruction, every);
  if (const auto* const problem = std::get_if<core::Problem>(&found)) ADD_FAILURE() << core::to_string(*problem);
  return std::get<InterpolationError>(found);
}

core::Problem problem_of(const MotionPath& path, const std::vector<double>& time_s, Reconstruction reconstruction) {
  const auto found = interpolation_error(path, time_s, reconstruction);
  const auto* const problem = std::get_if<core::Problem>(&found);
  EXPECT_NE(problem, nullptr);
  return problem == nullptr ? core::Problem{} : *problem;
}

SpacingChoice spacing_of(const MotionPath& path, const SpacingRequest& wish) {
  const auto found = spacing_for(path, wish);
  if (const auto* const problem = std::get_if<core::Problem>(&found)) ADD_FAILURE() << core::to_string(*problem);
  return std::get<SpacingChoice>(found);
}

core::Problem spacing_problem(const MotionPath& path, const SpacingRequest& wish) {
  const auto found = spacing_for(path, wish);
  const auto* const problem = std::get_if<core::Problem>(&found);
  EXPECT_NE(problem, nullptr);
  return problem == nullptr ? core::Problem{} : *problem;
}

// A circle at 1 rad/s: every derivative has the length of the radius.
MotionPath circle(double radius_m) {
  return [radius_m](double time_s) -> radar::PathState {
    const double c = radius_m * std::cos(time_s);
    const double s = radius_m * std::sin(time_s);
    return {{c, s, 0.0}, {-s, c, 0.0}, {-c, -s, 0.0}, {s, -c, 0.0}};
  };
}

// The largest |(x - 0)(x - 1)...(x - (nodes - 1))| in the first interval.
double end_product(int nodes) {
  double largest = 0.0;
  for (double x = 0.0; x <= 1.0; x += 1e-4) {
    double product = 1.0;
    for (int k = 0; k < nodes; ++k) product *= x - k;
    largest = std::max(largest, std::abs(product));
  }
  return largest;
}

TEST(InterpolationError, FollowsFromTheRemainderOfInterpolation) {
  constexpr double radius_m = 1e6;
  constexpr double h = 0.1;
  const MotionPath path = circle(radius_m);
  const std::vector<double> time_s = sample_times(-7.0, 9.0, h);
  const double fourth = radius_m * std::pow(h, 4) / 24.0;
  const double eighth = radius_m * std::pow(h, 8) / 40320.0;
  const auto found = [&](Reconstruction reconstruction) { return error_of(path, time_s, reconstruction); };

  const InterpolationError cubic = found(Reconstruction::hermite_cubic);
  EXPECT_NEAR(cubic.position_m / (fourth / 16.0), 1.0, 1e-3);                        // at the middle
  EXPECT_NEAR(cubic.velocity_mps / (fourth / h * std::sqrt(3.0) / 9.0), 1.0, 2e-2);  // at 0.21 and 0.79
  EXPECT_NEAR(found(Reconstruction::straight_lines).position_m / (radius_m * h * h / 8.0), 1.0, 1e-3);
  // These are worst at the ends, where the polynomials are not centred.
  const InterpolationError degree_7 = found(Reconstruction::hermite_degree_7);
  EXPECT_NEAR(degree_7.position_m / (eighth * std::pow(end_product(4), 2)), 0.95, 0.07);
  EXPECT_TRUE(degree_7.position_at_s < -7.0 + h || degree_7.position_at_s > 9.0 - h);
  EXPECT_NEAR(found(Reconstruction::lagrange_8_points).position_m / (eighth * end_product(8)), 0.95, 0.07);
}

TEST(InterpolationError, OfSplinesIsThatOfTheScript) {
  const MotionPath cubic = [](double t) -> radar::PathState {
    return {{t * t * t, 1.0 - 2.0 * t * t, 5.0}, {3.0 * t * t, -4.0 * t, 0.0}, {}, {}};
  };
  const std::vector<double> time_s = sample_times(0.0, 10.0, 1.0);
  EXPECT_LT(error_of(cubic, time_s, Reconstruction::spline_not_a_knot).position_m, 1e-11);
  EXPECT_LT(error_of(cubic, time_s, Reconstruction::spline_not_a_knot).velocity_mps, 1e-11);
  // The slope of the last chord of t^3 is 271 instead of 300, that of -2 t^2 is -38 instead of -40.
  const InterpolationError chords = error_of(cubic, time_s, Reconstruction::spline_chords);
  EXPECT_GT(chords.velocity_mps, 5.0);
  EXPECT_LT(chords.velocity_mps, std::hypot(29.0, 2.0));
  EXPECT_GT(chords.position_at_s, 9.0);
}

// The orbit of motion_test_support near its node and perigee, where angles are small, so that the path itself is
// rounded to 1e-9 m.
radar::PathState smooth_orbit(double time_s) {
  static const radar::SecularOrbit orbit({7070.5e3, 0.00114, 98.1817 * core::rad_per_deg, 0.0, 0.0, 0.0});
  const radar::OrbitMotion motion = orbit.at(time_s);
  const double rate = radar::earth_rate_rad_per_s;
  const radar::StateVector state =
      radar::turning_about_z(rate * time_s, rate).to({motion.position_m, motion.velocity_mps});
  return {state.position_m, state.velocity_mps, {}, {}};
}

TEST(InterpolationError, OfALowOrbitIsThatOfTheTables) {
  // radar/orbit/state_table.hpp, and section 4.2 of the facts: 2.5e-4, 0.020 and 0.33 m; 1.1e-9, 3.8e-9 and 3.2e-8 m;
  // 2.8e-9 and 2.2e-8 m. At the ends degree 7 is up to 3 times, 8 positions up to 20 times worse.
  const auto error_m = [](Reconstruction reconstruction, double spacing_s) {
    return error_of(smooth_orbit, sample_times(-600.0, 600.0, spacing_s), reconstruction).position_m;
  };
  EXPECT_NEAR(error_m(Reconstruction::hermite_cubic, 10.0), 2.5e-4, 0.1e-4);
  EXPECT_NEAR(error_m(Reconstruction::hermite_cubic, 30.0), 0.0205, 0.0005);
  EXPECT_NEAR(error_m(Reconstruction::hermite_cubic, 60.0), 0.328, 0.005);
  EXPECT_LT(error_m(Reconstruction::hermite_degree_7, 10.0), 8e-9);
  EXPECT_LT(error_m(Reconstruction::hermite_degree_7, 30.0), 8e-9);
  EXPECT_GT(error_m(Reconstruction::hermite_degree_7, 60.0), 3.2e-8);
  EXPECT_LT(error_m(Reconstruction::hermite_degree_7, 60.0), 3.0 * 3.2e-8);
  EXPECT_LT(error_m(Reconstruction::lagrange_8_points, 10.0), 8e-9);
  EXPECT_GT(error_m(Reconstruction::lagrange_8_points, 30.0), 2.2e-8);
  EXPECT_LT(error_m(Reconstruction::lagrange_8_points, 30.0), 20.0 * 2.2e-8);
  EXPECT_LT(error_of(smooth_orbit, sample_times(-600.0, 600.0, 30.0), Reconstruction::hermite_degree_7).velocity_mps,
            2e-9);
}

TEST(InterpolationError, LooksIntoAPartWhereAskedTo) {
  std::size_t calls = 0;
  const MotionPath counting = [&](double time_s) {
    ++calls;
    return circle(1.0)(time_s);
  };
  const std::vector<double> time_s = sample_times(0.0, 100.0, 0.1);
  const InterpolationError all = error_of(counting, time_s, Reconstruction::hermite_cubic);
  EXPECT_EQ(calls, 1001U + 4U * 1000U);
  calls = 0;
  const InterpolationError part = error_of(counting, time_s, Reconstruction::hermite_cubic, 100);
  EXPECT_EQ(calls, 1001U + 4U * (8U + 9U + 8U));  // intervals 100 to 900, besides those at the ends
  EXPECT_LE(part.position_m, all.position_m);
  EXPECT_GT(part.position_m, 0.99 * all.position_m);
}

TEST(InterpolationError, RefusesWhatCannotBeCompared) {
  const MotionPath path = circle(1.0);
  EXPECT_EQ(problem_of(path, {0.0, 1.0, 2.0}, Reconstruction::hermite_degree_7).message,
            "there are too few samples to interpolate");
  EXPECT_EQ(problem_of(path, {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, Reconstruction::lagrange_8_points).expected,
            "8 or more");
  EXPECT_EQ(problem_of(path, {0.0}, Reconstruction::straight_lines).expected, "2 or more");
  EXPECT_EQ(problem_of(path, {}, Reconstruction::straight_lines).found, "0 samples");
  for (const std::vector<double>& time_s : {std::vector{0.0, 0.0}, {1.0, 0.0}, {0.0, nan, 1.0}, {nan, 1.0}})
    for (const auto reconstruction : {Reconstruction::hermite_cubic, Reconstruction::spline_not_a_knot})
      EXPECT_EQ(problem_of(path, time_s, reconstruction).message, "the times of samples do not ascend");
  const MotionPath ends = [&](double time_s) {
    return time_s > 2.25 ? radar::PathState{{nan, 0.0, 0.0}, {}, {}, {}} : path(time_s);
  };
  EXPECT_EQ(problem_of(ends, {0.0, 1.0, 2.0, 3.0}, Reconstruction::straight_lines).message,
            "the motion is not finite at 3 s");
  const MotionPath hole = [&](double time_s) {
    return time_s > 0.1 && time_s < 0.9 ? radar::PathState{{}, {0.0, nan, 0.0}, {}, {}} : path(time_s);
  };
  EXPECT_EQ(problem_of(hole, {0.0, 1.0, 2.0, 3.0}, Reconstruction::straight_lines).message,
            "the motion is not finite at 0.5 s");
}

TEST(SampleTimes, ReachTheEndWithoutAShortInterval) {
  EXPECT_EQ(sample_times(0.0, 1.0, 0.25), (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
  EXPECT_EQ(sample_times(-1.0, 1.5, 1.0), (std::vector{-1.0, 0.0, 0.75, 1.5}));
  EXPECT_EQ(sample_times(0.0, 0.5, 1.0), (std::vector{0.0, 0.5}));
  EXPECT_EQ(sample_times(0.0, 1.5, 1.0), (std::vector{0.0, 0.75, 1.5}));
  EXPECT_EQ(sample_times(0.0, 0.3, 0.1).size(), 4U);
  for (double last_s = 0.01; last_s < 3.0; last_s += 0.013) {
    const std::vector<double> time_s = sample_times(0.0, last_s, 0.1);
    EXPECT_EQ(time_s.front(), 0.0);
    EXPECT_EQ(time_s.back(), last_s);
    for (std::size_t i = 1; i < time_s.size(); ++i) {
      EXPECT_GT(time_s[i] - time_s[i - 1], time_s.size() > 2 ? 0.0499 : 0.0);
      EXPECT_LT(time_s[i] - time_s[i - 1], 0.1001);
    }
  }
  EXPECT_THROW(static_cast<void>(sample_times(1.0, 1.0, 0.1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(sample_times(0.0, 1.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(sample_times(0.0, 1.0, nan)), std::invalid_argument);
}

TEST(SpacingFor, IsTheWidestOfTheSeries) {
  // A cubic between two states is wrong by 1000 m h^4/384: 1e-3 m at 0.1400 s, 1e-5 m at 0.0443 s, 300 m at 3.3 s.
  const auto spacing_s = [](double error_m) {
    return spacing_of(circle(1000.0), {error_m, 0.0, 50.0, Reconstruction::hermite_cubic}).spacing_s;
  };
  EXPECT_EQ(spacing_s(1e-3), 0.1);
  EXPECT_EQ(spacing_s(1e-5), 0.02);
  EXPECT_EQ(spacing_s(0.2), 0.5);
  EXPECT_EQ(spacing_s(5e-5), 0.05);
  EXPECT_EQ(spacing_s(300.0), 2.0);
  const SpacingChoice choice = spacing_of(circle(1000.0), {1e-3, 0.0, 50.0, Reconstruction::hermite_cubic, 1'000'000});
  EXPECT_NEAR(choice.error.position_m, 1000.0 * 1e-4 / 384.0, 1e-6);
  // Any spacing would do: the widest that has enough samples.
  const MotionPath rest = [](double) { return radar::PathState{}; };
  EXPECT_EQ(spacing_of(rest, {1e-3, 0.0, 300.0, Reconstruction::hermite_degree_7}).spacing_s, 100.0);
  EXPECT_EQ(spacing_of(rest, {1e-3, 0.0, 300.0, Reconstruction::straight_lines}).spacing_s, 200.0);
  EXPECT_EQ(spacing_of(orbit_path, {1e-6, 0.0, 6000.0, Reconstruction::hermite_degree_7}).spacing_s, 50.0);
}

TEST(SpacingFor, IsNotDeceivedByVibrationsAndShortEvents) {
  // 1 mm at 10 Hz: at spacings of 0.1, 0.2, ... s all samples are alike.
  const MotionPath vibration = [](double t) -> radar::PathState {
    constexpr double rate = 20.0 * core::pi;
    return {{100.0 * t, 0.0, 1e-3 * std::sin(rate * t)}, {100.0, 0.0, 1e-3 * rate * std::cos(rate * t)}, {}, {}};
  };
  const SpacingChoice choice = spacing_of(vibration, {1e-4, 0.0, 100.0});
  // 0.05 s gives 2.3e-4 m at the ends: 1e-3 m pi^8/8!.
  EXPECT_EQ(choice.spacing_s, 0.02);
  EXPECT_LT(choice.error.position_m, 1e-4);
  // Once in 1000 s, for 1 s.
  const MotionPath event = [](double t) -> radar::PathState {
    const double x = t - 333.3;
    const double bump = std::exp(-8.0 * x * x);
    return {{0.0, bump, 0.0}, {0.0, -16.0 * x * bump, 0.0}, {}, {}};
  };
  const SpacingChoice of_event = spacing_of(event, {1e-3, 0.0, 1000.0});
  EXPECT_LE(of_event.spacing_s, 0.5);
  EXPECT_LT(of_event.error.position_m, 1e-3);
}

TEST(SpacingFor, RefusesWhatNoSpacingKeeps) {
  const core::Problem few = spacing_problem(circle(1000.0), {1e-6, 0.0, 50.0, Reconstruction::straight_lines, 1000});
  EXPECT_EQ(few.message, "no spacing keeps the error below 1E-06 m");
  EXPECT_TRUE(few.found.ends_with(" m with 0.1 s")) << few.found;
  // 1e-12 m is less than the rounding at 7e6 m; that is found out long before all samples are used up.
  std::size_t calls = 0;
  const MotionPath counting = [&](double time_s) {
    ++calls;
    return smooth_orbit(time_s);
  };
  const core::Problem fine = spacing_problem(counting, {1e-12, -600.0, 600.0, Reconstruction::hermite_degree_7});
  EXPECT_EQ(fine.message, "no spacing keeps the error below 1E-12 m");
  EXPECT_LT(calls, 100'000U);
  EXPECT_EQ(spacing_problem(counting, {1e-3, 1.0, 1.0}).message, "no spacing can be chosen");
  EXPECT_EQ(spacing_problem(counting, {1e-3, 1.0, nan}).message, "no spacing can be chosen");
  EXPECT_EQ(spacing_problem(counting, {0.0, 0.0, 1.0}).message, "no spacing can be chosen");
  EXPECT_EQ(spacing_problem(counting, {1e-3, 0.0, 1.0, Reconstruction::hermite_cubic, 2}).found, "2 samples at most");
  const MotionPath broken = [](double) { return radar::PathState{{nan, 0.0, 0.0}, {}, {}, {}}; };
  EXPECT_EQ(spacing_problem(broken, {1e-3, 0.0, 1.0}).message, "the motion is not finite at 0 s");
}

}  // namespace interpolation_error_test

}  // namespace sarsim::scene
