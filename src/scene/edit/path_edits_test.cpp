#include "scene/edit/path_edits.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "scene/edit/path_points.hpp"
#include "scene/model/route.hpp"

namespace sarsim::scene {
namespace path_edits_test {

Platform boat() {
  Platform platform;
  platform.path = Platform::Path::waypoints;
  platform.speed_mps = 20.0;
  platform.waypoints = {{{0.0, 0.0, 5.0}, 0.0}, {{1000.0, 0.0, 5.0}, 0.0}, {{1000.0, 2000.0, 5.0}, 0.0}};
  platform.bank = core::Angle::from_deg(20.0);
  return platform;
}

Platform plane() {
  Platform platform;
  platform.path = Platform::Path::legs;
  platform.speed_mps = 100.0;
  Leg straight;
  straight.length_m = 2000.0;
  Leg turn;
  turn.kind = Leg::Kind::turn;
  turn.angle = core::Angle::from_deg(90.0);
  turn.radius_m = 500.0;
  platform.legs = {straight, turn, straight};
  return platform;
}

void expect_point(const Platform& platform, std::size_t index, const core::Vec3& at_m, double tolerance_m) {
  const std::vector<core::Vec3> points = path_points(platform, {});
  ASSERT_LT(index, points.size());
  EXPECT_LT(core::norm(points[index] - at_m), tolerance_m) << points[index].x << ' ' << points[index].y;
}

TEST(PathEdits, AWaypointComesBetweenThoseOfItsLeg) {
  const core::Vec3 at{1000.0, 700.0, 5.0};
  const PathEdit edit = with_point_between(boat(), at);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_EQ(edit.point, std::size_t{2});
  EXPECT_EQ(edit.platform->waypoints.size(), std::size_t{4});
  EXPECT_EQ(edit.platform->waypoints[2].position_m, at);
  EXPECT_EQ(edit.platform->waypoints[3].position_m, boat().waypoints[2].position_m);
}

TEST(PathEdits, AStraightLegIsDividedAndFliesAsBefore) {
  const Platform before = plane();
  const core::Vec3 end = path_points(before, {}).back();
  const PathEdit edit = with_point_between(before, {3.0, 801.0, 0.0});
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_EQ(edit.platform->legs.size(), std::size_t{4});
  EXPECT_EQ(edit.platform->legs[0].length_m, 801.0);
  EXPECT_EQ(edit.platform->legs[1].length_m, 1199.0);
  expect_point(*edit.platform, edit.point, {0.0, 801.0, 0.0}, 1e-9);
  expect_point(*edit.platform, 4, end, 1e-9);
}

TEST(PathEdits, ATurnIsNotDivided) {
  const std::vector<core::Vec3> points = path_points(plane(), {});
  const PathEdit edit = with_point_between(plane(), 0.5 * (points[1] + points[2]) + core::Vec3{-100.0, 100.0, 0.0});
  EXPECT_FALSE(edit.platform);
  EXPECT_NE(edit.refusal.find("straight leg"), std::string::npos);
}

TEST(PathEdits, WaypointsGoOnToAPlace) {
  const PathEdit edit = with_point_behind(boat(), {0.0, 3000.0, 5.0}, 1.0);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_EQ(edit.point, std::size_t{3});
  expect_point(*edit.platform, 3, {0.0, 3000.0, 5.0}, 1e-9);
}

TEST(PathEdits, LegsGoOnByATurnAndAStraightLegThatEndsThere) {
  const core::Vec3 end = path_points(plane(), {}).back();
  for (const core::Vec3& way : {core::Vec3{1000.0, -3000.0, 0.0}, core::Vec3{2000.0, 2000.0, 0.0}}) {
    const PathEdit edit = with_point_behind(plane(), end + way, 1.0);
    ASSERT_TRUE(edit.platform) << edit.refusal;
    ASSERT_EQ(edit.platform->legs.size(), std::size_t{5});
    EXPECT_EQ(edit.platform->legs[3].radius_m, 500.0);
    expect_point(*edit.platform, edit.point, end + way, 3.0);
  }
  // Straight on there is no turn.
  const PathEdit on = with_point_behind(plane(), end + core::Vec3{800.0, 0.0, 0.0}, 1.0);
  ASSERT_TRUE(on.platform) << on.refusal;
  EXPECT_EQ(on.platform->legs.size(), std::size_t{4});
  expect_point(*on.platform, on.point, end + core::Vec3{800.0, 0.0, 0.0}, 1.0);
}

TEST(PathEdits, APlatformThatRestsLeavesOnWaypoints) {
  Platform resting;
  resting.position_m = {10.0, 20.0, 30.0};
  PathEdit edit = with_point_behind(resting, {500.0, 20.0, 30.0}, 1.0);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_EQ(edit.platform->path, Platform::Path::waypoints);
  EXPECT_EQ(edit.platform->waypoints[0].position_m, resting.position_m);
  EXPECT_GT(edit.platform->speed_mps, 0.0);
  // Another point needs a turn, and gets a bank for it.
  edit = with_point_behind(*edit.platform, {500.0, 800.0, 30.0}, 1.0);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_TRUE(route_of(*edit.platform).fault.empty());
}

TEST(PathEdits, PointsAreTakenOutAndTheLastTwoStay) {
  PathEdit edit = without_path_point(boat(), 1);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  EXPECT_EQ(edit.platform->waypoints.size(), std::size_t{2});
  EXPECT_EQ(edit.platform->waypoints[1].position_m, boat().waypoints[2].position_m);
  EXPECT_FALSE(without_path_point(*edit.platform, 0).platform);
  edit = without_path_point(plane(), 2);
  ASSERT_TRUE(edit.platform) << edit.refusal;
  expect_point(*edit.platform, 2, {0.0, 4000.0, 0.0}, 1e-9);
  EXPECT_NE(without_path_point(plane(), 0).refusal.find("start"), std::string::npos);
  EXPECT_FALSE(without_path_point(plane(), 9).platform);
}

TEST(PathEdits, WhatCannotBeFlownIsRefusedWithTheReason) {
  // Too near to the corner for the turn.
  const PathEdit edit = with_point_behind(boat(), {1001.0, 1999.0, 5.0}, 1.0);
  EXPECT_FALSE(edit.platform);
  EXPECT_FALSE(edit.refusal.empty());
  Platform orbit;
  orbit.path = Platform::Path::orbit;
  EXPECT_FALSE(with_point_behind(orbit, {}, 1.0).platform);
}

}  // namespace path_edits_test
}  // namespace sarsim::scene
