#include "radar/motion/motion_path.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/maths/constants.hpp"
#include "radar/motion/legs.hpp"
#include "radar/motion/motion_test_support.hpp"
#include "radar/motion/path_test_support.hpp"

namespace sarsim::radar {
namespace motion_path_test {

using core::Vec3;
using namespace motion_test;

SegmentPath legs() {
  const double deg = core::rad_per_deg;
  return leg_path({0.0, {100.0, 200.0, 3000.0}, 90.0 * deg, 120.0},
                  {StraightLeg{20.0, std::nullopt, 1.0},
                   TurnLeg{90.0 * deg, std::nullopt, TurnSide::right, {25.0 * deg, {}}},
                   ClimbLeg{std::nullopt, 30.0, 5.0, 1.0}})
      .path;
}

std::shared_ptr<const MotionPath> shared_path(MotionPath path) {
  return std::make_shared<const MotionPath>(std::move(path));
}

void expect_jets_of_state(const MotionPath& path, double time_s) {
  const PathState s = path.state(time_s);
  const PathState jets = path_state(path.jets(time_s), path.jerk_mps3(time_s));
  EXPECT_EQ(jets.position_world_m, s.position_world_m);
  EXPECT_EQ(jets.velocity_world_mps, s.velocity_world_mps);
  EXPECT_EQ(jets.acceleration_world_mps2, s.acceleration_world_mps2);
  EXPECT_EQ(jets.jerk_world_mps3, s.jerk_world_mps3);
}

TEST(MotionPath, RestsAtTheOriginWhereNothingIsGiven) {
  const MotionPath path;
  EXPECT_EQ(path.state(3.0).position_world_m, Vec3{});
  EXPECT_TRUE(path.fixed());
  EXPECT_FALSE(path.may_turn());
  EXPECT_EQ(path.acceleration_bound_mps2(), 0.0);
}

TEST(MotionPath, GivesJetsAndJerkOfItsState) {
  for (const double t : {-3.0, 0.4, 12.0, 25.0, 33.0, 250.0, 400.0}) {
    expect_jets_of_state(winding_path(), t);
    expect_jets_of_state(legs(), t);
    expect_jets_of_state(ephemeris(), t);
    expect_jets_of_state(RelativePath{shared_path(legs()), {30.0, -20.0, 10.0, 2.0}}, t);
  }
}

// Differences over +-1 ms: see path_test_support.hpp. The jerk of the winding path is constant between knots.
TEST(MotionPath, StatesAreDerivativesOfEachOther) {
  const MotionPath paths[] = {
      legs(), RelativePath{shared_path(legs()), {-200.0, 300.0, 50.0, 2.0}},
      RelativePath{shared_path(RelativePath{shared_path(legs()), {-50.0, 20.0, 0.0, 1.0}}), {0.0, -100.0, 0.0, 0.5}}};
  for (const MotionPath& path : paths)
    for (const double t : {-10.0, 5.0, 12.0, 40.0, 75.0, 100.0})
      expect_derivatives([&](double s) { return path.state(s); }, t);
  const MotionPath winding = winding_path();
  for (const double t : {0.3, 1.5, 2.4}) {
    const auto slope = [&](auto part) {
      return 500.0 * (part(winding.state(t + 1e-3)) - part(winding.state(t - 1e-3)));
    };
    const PathState s = winding.state(t);
    // A sixth of 1e-6 of the third derivative, below 500.
    expect_near_vector(slope([](const PathState& p) { return p.position_world_m; }), s.velocity_world_mps, 1e-4);
    expect_near_vector(slope([](const PathState& p) { return p.velocity_world_mps; }), s.acceleration_world_mps2, 1e-9);
    expect_near_vector(slope([](const PathState& p) { return p.acceleration_world_mps2; }), s.jerk_world_mps3, 1e-9);
  }
}

// The snap is compared with the quotient of jerks over +-1 ms; rounding of jerks of 1 m/s^3 gives 1e-12.
TEST(MotionPath, SnapIsTheDerivativeOfTheJerk) {
  core::Interpolator wave(core::SampledFunction{
      core::Interpolation::low_pass, {{0, 0}, {1, 3}, {2, 1}, {3, -2}, {4, 1}, {5, 2}, {6, 0}, {7, -1}, {8, 1}}});
  const MotionPath straight_or_round[] = {legs(), RelativePath{shared_path(legs()), {-200.0, 300.0, 50.0, 2.0}},
                                          winding_path()};
  const auto quotient = [](const MotionPath& path, double t) {
    return 500.0 * (path.jerk_mps3(t + 1e-3) - path.jerk_mps3(t - 1e-3));
  };
  for (const MotionPath& path : straight_or_round)
    for (const double t : {1.5, 12.0, 24.5, 28.0, 75.0}) expect_near_vector(path.snap_mps4(t), quotient(path, t), 1e-7);
  const MotionPath low_pass = FunctionPath{{wave, constant(0.0), constant(0.0)}};
  // Fourth derivatives up to 3 pi^4 m/s^4.
  for (const double t : {2.2, 3.7, 5.1}) {
    const double by_curvature =
        (wave.jet(t + 0.02).curvature - 2.0 * wave.jet(t).curvature + wave.jet(t - 0.02).curvature) / 4e-4;
    EXPECT_NEAR(low_pass.snap_mps4(t).x, by_curvature, 1e-2 * 300.0);
  }
}

// The ephemeris has a state every 10 s: errors of hermite_degree_7 are rounding, 2.3e-9 m and 2e-9 m/s.
TEST(MotionPath, FollowsAnEphemerisToRounding) {
  const MotionPath path = ephemeris();
  for (std::size_t tenth = 300; tenth <= 2700; tenth += 37) {
    const PathState s = path.state(0.1 * static_cast<double>(tenth));
    const OrbitState& exact = j2_orbit()[tenth];
    expect_near_vector(s.position_world_m, exact.position_m, 1e-8);
    expect_near_vector(s.velocity_world_mps, exact.velocity_mps, 1e-8);
    const auto acceleration = [](std::size_t i) {
      return orbit_test::j2_acceleration(j2_orbit()[i].position_m, j2_orbit()[i].velocity_mps);
    };
    expect_near_vector(s.acceleration_world_mps2, acceleration(tenth), 1e-9);
    expect_near_vector(s.jerk_world_mps3, 5.0 * (acceleration(tenth + 1) - acceleration(tenth - 1)), 3e-8);
  }
}

TEST(MotionPath, GoesOnFromTheNearestEndOfAnEphemerisWithConstantAcceleration) {
  const MotionPath path = ephemeris(12, 18);  // no states from 110 to 180 s
  const auto expect_from = [&](double end_s, double time_s) {
    const PathState end = path.state(end_s), s = path.state(time_s);
    const double dt = time_s - end_s;
    expect_near_vector(s.position_world_m,
                       end.position_world_m + dt * end.velocity_world_mps + 0.5 * dt * dt * end.acceleration_world_mps2,
                       1e-8);
    expect_near_vector(s.velocity_world_mps, end.velocity_world_mps + dt * end.acceleration_world_mps2, 1e-11);
    EXPECT_EQ(s.acceleration_world_mps2, end.acceleration_world_mps2);
    EXPECT_EQ(s.jerk_world_mps3, Vec3{});
  };
  expect_from(0.0, -20.0);
  expect_from(300.0, 333.0);
  expect_from(110.0, 144.0);
  expect_from(180.0, 146.0);
  EXPECT_LE(core::norm(path.state(144.0).acceleration_world_mps2), path.acceleration_bound_mps2());
}

TEST(MotionPath, KeepsTheBoundOfItsAcceleration) {
  const MotionPath paths[] = {winding_path(), legs(), ephemeris(),
                              RelativePath{shared_path(legs()), {-2000.0, 3000.0, 50.0, 2.0}},
                              RelativePath{shared_path(RelativePath{shared_path(legs()), {-500.0, 200.0, 0.0, 1.0}}),
                                           {0.0, -1000.0, 0.0, 0.5}}};
  for (const MotionPath& path : paths) {
    EXPECT_TRUE(std::isfinite(path.acceleration_bound_mps2()));
    for (int i = -20; i < 200; ++i)
      EXPECT_LE(core::norm(path.state(0.5 * i).acceleration_world_mps2), path.acceleration_bound_mps2() + 1e-9);
  }
  const auto winding = shared_path(winding_path());
  EXPECT_EQ(MotionPath(RelativePath{winding, {1.0, 0.0, 0.0, 0.0}}).acceleration_bound_mps2(),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(MotionPath(RelativePath{winding, {0.0, 0.0, 5.0, 1.0}}).acceleration_bound_mps2(),
            winding->acceleration_bound_mps2());
}

TEST(MotionPath, KnowsWhetherItMovesAndTurns) {
  const SegmentPath straight = leg_path({0.0, {}, 1.0, 120.0}, {StraightLeg{20.0, std::nullopt, 0.0}}).path;
  const SegmentPath rest(0.0, {PathSegment{10.0, {1.0, 2.0, 3.0}, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0}});
  const auto expect = [](const MotionPath& path, bool fixed, bool may_turn) {
    EXPECT_EQ(path.fixed(), fixed);
    EXPECT_EQ(path.may_turn(), may_turn);
    if (const auto beside = RelativePath{shared_path(path), {3.0, 2.0, 1.0, 0.0}}; true) {
      EXPECT_EQ(MotionPath(beside).fixed(), fixed);
      EXPECT_EQ(MotionPath(beside).may_turn(), may_turn);
    }
  };
  expect(FunctionPath{{constant(1.0), constant(2.0), constant(3.0)}}, true, false);
  expect(straight_path({}, {1.0, 2.0, 3.0}), false, false);
  expect(winding_path(), false, true);
  expect(legs(), false, true);
  expect(straight, false, false);
  expect(leg_path({0.0, {}, 1.0, 120.0}, {StraightLeg{20.0, std::nullopt, 1.0}, StraightLeg{9.0, std::nullopt, -1.0}})
             .path,
         false, false);
  expect(leg_path({0.0, {}, 1.0, 20.0}, {StraightLeg{20.0, std::nullopt, -1.0}}).path, false, true);  // comes to rest
  expect(leg_path({0.0, {}, 1.0, 20.0}, {ClimbLeg{std::nullopt, 20.0, 2.0}}).path, false, true);
  expect(rest, true, false);
  expect(SegmentPath{}, true, false);
  expect(ephemeris(), false, true);
}

}  // namespace motion_path_test
}  // namespace sarsim::radar
