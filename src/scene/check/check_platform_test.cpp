#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_platform_test {

using testing::HasSubstr;

TEST(CheckPlatform, RefusesATrajectoryWhoseTimesDoNotAscend) {
  for (const auto& bad : {points({{0.0, 1.0}, {2.0, 1.0}, {1.0, 1.0}}), points({{0.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}})}) {
    Scene scene = sound_scene();
    scene.platforms[1].trajectory_m.part[0] = bad;
    const core::Problem problem = expect_error(scene, {"platform", 1, "trajectory_m"});
    EXPECT_THAT(problem.message, HasSubstr("trajectory X"));
    EXPECT_THAT(problem.found, HasSubstr("at point 3"));
  }
}

TEST(CheckPlatform, IgnoresTheOrderOfATrajectoryThatIsNotUsed) {
  Scene scene = sound_scene();
  scene.platforms[0].trajectory_m.part[0] = points({{1.0, 1.0}, {0.0, 1.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckPlatform, WarnsOfACoordinateWithoutPoints) {
  Scene scene = sound_scene();
  scene.platforms[1].trajectory_m.part[1].knots.clear();
  EXPECT_THAT(expect_warning(scene, {"platform", 1, "trajectory_m"}).message, HasSubstr("trajectory Y"));
}

TEST(CheckPlatform, WarnsOfAUserRotationWithoutPoints) {
  Scene scene = sound_scene();
  scene.platforms[1].rotation_kind = Platform::Rotation::user;
  scene.platforms[1].rotation_deg.part = {points({{0.0, 1.0}}), points({}), points({{0.0, 1.0}, {1.0, 2.0}})};
  EXPECT_THAT(expect_warning(scene, {"platform", 1, "rotation_deg"}).message, HasSubstr("rotation Y"));
}

TEST(CheckPlatform, WarnsOfAligningWithAVelocityThatIsZero) {
  Scene scene = sound_scene();
  scene.platforms[1].aligned = true;
  EXPECT_TRUE(check(scene).empty());
  scene.platforms[1].trajectory_m.part[0] = points({{0.0, 100.0}});
  expect_warning(scene, {"platform", 1, "aligned"});
}

TEST(CheckPlatform, RefusesNegativeStandardDeviations) {
  Scene scene = sound_scene();
  scene.platforms[0].position_stddev_m.z = -0.1;
  expect_error(scene, {"platform", 0, "position_stddev_m"});
  scene = sound_scene();
  scene.platforms[0].rotation_stddev[1] = core::Angle::from_deg(-1.0);
  expect_error(scene, {"platform", 0, "rotation_stddev"});
}

TEST(CheckPlatform, AcceptsErrorFunctionsWithoutPointsOrWithSeveral) {
  Scene scene = sound_scene();
  scene.platforms[1].position_error = Platform::MotionError::envelope;
  scene.platforms[1].rotation_error = Platform::MotionError::envelope;
  scene.platforms[1].position_envelope.part[1] = points({{0.0, 1.0}, {0.5, 0.0}});
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckPlatform, RefusesErrorFunctionsOfASinglePoint) {
  Scene scene = sound_scene();
  scene.platforms[1].position_error = Platform::MotionError::envelope;
  scene.platforms[1].position_envelope.part[2] = points({{0.0, 1.0}});
  EXPECT_THAT(expect_error(scene, {"platform", 1, "position_envelope"}).message, HasSubstr("position error function"));

  scene = sound_scene();
  scene.platforms[1].rotation_error = Platform::MotionError::envelope;
  scene.platforms[1].rotation_envelope.part[0] = points({{0.0, 1.0}});
  EXPECT_THAT(expect_error(scene, {"platform", 1, "rotation_envelope"}).message, HasSubstr("rotation error function"));
}

TEST(CheckPlatform, RefusesErrorFunctionsWhoseLagsDoNotAscend) {
  Scene scene = sound_scene();
  scene.platforms[1].rotation_error = Platform::MotionError::envelope;
  scene.platforms[1].rotation_envelope.part[0] = points({{0.1, 1.0}, {0.0, 1.0}});
  expect_error(scene, {"platform", 1, "rotation_envelope"});
}

TEST(CheckTarget, RefusesNegativeStandardDeviations) {
  Scene scene = sound_scene();
  scene.targets[0].traits.edit().rcs_stddev_m2 = -0.5;
  EXPECT_EQ(expect_error(scene, {"target", 0, "rcs_stddev_m2"}).found, "-0.5 m2");
  scene = sound_scene();
  scene.targets[0].traits.edit().position_stddev_m.x = -1.0;
  expect_error(scene, {"target", 0, "position_stddev_m"});
  scene = sound_scene();
  scene.targets[0].traits.edit().azimuth_stddev = core::Angle::from_deg(-1.0);
  expect_error(scene, {"target", 0, "azimuth_stddev"});
  scene = sound_scene();
  scene.targets[0].traits.edit().elevation_stddev = core::Angle::from_deg(-1.0);
  expect_error(scene, {"target", 0, "elevation_stddev"});
}

TEST(CheckTarget, WarnsThatANegativeCrossSectionIsNotSeen) {
  Scene scene = sound_scene();
  scene.targets[0].rcs_m2 = -2.0;
  EXPECT_EQ(expect_warning(scene, {"target", 0, "rcs_m2"}).found, "-2 m2");
}

TEST(CheckTarget, NeedsPointsForItsOwnReflectivityFunctionOnlyWhereThatIsUsed) {
  Scene scene = sound_scene();
  scene.targets[0].traits.edit().gain = Target::Gain::user;
  EXPECT_TRUE(check(scene).empty());
  scene.targets[0].traits.edit().reflectivity = Target::Reflectivity::directional;
  expect_error(scene, {"target", 0, "gain_db"});
  scene.targets[0].traits.edit().gain_db.part[0] = points({{0.0, 0.0}, {90.0, -30.0}});
  EXPECT_TRUE(check(scene).empty());
  scene.targets[0].traits.edit().gain_db.part[0] = points({{90.0, 0.0}, {0.0, -30.0}});
  expect_error(scene, {"target", 0, "gain_db"});
}

TEST(CheckCloud, RefusesOneWithoutAFile) {
  Scene scene = sound_scene();
  scene.geometries.clear();  // They say that they leave clouds out.
  scene.clouds.emplace_back().platform = scene.platforms[0].name;
  scene.clouds[0].file.clear();
  expect_error(scene, {"cloud", 0, "file"});
  scene.clouds[0].file = "points.npy";
  EXPECT_TRUE(check(scene).empty());
  scene.clouds[0].traits.rcs_stddev_m2 = -1.0;
  expect_error(scene, {"cloud", 0, "rcs_stddev_m2"});
}

TEST(CheckSurface, WarnsOfCornersOnALine) {
  Scene scene = sound_scene();
  scene.surfaces[0].corner_m = {core::Vec3{0.0, 0.0, 0.0}, core::Vec3{1.0, 1.0, 1.0}, core::Vec3{3.0, 3.0, 3.0}};
  expect_warning(scene, {"surface", 0, "corner_m"});
  scene.surfaces[0].corner_m = {core::Vec3{1.0, 2.0, 3.0}, core::Vec3{1.0, 2.0, 3.0}, core::Vec3{3.0, 3.0, 3.0}};
  expect_warning(scene, {"surface", 0, "corner_m"});
  // Half a square metre, but as many points as metres, whichever side is long.
  for (const auto& [along, up] : {std::pair(1e12, 1e-12), std::pair(1e-12, 1e12)}) {
    scene.surfaces[0].corner_m = {core::Vec3{}, core::Vec3{along, 0.0, 0.0}, core::Vec3{0.0, 0.0, up}};
    EXPECT_EQ(expect_error(scene, {"surface", 0, "corner_m"}).found, "1e+12 m long");
  }
}

Scene with_low_pass_trajectory(std::initializer_list<double> times_s) {
  Scene scene = sound_scene();
  core::SampledFunction& x_m = scene.platforms[1].trajectory_m.part[0];
  x_m = {.method = core::Interpolation::low_pass, .knots = {}};
  // Slow enough for a filter that misses also straight lines near its ends.
  for (const double t : times_s) x_m.knots.push_back({t, 100.0 - 1e-4 * t});
  if (times_s.size() > 1) {  // Within the points.
    scene.simulations[0].time_start_s = x_m.knots.front().x;
    scene.simulations[0].time_end_s = x_m.knots.back().x;
  }
  return scene;
}

TEST(CheckFunctions, WarnOfUnevenPointsThatALowPassFilterMisses) {
  const Scene scene = with_low_pass_trajectory({0.0, 1.0, 2.0, 10.0});  // even places: 0, 3.33, 6.67, 10
  const core::Problem problem = expect_warning(scene, {"platform", 1, "trajectory_m"});
  EXPECT_EQ(problem.message,
            "the points of the trajectory X are not evenly spaced: an MFILTER path does not pass through them");
  EXPECT_EQ(problem.found, "x = 2 at point 3, 1.4 spacings from its even position");
  EXPECT_EQ(problem.expected, "points 3.33333333 apart, within 5 %");
  EXPECT_THAT(problem.hint, testing::HasSubstr("CUBIC"));
  expect_warning(with_low_pass_trajectory({0.0, 0.3, 0.67, 1.0}), {"platform", 1, "trajectory_m"});
}

TEST(CheckFunctions, TakeRoundedTablesForEven) {
  EXPECT_TRUE(check(with_low_pass_trajectory({0.0, 1.0, 2.0, 3.0})).empty());
  EXPECT_TRUE(check(with_low_pass_trajectory({0.0, 0.333, 0.667, 1.0})).empty());
  EXPECT_TRUE(check(with_low_pass_trajectory({-1.0, -0.67, -0.33, 0.0})).empty());
  EXPECT_TRUE(check(with_low_pass_trajectory({0.0, 7.5})).empty());
  EXPECT_TRUE(check(with_low_pass_trajectory({7.5})).empty());
}

TEST(CheckFunctions, SayNothingOfUnevenPointsThatNoLowPassFilterReads) {
  Scene scene = with_low_pass_trajectory({0.0, 1.0, 2.0, 10.0});
  for (const core::Interpolation method : {core::Interpolation::linear, core::Interpolation::cubic}) {
    scene.platforms[1].trajectory_m.part[0].method = method;
    EXPECT_TRUE(check(scene).empty());
  }
  scene = sound_scene();
  scene.platforms[0].trajectory_m.part[0] = {.method = core::Interpolation::low_pass,
                                             .knots = {{0.0, 0.0}, {1.0, 1.0}, {10.0, 2.0}}};
  EXPECT_TRUE(check(scene).empty()) << "a platform that stands does not look at its trajectory";
}

}  // namespace check_platform_test
}  // namespace sarsim::scene
