#include <cmath>

#include "scene/check/check_test_scene.hpp"
#include "scene/check/path_error.hpp"

namespace sarsim::scene {
namespace check_paths_test {

using testing::HasSubstr;

constexpr double radius_m = 7.071e6;
constexpr double rate_rad_per_s = 1.0617e-3;
constexpr double acceleration_mps2 = radius_m * rate_rad_per_s * rate_rad_per_s;

// A circular orbit with a point every `spacing_s`, over +-`reach_s`.
std::array<core::SampledFunction, 3> orbit(double spacing_s, double reach_s, core::Interpolation method) {
  std::array<core::SampledFunction, 3> path;
  for (core::SampledFunction& part : path) part.method = method;
  const int count = static_cast<int>(std::lround(reach_s / spacing_s));
  for (int i = -count; i <= count; ++i) {
    const double t = spacing_s * i;
    path[0].knots.push_back({t, radius_m * std::sin(rate_rad_per_s * t)});
    path[2].knots.push_back({t, radius_m * (std::cos(rate_rad_per_s * t) - 1.0)});
  }
  path[1].knots = {{0.0, -10e3}};
  return path;
}

Scene orbiting(double spacing_s, double reach_s, core::Interpolation method) {
  Scene scene = sound_scene();
  scene.platforms[1].trajectory_m.part = orbit(spacing_s, reach_s, method);
  return scene;
}

// Largest distance from the orbit itself.
double true_error(const std::array<core::SampledFunction, 3>& path, core::CubicEnds ends, double from_s, double to_s) {
  const core::InterpolationRules rules(core::LowPassRule::first_knot, ends);
  const core::Interpolator x(path[0], rules), z(path[2], rules);
  double worst = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = from_s + (to_s - from_s) * i / 2000.0;
    worst = std::max(worst, std::hypot(x.value(t) - radius_m * std::sin(rate_rad_per_s * t),
                                       z.value(t) - radius_m * (std::cos(rate_rad_per_s * t) - 1.0)));
  }
  return worst;
}

// The estimate is the error, within the fifth that places a fifth of a segment apart may miss of its largest.
TEST(PathErrorEstimate, IsTheErrorOfAnOrbitWithEveryMethod) {
  for (const auto method : {core::Interpolation::linear, core::Interpolation::cubic, core::Interpolation::low_pass})
    for (const auto ends : {core::CubicEnds::chords, core::CubicEnds::not_a_knot})
      for (const double reach_s : {20.0, 60.0, 120.0})
        for (const double half_s : {1.0, 15.0, reach_s}) {
          const auto path = orbit(10.0, reach_s, method);
          const double error_m = true_error(path, ends, -half_s, half_s);
          const auto found = path_error(path, {core::LowPassRule::first_knot, ends}, -half_s, half_s);
          ASSERT_TRUE(found);
          EXPECT_NEAR(found->error_m / error_m, 1.0, 0.2)
              << static_cast<int>(method) << static_cast<int>(ends) << ' ' << reach_s << ' ' << half_s;
        }
}

TEST(PathErrorEstimate, HasTheSizesOfTheTheory) {
  const auto line = path_error(orbit(10.0, 60.0, core::Interpolation::linear), {}, -60.0, 60.0);
  EXPECT_NEAR(line->error_m, acceleration_mps2 * 100.0 / 8.0, 0.05 * acceleration_mps2 * 12.5);
  const auto ends = path_error(orbit(10.0, 60.0, core::Interpolation::cubic), {}, -60.0, 60.0);
  EXPECT_NEAR(ends->error_m, 0.08 * acceleration_mps2 * 100.0, 0.1 * 64.0);
  EXPECT_GT(std::abs(ends->time_s), 50.0);
}

TEST(PathErrorEstimate, IsNothingWithoutPointsWithinTheTime) {
  const auto path = orbit(10.0, 60.0, core::Interpolation::cubic);
  EXPECT_FALSE(path_error(path, {}, 61.0, 70.0));
  EXPECT_FALSE(path_error({}, {}, -1.0, 1.0));
  EXPECT_TRUE(path_error(path, {}, 3.0, 3.001));
}

TEST(CheckPaths, WarnsOfChordEndsNearTheRecordingInWavelengths) {
  const core::Problem problem =
      expect_warning(orbiting(10.0, 30.0, core::Interpolation::cubic), {"platform", 1, "trajectory_m"});
  EXPECT_THAT(problem.found, HasSubstr("wavelengths of radar Radar1"));
  EXPECT_THAT(problem.expected, HasSubstr("3.54 mm"));
  EXPECT_THAT(problem.hint, HasSubstr("CUBIC_ENDS NOT_A_KNOT"));
}

TEST(CheckPaths, IsSilentWhereTheEndsAreFarOrNotAKnot) {
  EXPECT_TRUE(check(orbiting(10.0, 120.0, core::Interpolation::cubic)).empty());
  Scene scene = orbiting(10.0, 30.0, core::Interpolation::cubic);
  scene.options.cubic_ends = core::CubicEnds::not_a_knot;
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckPaths, TakesStraightLinesForWhatTheyAre) {
  EXPECT_TRUE(check(orbiting(1.0, 30.0, core::Interpolation::linear)).empty());
}

TEST(CheckPaths, WarnsOfALowPassThroughABentPath) {
  const core::Problem problem =
      expect_warning(orbiting(10.0, 30.0, core::Interpolation::low_pass), {"platform", 1, "trajectory_m"});
  EXPECT_THAT(problem.hint, HasSubstr("Take CUBIC and CUBIC_ENDS"));
}

TEST(CheckPaths, IsSilentOnStraightFlightsAndStillScenes) {
  for (const auto method : {core::Interpolation::linear, core::Interpolation::cubic}) {
    Scene scene = sound_scene();
    scene.platforms[1].trajectory_m.part[0] = {method, {{-2.0, 300.0}, {0.0, 100.0}, {0.5, 50.0}, {2.0, -100.0}}};
    EXPECT_TRUE(check(scene).empty());
  }
}

}  // namespace check_paths_test
}  // namespace sarsim::scene
