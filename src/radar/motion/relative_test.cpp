#include "radar/motion/relative.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "radar/motion/legs.hpp"
#include "radar/motion/path_test_support.hpp"

namespace sarsim::radar {
namespace relative_test {

SegmentPath leader() {
  const double deg = core::rad_per_deg;
  return leg_path({0.0, {100.0, 200.0, 3000.0}, 90.0 * deg, 120.0},
                  {StraightLeg{20.0, std::nullopt, 1.0},
                   TurnLeg{90.0 * deg, std::nullopt, TurnSide::right, {25.0 * deg, {}}},
                   ClimbLeg{std::nullopt, 30.0, 5.0, 1.0}})
      .path;
}

TEST(RelativeState, IsAheadToTheLeftAndAbove) {
  const SegmentPath path = leader();
  const auto parent = [&path](double t) { return path.at(t); };
  const PathState s = relative_state(parent, {30.0, 20.0, 10.0, 0.0}, 0.0);  // the leader goes east
  expect_near_vector(s.position_world_m, {130.0, 220.0, 3010.0}, 1e-9);
  expect_near_vector(s.velocity_world_mps, {120.0, 0.0, 0.0}, 1e-9);
}

TEST(RelativeState, FollowsWithADelay) {
  const SegmentPath path = leader();
  const auto parent = [&path](double t) { return path.at(t); };
  for (const double t : {-3.0, 10.0, 33.0, 200.0}) {
    const PathState s = relative_state(parent, {0.0, 0.0, 0.0, 7.5}, t);
    EXPECT_EQ(s.position_world_m, path.at(t - 7.5).position_world_m);
    EXPECT_EQ(s.velocity_world_mps, path.at(t - 7.5).velocity_world_mps);
  }
}

// On the outer side of a right turn the companion flies faster by the ratio of the radii.
TEST(RelativeState, FliesFasterOutsideATurn) {
  const SegmentPath path = leader();
  const double inside = 140.0 / path.segments()[2].turn_rate_rad_per_s;
  const PathState s = relative_state([&path](double t) { return path.at(t); }, {0.0, 500.0, 0.0, 0.0}, 30.0);
  EXPECT_NEAR(core::norm(s.velocity_world_mps), 140.0 * (inside + 500.0) / inside, 1e-9);
  EXPECT_NEAR(core::norm(s.acceleration_world_mps2),
              core::dot(s.velocity_world_mps, s.velocity_world_mps) / (inside + 500.0), 1e-9);
}

TEST(RelativeState, DerivativesBelongToEachOther) {
  const SegmentPath path = leader();
  const auto companion = [&path](double t) {
    return relative_state([&path](double u) { return path.at(u); }, {-200.0, 300.0, 50.0, 2.0}, t);
  };
  for (const double t : {-10.0, 5.0, 12.0, 40.0, 75.0, 100.0}) expect_derivatives(companion, t);
  const auto companion_of_companion = [&companion](double t) {
    return relative_state(companion, {-200.0, 0.0, 0.0, 1.0}, t);
  };
  for (const double t : {-10.0, 5.0, 40.0, 100.0}) expect_derivatives(companion_of_companion, t);
}

// A parent whose heading's rate changes: position, velocity and acceleration are still derivatives of each other.
TEST(RelativeState, IsExactUpToTheAccelerationForAnyParent) {
  const auto parent = [](double t) {
    return PathState{{100.0 * t, t * t * t, 0.0}, {100.0, 3.0 * t * t, 0.0}, {0.0, 6.0 * t, 0.0}, {0.0, 6.0, 0.0}};
  };
  const auto companion = [&parent](double t) { return relative_state(parent, {0.0, 10.0, 0.0, 0.0}, t); };
  constexpr double h = 1e-3;
  for (const double t : {1.0, 4.0, 9.0}) {
    const PathState before = companion(t - h), now = companion(t), then = companion(t + h);
    expect_near_vector((0.5 / h) * (then.position_world_m - before.position_world_m), now.velocity_world_mps, 1e-5);
    expect_near_vector((0.5 / h) * (then.velocity_world_mps - before.velocity_world_mps), now.acceleration_world_mps2,
                       1e-5);
  }
}

TEST(RelativeState, FacesNorthWhereTheParentRestsOrRises) {
  for (const core::Vec3& v : {core::Vec3{}, core::Vec3{0.0, 0.0, 9.0}}) {
    const PathState s = relative_state(
        [&v](double) {
          return PathState{{1.0, 2.0, 3.0}, v, {}, {}};
        },
        {5.0, 1.0, 0.0, 0.0}, 4.0);
    expect_near_vector(s.position_world_m, {0.0, 7.0, 3.0}, 1e-12);
    EXPECT_EQ(s.velocity_world_mps, v);
  }
}

}  // namespace relative_test
}  // namespace sarsim::radar
