#include <algorithm>

#include "scene/check/check_motion.hpp"
#include "scene/check/check_test_scene.hpp"
#include "scene/check/path_looks.hpp"

namespace sarsim::scene {
namespace check_motion_test {

using testing::HasSubstr;

Leg climb(double duration_s, double rate_mps, double rounding_mps2) {
  Leg leg;
  leg.kind = Leg::Kind::climb;
  leg.duration_s = duration_s;
  leg.rate_mps = rate_mps;
  leg.rounding_mps2 = rounding_mps2;
  return leg;
}

Leg straight(double length_m) {
  Leg leg;
  leg.length_m = length_m;
  return leg;
}

Scene scene_with_legs(const std::vector<Leg>& legs) {
  Scene scene = sound_scene();
  scene.platforms[1].path = Platform::Path::legs;
  scene.platforms[1].start_m = {0.0, -10e3, 2e3};
  scene.platforms[1].speed_mps = 100.0;
  scene.platforms[1].legs = legs;
  return scene;
}

TEST(CheckMotion, NamesTheLegThatIsWrong) {
  Leg turn;
  turn.kind = Leg::Kind::turn;
  turn.angle = core::Angle::from_deg(90.0);
  const Scene no_bank = scene_with_legs({straight(1e3), turn});
  const core::Problem problem = expect_single(no_bank, core::Severity::error, {"platform", 1, "legs[1]"});
  EXPECT_THAT(problem.message, HasSubstr("leg 2"));
  expect_error(scene_with_legs({straight(1e3), straight(1e3), straight(0.0)}), {"platform", 1, "legs[2]"});
}

TEST(CheckMotion, NamesTheWaypointThatIsWrong) {
  Scene scene = scene_with_legs({});
  scene.platforms[1].path = Platform::Path::waypoints;
  scene.platforms[1].bank = core::Angle::from_deg(20.0);
  scene.platforms[1].waypoints = {{{0.0, 0.0, 2e3}}, {{0.0, 9e3, 2e3}}, {{0.0, 1e3, 2e3}}};
  const core::Problem back = expect_single(scene, core::Severity::error, {"platform", 1, "waypoints[1]"});
  EXPECT_THAT(back.message, HasSubstr("waypoint 2: the route turns back"));
  scene.platforms[1].waypoints[2] = {{0.0, 9e3, 2e3}};
  const core::Problem twice = expect_single(scene, core::Severity::error, {"platform", 1, "waypoints[2]"});
  EXPECT_THAT(twice.message, HasSubstr("no length"));
}

// With a the rounding and T the time the rate is a T/2 at most; over a rise H it is the root of H a.
TEST(CheckMotion, TellsOfAClimbThatDoesNotReachItsRate) {
  const core::Problem problem =
      expect_warning(scene_with_legs({straight(1e3), climb(20.0, 5.0, 0.1)}), {"platform", 1, "legs[1]"});
  EXPECT_THAT(problem.message, HasSubstr("leg 2"));
  EXPECT_EQ(problem.found, "1 m/s at most");
  EXPECT_EQ(problem.expected, "5 m/s");
  EXPECT_EQ(problem.hint, "A rounding of 0.5 m/s2 or more reaches it.");
  Leg to = climb(0.0, 5.0, 0.01);
  to.kind = Leg::Kind::climb_to;
  to.height_m = 2400.0;
  const core::Problem up = expect_warning(scene_with_legs({to}), {"platform", 1, "legs[0]"});
  EXPECT_EQ(up.found, "2 m/s at most");
  EXPECT_EQ(up.hint, "A rounding of 0.0625 m/s2 or more reaches it.");
  to.rounding_mps2 = 0.0625;
  EXPECT_TRUE(check(scene_with_legs({to, climb(20.0, -5.0, 0.5)})).empty());
}

TEST(CheckMotion, TellsOfTipsThatAreTooFast) {
  Scene scene = sound_scene();
  Platform rotor;
  rotor.name = "Rotor";
  rotor.rotation_rate[2] = core::Angle::from_deg(1800.0);
  Platform blade;
  blade.name = "Blade";
  blade.parent = "Rotor";
  blade.position_m = {5.0, 0.0, 0.0};
  scene.platforms.push_back(rotor);
  scene.platforms.push_back(blade);
  scene.targets[0].platform = "Blade";
  scene.targets[0].position_m = {1.0, 0.0, 30.0};
  EXPECT_TRUE(check(scene).empty());  // 188.5 m/s
  scene.platforms[2].rotation_rate[2] = core::Angle::from_deg(10800.0);
  EXPECT_EQ(expect_warning(scene, {"platform", 2, "rotation_rate"}).found, "1130.97 m/s");
}

TEST(CheckMotion, TellsOfALeaderInAnotherFrame) {
  Scene scene = sound_scene();
  Platform boat;
  boat.name = "Boat";
  boat.parent = "Plane";
  Platform follower;
  follower.name = "Follower";
  follower.path = Platform::Path::relative;
  follower.leader = "Boat";
  follower.offset_m = {0.0, 100.0, 0.0};
  scene.platforms.push_back(boat);
  scene.platforms.push_back(follower);
  EXPECT_EQ(expect_warning(scene, {"platform", 3, "leader"}).hint, "Write parent = \"Plane\".");
  scene.platforms[3].parent = "Plane";
  EXPECT_TRUE(check(scene).empty());
  scene.platforms[3].leader = "Plane";
  EXPECT_EQ(expect_warning(scene, {"platform", 3, "leader"}).hint, "Remove the parent.");
}

TEST(CheckMotion, WantsTheEarthBelowASatellite) {
  Scene scene = sound_scene();
  scene.platforms[1].path = Platform::Path::state;
  const core::Problems problems = check(scene);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(
      core::to_string(problems.front()),
      "error: an orbit needs the Earth, but the world is flat; expected [world] with frame = \"earth\" and an anchor");
}

Scene scene_with_chain(std::size_t links) {
  Scene scene = sound_scene();
  for (std::size_t i = 0; i < links; ++i) {
    Platform platform;
    platform.name = "Q" + std::to_string(i);
    if (i > 0) platform.parent = "Q" + std::to_string(i - 1);
    scene.platforms.push_back(platform);
  }
  return scene;
}

// Followed from each platform by searching for each name, so many parents would take hours.
TEST(CheckMotion, FollowsLongChainsOfParents) {
  const Scene scene = scene_with_chain(30'000);
  EXPECT_FALSE(core::has_errors(check(scene)));
}

TEST(CheckMotion, NamesThePlatformsOfACircleAndNotThoseThatLeadThere) {
  Scene scene = scene_with_chain(10);
  const std::size_t first = scene.platforms.size() - 10;
  scene.platforms[first + 3].parent = "Q6";  // 3 -> 6 -> 5 -> 4 -> 3; 7, 8 and 9 lead there.
  std::vector<std::size_t> named;
  for (const core::Problem& problem : check(scene))
    if (problem.severity == core::Severity::error && problem.subject.field == "parent")
      named.push_back(problem.subject.index - first);
  EXPECT_EQ(named, (std::vector<std::size_t>{3, 4, 5, 6}));
}

TEST(CheckMotion, FollowsLongChainsFromTheirLeavesToo) {
  Scene scene = scene_with_chain(30'000);
  std::ranges::reverse(scene.platforms);
  EXPECT_FALSE(core::has_errors(check(scene)));
}

// Poses of a chain that moves are nested: 20 000 of them would need more stack than there is.
TEST(CheckMotion, LimitsChainsOfParentsThatMove) {
  Scene scene = scene_with_chain(2000);
  const std::size_t first = scene.platforms.size() - 2000;
  scene.platforms[first + 10].rotation_rate[2] = core::Angle::from_deg(1.0);
  const core::Problem problem = expect_error(scene, {"platform", first + 10 + longest_motion_chain, "parent"});
  EXPECT_EQ(problem.found, "platform 65 of a chain of 1990");
  EXPECT_THAT(problem.expected, HasSubstr("up to 64 platforms"));
  scene.platforms.resize(first + 10 + longest_motion_chain);
  EXPECT_FALSE(core::has_errors(check(scene)));
}

TEST(CheckMotion, LimitsChainsOfLeaders) {
  Scene scene = scene_with_chain(300);
  const std::size_t first = scene.platforms.size() - 300;
  for (std::size_t i = first + 1; i < scene.platforms.size(); ++i) {
    scene.platforms[i].path = Platform::Path::relative;
    scene.platforms[i].leader = scene.platforms[i - 1].name;
    scene.platforms[i].parent.clear();
  }
  const core::Problem problem = expect_error(scene, {"platform", first + longest_motion_chain, "leader"});
  EXPECT_EQ(problem.found, "platform 65 of a chain of 300");
  scene.platforms.resize(first + longest_motion_chain);
  EXPECT_FALSE(core::has_errors(check(scene)));
}

// Two ways lead from each to the next: followed one by one they would be 2^60.
TEST(CheckMotion, MeetsEachPlatformOnceWhereParentsLead) {
  Scene scene = scene_with_chain(60);
  const std::size_t first = scene.platforms.size() - 60;
  for (std::size_t i = first + 1; i < scene.platforms.size(); ++i) {
    scene.platforms[i].path = Platform::Path::relative;
    scene.platforms[i].leader = scene.platforms[i - 1].name;
  }
  scene.radars[0].platform = scene.platforms.back().name;
  EXPECT_TRUE(looks_of(scene, 1).empty());
  EXPECT_FALSE(looks_of(scene, first).empty());
}

}  // namespace check_motion_test
}  // namespace sarsim::scene
