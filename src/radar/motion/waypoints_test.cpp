#include "radar/motion/waypoints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radar/motion/level_turn.hpp"
#include "radar/motion/path_test_support.hpp"

namespace sarsim::radar {
namespace waypoints_test {

constexpr double deg = core::rad_per_deg;

// East, then north-east, then north-west with a sharp corner; 120 m/s.
WaypointRoute route() {
  WaypointRoute r;
  r.start_s = 10.0;
  r.waypoints = {
      {{0.0, 0.0, 1000.0}, {}}, {{20e3, 0.0, 1500.0}, {}}, {{40e3, 15e3, 1500.0}, {}}, {{30e3, 40e3, 900.0}, {}}};
  r.speed_mps = 120.0;
  r.bank_rad = 25.0 * deg;
  return r;
}

SegmentPath path_of(const WaypointRoute& r) {
  PathResult made = waypoint_path(r);
  EXPECT_EQ(made.fault, "");
  return std::move(made.path);
}

double nearest_m(const SegmentPath& path, const core::Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (double t = path.start_s(); t < path.start_s() + path.duration_s(); t += 0.01)
    nearest = std::min(nearest, core::norm(path.at(t).position_world_m - point));
  return nearest;
}

TEST(WaypointPath, StartsAndEndsAtItsPoints) {
  const SegmentPath path = path_of(route());
  expect_near_vector(path.at(10.0).position_world_m, route().waypoints.front().position_world_m, 1e-9);
  expect_near_vector(path.at(10.0 + path.duration_s()).position_world_m, route().waypoints.back().position_world_m,
                     1e-8);
}

// A corner by the angle a is passed at R (1/cos(a/2) - 1), at the height of the waypoint.
TEST(WaypointPath, PassesACornerAsAFilletDoes) {
  const SegmentPath path = path_of(route());
  const double turn = 90.0 * deg - std::atan2(20.0, 15.0);
  const double radius = 3148.975;
  EXPECT_NEAR(nearest_m(path, route().waypoints[1].position_world_m), radius * (1.0 / std::cos(0.5 * turn) - 1.0), 0.1);
}

TEST(WaypointPath, IsAsLongAsItsArcsAndTangents) {
  const WaypointRoute r = route();
  const double a1 = 90.0 * deg - std::atan2(20.0, 15.0);
  const double a2 = std::atan2(20.0, 15.0) - std::atan2(-10.0, 25.0);
  const double radius = turn_radius_m(120.0, 25.0 * deg);
  double length = 20e3 + std::hypot(20e3, 15e3) + std::hypot(10e3, 25e3);
  for (const double a : {a1, a2}) length += radius * (a - 2.0 * std::tan(0.5 * a));
  EXPECT_NEAR(path_of(r).duration_s(), length / 120.0, 1e-9);
}

TEST(WaypointPath, KeepsItsLevelSpeedAndTurnsAtItsBank) {
  const SegmentPath path = path_of(route());
  EXPECT_NEAR(path.acceleration_bound_mps2(), standard_gravity_mps2 * std::tan(25.0 * deg), 1e-12);
  for (double t = 0.0; t < path.duration_s() + 20.0; t += 0.37) {
    const core::Vec3 v = path.at(t).velocity_world_mps;
    EXPECT_NEAR(std::hypot(v.x, v.y), 120.0, 1e-9);
  }
}

// The speed steps up and down by the difference of the gradients alone.
TEST(WaypointPath, ClimbsEvenlyFromPointToPoint) {
  const SegmentPath path = path_of(route());
  EXPECT_LT(path.largest_step_mps(), 120.0 * (500.0 / 19e3 + 600.0 / 25e3));
  double highest = 0.0;
  for (double t = 10.0; t < 10.0 + path.duration_s(); t += 0.1)
    highest = std::max(highest, path.at(t).position_world_m.z);
  EXPECT_NEAR(highest, 1500.0, 1e-9);
  EXPECT_LT(path.at(0.0).position_world_m.z, 1000.0);
}

TEST(WaypointPath, LevelRoutesHaveNoStepOfVelocity) {
  WaypointRoute r = route();
  for (Waypoint& point : r.waypoints) point.position_world_m.z = 1000.0;
  EXPECT_LT(path_of(r).largest_step_mps(), 1e-9);
}

TEST(WaypointPath, DerivativesBelongToEachOther) {
  const SegmentPath path = path_of(route());
  double begin = path.start_s();
  for (const PathSegment& segment : path.segments()) {
    expect_derivatives([&path](double t) { return path.at(t); }, begin + 0.5 * segment.duration_s);
    begin += segment.duration_s;
  }
}

TEST(WaypointPath, ChangesSpeedAtOnceOrBehindTheTurn) {
  WaypointRoute r = route();
  r.waypoints[1].speed_mps = 150.0;
  EXPECT_NEAR(path_of(r).largest_step_mps(), 30.0, 0.1);
  r.acceleration_mps2 = 1.0;
  for (Waypoint& point : r.waypoints) point.position_world_m.z = 1000.0;
  const SegmentPath path = path_of(r);
  EXPECT_LT(path.largest_step_mps(), 1e-9);
  const double end = path.start_s() + path.duration_s();
  EXPECT_NEAR(core::norm(path.at(end).velocity_world_mps), 150.0, 1e-9);
  expect_near_vector(path.at(end).position_world_m, r.waypoints.back().position_world_m, 1e-8);
}

TEST(WaypointPath, NeedsNoBankWithoutTurns) {
  WaypointRoute r = route();
  r.waypoints.resize(2);
  r.bank_rad = 0.0;
  EXPECT_NEAR(path_of(r).duration_s(), 20e3 / 120.0, 1e-9);
}

TEST(WaypointPath, GoesStraightThroughPointsOnALine) {
  WaypointRoute r = route();
  r.waypoints = {{{0.0, 0.0, 0.0}, {}}, {{0.0, 1e3, 0.0}, {}}, {{0.0, 3e3, 0.0}, {}}};
  EXPECT_NEAR(path_of(r).duration_s(), 25.0, 1e-12);
  EXPECT_EQ(path_of(r).acceleration_bound_mps2(), 0.0);
}

TEST(WaypointPath, SaysWhatDoesNotFit) {
  WaypointRoute r = route();
  r.waypoints[1].position_world_m = {2e3, 0.0, 0.0};
  r.waypoints[2].position_world_m = {2e3, 9e3, 0.0};
  // A right angle at 2: R = 3148.9754 m are needed of 2 km.
  EXPECT_EQ(
      waypoint_path(r).fault,
      "the leg from waypoint 1 to 2 must be 3.14898 km long and is 2 km; the turn at waypoint 2 takes 3.14898 km");
  r = route();
  r.waypoints[1].speed_mps = 400.0;
  r.acceleration_mps2 = 1.0;
  EXPECT_NE(waypoint_path(r).fault.find("the change of speed takes 72.8 km"), std::string::npos);
  r = route();
  r.waypoints[2].position_world_m = {10e3, 0.0, 0.0};
  EXPECT_EQ(waypoint_path(r).fault, "waypoint 2: the route turns back on itself");
}

TEST(WaypointPath, SaysWhatIsWrong) {
  const auto fault = [](auto change) {
    WaypointRoute r = route();
    change(r);
    return waypoint_path(r).fault;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault([](auto& r) { r.waypoints.resize(1); }), "a route needs at least two waypoints");
  EXPECT_EQ(fault([](auto& r) { r.bank_rad = 0.0; }), "the bank is 0");
  EXPECT_EQ(fault([](auto& r) { r.bank_rad = 2.0; }), "the bank is not between 0 and 90 degrees");
  EXPECT_EQ(fault([](auto& r) { r.speed_mps = -1.0; }), "waypoint 1: the speed is not positive");
  EXPECT_EQ(fault([](auto& r) { r.waypoints[2].speed_mps = 0.0; }), "waypoint 3: the speed is not positive");
  EXPECT_EQ(fault([](auto& r) { r.acceleration_mps2 = -1.0; }), "the acceleration is negative");
  EXPECT_EQ(fault([](auto& r) { r.speed_mps = nan; }), "a number is not finite");
  EXPECT_EQ(fault([](auto& r) { r.waypoints[3].position_world_m.y = nan; }), "waypoint 4: a number is not finite");
  EXPECT_EQ(fault([](auto& r) {
              r.waypoints[3].position_world_m = {1.7e308, -1.7e308, 0.0};
            }),
            "the leg from waypoint 3 to 4 is too long for a number");
  EXPECT_EQ(fault([](auto& r) {
              r.waypoints[1].position_world_m = {0.0, 0.0, 7.0};
            }),
            "the leg from waypoint 1 to 2 has no length, seen from above");
}

}  // namespace waypoints_test
}  // namespace sarsim::radar
