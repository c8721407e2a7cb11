#include "scene/edit/path_points.hpp"

#include <gmock/gmock.h>

#include "core/maths/constants.hpp"

namespace sarsim::scene {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Leg straight(double length_m) {
  Leg leg;
  leg.length_m = length_m;
  return leg;
}

Leg turn(double degrees, double radius_m) {
  Leg leg;
  leg.kind = Leg::Kind::turn;
  leg.angle = core::Angle::from_deg(degrees);
  leg.radius_m = radius_m;
  return leg;
}

// North from (100, 0), a quarter to the right, east.
Platform circuit() {
  Platform platform;
  platform.path = Platform::Path::legs;
  platform.start_m = {100.0, 0.0, 500.0};
  platform.speed_mps = 50.0;
  platform.legs = {straight(1000.0), turn(90.0, 300.0), straight(2000.0)};
  return platform;
}

double apart(const core::Vec3& a, const core::Vec3& b) { return core::norm(a - b); }

TEST(PathPoints, AreTheStartAndTheEndsOfLegs) {
  const std::vector<core::Vec3> points = path_points(circuit(), {});
  ASSERT_THAT(points, SizeIs(4));
  EXPECT_LT(apart(points[0], {100.0, 0.0, 500.0}), 1e-9);
  EXPECT_LT(apart(points[1], {100.0, 1000.0, 500.0}), 1e-9);
  EXPECT_LT(apart(points[2], {400.0, 1300.0, 500.0}), 1e-9);
  EXPECT_LT(apart(points[3], {2400.0, 1300.0, 500.0}), 1e-9);
  EXPECT_EQ(path_point_name(circuit(), 0), "start");
  EXPECT_EQ(path_point_name(circuit(), 2), "end of leg 2");
}

TEST(PathPoints, EndWhereALegCannotBeFlown) {
  Platform platform = circuit();
  platform.legs[1].radius_m = 0.0;
  EXPECT_THAT(path_points(platform, {}), SizeIs(2));
  platform.path = Platform::Path::stationary;
  EXPECT_THAT(path_points(platform, {}), IsEmpty());
}

TEST(PathPoints, OfWaypointsAreThese) {
  Platform platform;
  platform.path = Platform::Path::waypoints;
  platform.waypoints = {{{0.0, 0.0, 10.0}, 0.0}, {{500.0, 0.0, 20.0}, 0.0}};
  ASSERT_THAT(path_points(platform, {}), SizeIs(2));
  EXPECT_EQ(path_point_name(platform, 1), "waypoint 2");
  const auto moved = with_path_point(platform, {}, 1, {600.0, 70.0, 30.0}, 1.0);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->waypoints[1].position_m, (core::Vec3{600.0, 70.0, 30.0}));
  EXPECT_EQ(moved->waypoints[0], platform.waypoints[0]);
  EXPECT_FALSE(with_path_point(platform, {}, 2, {}, 1.0));
}

TEST(PathPoints, MovingTheStartCarriesThePathAlong) {
  const auto moved = with_path_point(circuit(), {}, 0, {0.0, 10.0, 700.0}, 1.0);
  ASSERT_TRUE(moved);
  EXPECT_LT(apart(path_points(*moved, {})[3], {2300.0, 1310.0, 700.0}), 1e-9);
}

TEST(PathPoints, TheFirstLegTurnsTheCourse) {
  const auto moved = with_path_point(circuit(), {}, 1, {3100.0, 4000.0, 500.0}, 1.0);
  ASSERT_TRUE(moved);
  EXPECT_DOUBLE_EQ(moved->legs[0].length_m, 5000.0);
  EXPECT_DOUBLE_EQ(moved->course.deg(), 36.87);  // atan2(3000, 4000)
  EXPECT_EQ(moved->legs[1], circuit().legs[1]);
  EXPECT_EQ(moved->legs[2], circuit().legs[2]);
}

TEST(PathPoints, ALegBehindATurnChangesHowFarItTurns) {
  // From the end of a right turn about (400, 1000) of 300 m: straight to the south-east, tangent at 135 degrees.
  const double root = std::sqrt(0.5);
  const core::Vec3 tangent{400.0 + 300.0 * root, 1000.0 + 300.0 * root, 500.0};
  const core::Vec3 to = tangent + 1000.0 * core::Vec3{root, -root, 0.0};
  const auto moved = with_path_point(circuit(), {}, 3, to, 0.01);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->legs[1].angle.deg(), 135.0, 1e-3);
  EXPECT_NEAR(moved->legs[2].length_m, 1000.0, 0.03);
  EXPECT_LT(apart(path_points(*moved, {})[3], to), 0.05);
  EXPECT_EQ(moved->legs[0], circuit().legs[0]);

  Platform by_heading = circuit();
  by_heading.legs[1].kind = Leg::Kind::turn_to;
  by_heading.legs[1].heading = core::Angle::from_deg(90.0);
  const auto other = with_path_point(by_heading, {}, 3, to, 0.01);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->legs[1].heading.deg(), 135.0, 1e-3);
}

TEST(PathPoints, ATurnStaysOnItsArc) {
  // Nearest to a place right above the middle of the turn: there, after a half turn less 90 degrees.
  const auto moved = with_path_point(circuit(), {}, 2, {400.0, 9000.0, 500.0}, 0.1);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->legs[1].angle.deg(), 90.0, 0.1);
  const auto back = with_path_point(circuit(), {}, 2, {-9600.0, 11000.0, 500.0}, 0.1);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->legs[1].angle.deg(), 45.0, 0.1);
}

TEST(PathPoints, AClimbChangesItsRateToo) {
  Platform platform = circuit();
  Leg climb;
  climb.kind = Leg::Kind::climb;
  climb.duration_s = 20.0;
  climb.rate_mps = 5.0;
  platform.legs = {climb};
  const auto moved = with_path_point(platform, {}, 1, {100.0, 2000.0, 900.0}, 0.01);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->legs[0].duration_s, 40.0, 1e-3);
  EXPECT_NEAR(moved->legs[0].rate_mps, 10.0, 1e-3);
  EXPECT_LT(apart(path_points(*moved, {})[1], {100.0, 2000.0, 900.0}), 0.05);
}

TEST(PathPoints, AClimbToAHeightEndsThere) {
  Platform platform = circuit();
  Leg climb;
  climb.kind = Leg::Kind::climb_to;
  climb.height_m = 800.0;
  climb.rate_mps = 5.0;
  platform.legs = {climb};
  const auto moved = with_path_point(platform, {}, 1, {100.0, 2000.0, 900.0}, 0.01);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->legs[0].height_m, 900.0, 0.02);
  EXPECT_NEAR(moved->legs[0].rate_mps, 10.0, 2e-3);
}

TEST(PathPoints, AHoldChangesItsDuration) {
  Platform platform = circuit();
  platform.legs = {straight(1000.0), Leg{}};
  platform.legs[1].kind = Leg::Kind::hold;
  platform.legs[1].duration_s = 10.0;
  const auto moved = with_path_point(platform, {}, 2, {100.0, 2500.0, 500.0}, 1.0);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->legs[1].duration_s, 30.0, 0.02);
  EXPECT_EQ(moved->legs[0], platform.legs[0]);
}

TEST(PathPoints, AnAcceleratedLegEndsWhereItIsPut) {
  Platform platform = circuit();
  platform.legs = {Leg{}};
  platform.legs[0].duration_s = 20.0;
  platform.legs[0].acceleration_mps2 = 2.0;
  const auto moved = with_path_point(platform, {}, 1, {100.0 - 1200.0, 1600.0, 500.0}, 0.01);
  ASSERT_TRUE(moved);
  // 50 t + t^2 = 2000
  EXPECT_NEAR(moved->legs[0].duration_s, 26.2348, 2e-3);
  EXPECT_NEAR(moved->course.deg(), -36.8699, 1e-3);
}

TEST(PathPoints, OfManyLegsAreFoundAtOnce) {
  Platform platform = circuit();
  platform.legs.assign(20'000, straight(10.0));
  const std::vector<core::Vec3> points = path_points(platform, {});
  ASSERT_THAT(points, SizeIs(20'001));
  EXPECT_LT(apart(points.back(), {100.0, 200e3, 500.0}), 1e-6);
}

TEST(PathPoints, WhatIsNoPlaceMovesNothing) {
  EXPECT_FALSE(with_path_point(circuit(), {}, 3, {std::nan(""), 0.0, 0.0}, 1.0));
  EXPECT_FALSE(with_path_point(circuit(), {}, 4, {}, 1.0));
}

Platform satellite() {
  Platform platform;
  platform.path = Platform::Path::state;
  platform.state_position_m = {7078e3, 0.0, 0.0};
  platform.state_velocity_mps = {0.0, -1500.0, 7500.0};
  return platform;
}

// Its anchor is below the satellite: x to the east is ECEF y, y to the north ECEF z, z up ECEF x.
World earth() {
  World world;
  world.frame = World::Frame::earth;
  return world;
}

TEST(PathPoints, OfAStateAreItsPlaceAndTheEndOfItsVelocity) {
  const std::vector<core::Vec3> points = path_points(satellite(), earth());
  ASSERT_THAT(points, SizeIs(2));
  EXPECT_LT(apart(points[0], {0.0, 0.0, 699863.0}), 1e-6);
  EXPECT_LT(apart(points[1], {-90e3, 450e3, 699863.0}), 1e-6);
  EXPECT_EQ(path_point_name(satellite(), 0), "state at time 0");
  EXPECT_EQ(path_point_name(satellite(), 1), "velocity");
  EXPECT_THAT(path_points(satellite(), {}), IsEmpty());
  EXPECT_FALSE(with_path_point(satellite(), {}, 0, {}, 1.0));
}

TEST(WithPathPoint, TurnsTheVelocityOfASatelliteWithTheGround) {
  // A quarter round the Earth to the north: what went north goes down there, what went west goes on to the west.
  const core::Vec3 pole{0.0, 7000e3, -6378137.0};
  const auto moved = with_path_point(satellite(), earth(), 0, pole, 1.0);
  ASSERT_TRUE(moved);
  EXPECT_LT(apart(moved->state_position_m, {0.0, 0.0, 7000e3}), 1e-6);
  EXPECT_LT(apart(moved->state_velocity_mps, {-7500.0, -1500.0, 0.0}), 0.1);
  // Wherever it goes: as fast, and it climbs as much.
  for (const core::Vec3& to : {core::Vec3{1e6, -2e6, 5e5}, core::Vec3{-4e6, 1e5, 1e6}}) {
    const auto other = with_path_point(satellite(), earth(), 0, to, 1.0);
    ASSERT_TRUE(other);
    EXPECT_NEAR(core::norm(other->state_velocity_mps), core::norm(satellite().state_velocity_mps), 0.1);
    EXPECT_NEAR(core::dot(other->state_velocity_mps, other->state_position_m) / core::norm(other->state_position_m),
                0.0, 0.1);
  }
}

TEST(WithPathPoint, ChangesTheVelocityAlone) {
  const auto moved = with_path_point(satellite(), earth(), 1, {60e3, 450e3, 699863.0 + 6e3}, 10.0);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->state_position_m, satellite().state_position_m);
  EXPECT_LT(apart(moved->state_velocity_mps, {100.0, 1000.0, 7500.0}), 1e-9);
}

}  // namespace
}  // namespace sarsim::scene
