#include "radar/motion/legs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "core/maths/constants.hpp"
#include "radar/motion/level_turn.hpp"
#include "radar/motion/path_test_support.hpp"

namespace sarsim::radar {
namespace legs_test {

constexpr double deg = core::rad_per_deg;

TurnSize bank(double bank_deg) { return {bank_deg * deg, std::nullopt}; }
TurnSize radius(double metres) { return {std::nullopt, metres}; }
StraightLeg straight(double length_m) { return {std::nullopt, length_m, 0.0}; }
StraightLeg for_seconds(double duration_s, double acceleration = 0.0) {
  return {duration_s, std::nullopt, acceleration};
}
TurnLeg turn(double angle_deg, const TurnSize& size) {
  return {angle_deg * deg, std::nullopt, TurnSide::shorter, size};
}
TurnLeg turn_to(double heading_deg, TurnSide side) { return {std::nullopt, heading_deg * deg, side, bank(30.0)}; }
ClimbLeg climb_to(double height_m, double rate, double rounding = 0.0) {
  return {height_m, std::nullopt, rate, rounding};
}
ClimbLeg climb_for(double duration_s, double rate, double rounding = 0.0) {
  return {std::nullopt, duration_s, rate, rounding};
}

PathStart start(double speed = 120.0) { return {5.0, {1000.0, -2000.0, 3000.0}, 70.0 * deg, speed}; }

SegmentPath path_of(const std::vector<Leg>& legs, const PathStart& from = start()) {
  PathResult made = leg_path(from, legs);
  EXPECT_EQ(made.fault, "");
  return std::move(made.path);
}

std::string fault_of(const Leg& leg, double speed = 120.0) {
  return leg_path(start(speed), {for_seconds(1.0), leg}).fault;
}

// The numbers of the specification, computed there in another language.
TEST(LevelTurn, HasTheRadiiOfTheTable) {
  EXPECT_NEAR(turn_radius_m(200.0, 30.0 * deg), 7064.801, 5e-4);
  EXPECT_NEAR(turn_radius_m(120.0, 25.0 * deg), 3148.975, 5e-4);
  EXPECT_NEAR(turn_radius_m(100.0, 45.0 * deg), 1019.716, 5e-4);
  EXPECT_NEAR(load_factor(30.0 * deg), 1.15470, 5e-6);
  EXPECT_NEAR(200.0 / turn_radius_m(200.0, 30.0 * deg) / deg, 1.62201, 5e-6);
  EXPECT_NEAR(turn_bank_rad(120.0, turn_radius_m(120.0, 25.0 * deg)), 25.0 * deg, 1e-15);
}

TEST(LevelTurn, BringsAnglesWithinHalfATurn) {
  EXPECT_NEAR(half_turn_angle_rad(370.0 * deg), 10.0 * deg, 1e-14);
  EXPECT_NEAR(half_turn_angle_rad(-190.0 * deg), 170.0 * deg, 1e-14);
  EXPECT_EQ(half_turn_angle_rad(-core::pi), core::pi);
  EXPECT_EQ(half_turn_angle_rad(core::pi), core::pi);
}

TEST(LegPath, TurnsTakeTheTimesOfTheTable) {
  EXPECT_NEAR(path_of({turn(360.0, bank(30.0))}, start(200.0)).duration_s(), 221.947, 5e-4);
  EXPECT_NEAR(path_of({turn(-180.0, bank(25.0))}).duration_s(), 82.440, 5e-4);
}

// 6297.950 m is twice the radius that is rounded to 3148.975 m.
TEST(LegPath, HalfACircleLeadsBackItsDiameterAside) {
  const SegmentPath path = path_of({turn(180.0, bank(25.0))});
  const PathState end = path.at(path.start_s() + path.duration_s());
  const core::Vec3 right{std::cos(70.0 * deg), -std::sin(70.0 * deg), 0.0};
  expect_near_vector(end.position_world_m, start().position_world_m + 6297.950 * right, 1e-3);
  expect_near_vector(end.velocity_world_mps, -120.0 * core::direction(70.0 * deg, 0.0), 1e-11);
}

// MathWorks' example of constturn: x 500, vx 0, y 0, vy 100, 12 degrees per second to the left.
TEST(LegPath, FollowsThePublishedStatesOfAConstantTurn) {
  const PathStart from{0.0, {500.0, 0.0, 0.0}, 0.0, 100.0};
  const SegmentPath path = path_of({turn(-90.0, radius(100.0 / (12.0 * deg)))}, from);
  expect_near_vector(path.at(1.0).position_world_m, {489.5662, 99.2705, 0.0}, 1e-4);
  expect_near_vector(path.at(1.0).velocity_world_mps, {-20.7912, 97.8148, 0.0}, 1e-4);
  expect_near_vector(path.at(0.1).position_world_m, {499.8953, 9.9993, 0.0}, 1e-4);
  expect_near_vector(path.at(0.1).velocity_world_mps, {-2.0942, 99.9781, 0.0}, 1e-4);
}

TEST(LegPath, ARacetrackClosesToANanometre) {
  for (const TurnSide side : {TurnSide::right, TurnSide::left}) {
    std::vector<Leg> legs = racetrack(20e3, bank(25.0), side);
    const SegmentPath path = path_of(legs);
    EXPECT_NEAR(path.duration_s(), 2.0 * (20e3 + core::pi * turn_radius_m(120.0, 25.0 * deg)) / 120.0, 1e-9);
    const PathState end = path.at(path.start_s() + path.duration_s());
    expect_near_vector(end.position_world_m, start().position_world_m, 1e-9);
    expect_near_vector(end.velocity_world_mps, 120.0 * core::direction(70.0 * deg, 0.0), 1e-11);
    EXPECT_LT(path.largest_step_mps(), 1e-11);
  }
}

TEST(LegPath, TurnsToAHeadingByTheGivenSide) {
  const auto angle = [](double heading_deg, TurnSide side) {
    const SegmentPath path = path_of({turn_to(heading_deg, side)});
    const PathSegment& segment = path.segments()[1];
    return segment.turn_rate_rad_per_s * segment.duration_s / deg;
  };
  EXPECT_NEAR(angle(100.0, TurnSide::shorter), 30.0, 1e-9);
  EXPECT_NEAR(angle(350.0, TurnSide::shorter), -80.0, 1e-9);
  EXPECT_NEAR(angle(100.0, TurnSide::left), -330.0, 1e-9);
  EXPECT_NEAR(angle(350.0, TurnSide::right), 280.0, 1e-9);
  EXPECT_NEAR(angle(100.0, TurnSide::right), 30.0, 1e-9);
  EXPECT_NEAR(angle(350.0, TurnSide::left), -80.0, 1e-9);
  EXPECT_NEAR(angle(70.0 + 360.0, TurnSide::right), 0.0, 1e-6);  // already there, not once around
  EXPECT_NEAR(angle(70.0 - 1e-12, TurnSide::right), 0.0, 1e-6);
}

TEST(LegPath, AcceleratesOverALength) {
  const SegmentPath path = path_of({StraightLeg{std::nullopt, 1000.0, 2.0}});
  const PathState end = path.at(path.start_s() + path.duration_s());
  EXPECT_NEAR(core::norm(end.position_world_m - start().position_world_m), 1000.0, 1e-9);
  EXPECT_NEAR(core::norm(end.velocity_world_mps), std::sqrt(120.0 * 120.0 + 2.0 * 2.0 * 1000.0), 1e-10);
}

TEST(LegPath, BrakesToAStandstillAndStays) {
  for (const Leg& leg : {Leg(for_seconds(60.0, -2.0)), Leg(StraightLeg{std::nullopt, 3600.0, -2.0})}) {
    const SegmentPath path = path_of({leg, for_seconds(10.0)});
    EXPECT_NEAR(core::norm(path.at(5.0 + 65.0).velocity_world_mps), 0.0, 1e-6);
    EXPECT_NEAR(core::norm(path.at(1e4).position_world_m - start().position_world_m), 3600.0, 1e-6);
  }
}

TEST(LegPath, ClimbsToAHeightAtItsRate) {
  const SegmentPath up = path_of({climb_to(3600.0, 10.0)});
  EXPECT_NEAR(up.duration_s(), 60.0, 1e-12);
  EXPECT_NEAR(up.at(5.0 + 30.0).velocity_world_mps.z, 10.0, 0.0);
  EXPECT_NEAR(up.at(5.0 + 100.0).position_world_m.z, 3600.0, 1e-9);
  EXPECT_EQ(up.at(5.0 + 100.0).velocity_world_mps.z, 0.0);
  EXPECT_EQ(up.at(-50.0).position_world_m.z, 3000.0);
  EXPECT_NEAR(up.largest_step_mps(), 10.0, 1e-9);
  const SegmentPath down = path_of({climb_to(2400.0, 10.0)});
  EXPECT_NEAR(down.at(5.0 + 60.0).position_world_m.z, 2400.0, 1e-9);
  EXPECT_NEAR(path_of({climb_for(20.0, -3.0)}).at(100.0).position_world_m.z, 2940.0, 1e-9);
}

TEST(LegPath, RoundedClimbsReachTheirHeightWithoutAStep) {
  struct Case {
    ClimbLeg leg;
    double height_m, duration_s;
  };
  // 2 m/s^2 to 10 m/s: 5 s and 25 m at each end. 50 m are just reached; 8 m in a triangle of 2 * sqrt(8/2).
  for (const Case& c :
       {Case{climb_to(3600.0, 10.0, 2.0), 3600.0, 65.0}, Case{climb_to(2400.0, 10.0, 2.0), 2400.0, 65.0},
        Case{climb_to(3050.0, 10.0, 2.0), 3050.0, 10.0}, Case{climb_to(3008.0, 10.0, 2.0), 3008.0, 4.0},
        Case{climb_for(60.0, -10.0, 2.0), 2450.0, 60.0}, Case{climb_for(4.0, 10.0, 2.0), 3008.0, 4.0}}) {
    const SegmentPath path = path_of({c.leg});
    EXPECT_NEAR(path.duration_s(), c.duration_s, 1e-9);
    EXPECT_NEAR(path.at(1000.0).position_world_m.z, c.height_m, 1e-9);
    EXPECT_LT(path.largest_step_mps(), 1e-9);
    EXPECT_NEAR(path.acceleration_bound_mps2(), 2.0, 1e-12);
  }
}

TEST(LegPath, ClimbsNowhereWhereItIsThere) {
  for (const double rounding : {0.0, 2.0}) EXPECT_EQ(path_of({climb_to(3000.0, 10.0, rounding)}).duration_s(), 0.0);
}

TEST(LegPath, HoldsStraightOrInCircles) {
  const SegmentPath on = path_of({HoldLeg{30.0, std::nullopt, TurnSide::right}});
  EXPECT_NEAR(core::norm(on.at(35.0).position_world_m - start().position_world_m), 3600.0, 1e-9);
  const double r = turn_radius_m(120.0, 25.0 * deg);
  for (const TurnSide side : {TurnSide::right, TurnSide::left}) {
    const SegmentPath round = path_of({HoldLeg{1000.0, bank(25.0), side}});
    const double sign = side == TurnSide::right ? 1.0 : -1.0;
    const core::Vec3 centre =
        start().position_world_m + sign * r * core::Vec3{std::cos(70.0 * deg), -std::sin(70.0 * deg), 0.0};
    for (double t = 5.0; t < 1000.0; t += 77.7) EXPECT_NEAR(core::norm(round.at(t).position_world_m - centre), r, 1e-9);
    EXPECT_NEAR(round.acceleration_bound_mps2(), standard_gravity_mps2 * std::tan(25.0 * deg), 1e-12);
  }
}

std::vector<Leg> journey() {
  return {for_seconds(20.0, 1.5),       turn(100.0, bank(30.0)), climb_to(3500.0, 8.0, 1.0),
          turn_to(0.0, TurnSide::left), straight(5000.0),        HoldLeg{50.0, radius(4000.0), TurnSide::left}};
}

TEST(LegPath, DerivativesBelongToEachOther) {
  const SegmentPath path = path_of(journey());
  double begin = path.start_s();
  for (const PathSegment& segment : path.segments()) {
    if (segment.duration_s > 0.0)
      for (const double share : {0.1, 0.5, 0.9})
        expect_derivatives([&path](double t) { return path.at(t); }, begin + share * segment.duration_s);
    begin += segment.duration_s;
  }
  expect_derivatives([&path](double t) { return path.at(t); }, -100.0);
  expect_derivatives([&path](double t) { return path.at(t); }, begin + 100.0);
}

TEST(LegPath, IsContinuousAndWithinItsBound) {
  const SegmentPath path = path_of(journey());
  EXPECT_LT(path.largest_step_mps(), 1e-11);
  const double end = path.start_s() + path.duration_s();
  for (double t = path.start_s() - 10.0; t < end + 10.0; t += 0.1) {
    EXPECT_LE(core::norm(path.at(t).acceleration_world_mps2), path.acceleration_bound_mps2() * (1.0 + 1e-14));
    EXPECT_LT(core::norm(path.at(t + 0.1).position_world_m - path.at(t).position_world_m), 0.1 * 151.0);
  }
}

TEST(LegPath, GoesStraightBeforeAndAfter) {
  const SegmentPath path = path_of(journey());
  expect_near_vector(path.at(-5.0).position_world_m,
                     start().position_world_m - 10.0 * 120.0 * core::direction(70.0 * deg, 0.0), 1e-9);
  const double end = path.start_s() + path.duration_s();
  const PathState last = path.at(end);
  expect_near_vector(path.at(end + 100.0).position_world_m, last.position_world_m + 100.0 * last.velocity_world_mps,
                     1e-9);
  EXPECT_EQ(path.at(end + 100.0).acceleration_world_mps2, core::Vec3());
}

TEST(LegPath, DependsOnTimeAloneOnEveryThread) {
  const SegmentPath path = path_of(journey());
  std::vector<core::Vec3> forwards(100), backwards(100);
  {
    const std::jthread one([&] {
      for (std::size_t i = 0; i < 100; ++i) forwards[i] = path.at(2.5 * static_cast<double>(i)).position_world_m;
    });
    const std::jthread other([&] {
      for (std::size_t i = 100; i-- > 0;) backwards[i] = path.at(2.5 * static_cast<double>(i)).position_world_m;
    });
  }
  EXPECT_EQ(forwards, backwards);
}

TEST(LegPath, WithoutLegsIsALine) {
  const SegmentPath path = path_of({});
  EXPECT_EQ(path.duration_s(), 0.0);
  expect_near_vector(path.at(15.0).position_world_m,
                     start().position_world_m + 1200.0 * core::direction(70.0 * deg, 0.0), 1e-9);
  EXPECT_EQ(SegmentPath().at(3.0).position_world_m, core::Vec3());
}

TEST(LegPath, SaysWhatIsWrong) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(leg_path({0.0, {}, 0.0, -1.0}, {}).fault, "start: the speed is negative");
  EXPECT_EQ(leg_path({0.0, {0.0, nan, 0.0}, 0.0, 1.0}, {}).fault, "start: a number is not finite");
  EXPECT_EQ(fault_of(turn(90.0, bank(0.0))), "leg 2 (turn): the bank is 0");
  EXPECT_EQ(fault_of(turn(90.0, bank(90.0))), "leg 2 (turn): the bank is not between 0 and 90 degrees");
  EXPECT_EQ(fault_of(turn(90.0, radius(0.0))), "leg 2 (turn): the radius is not positive");
  EXPECT_EQ(fault_of(turn(90.0, TurnSize{})), "leg 2 (turn): neither bank nor radius is given");
  EXPECT_EQ(fault_of(turn(90.0, TurnSize{0.1, 3.0})), "leg 2 (turn): both bank and radius are given");
  EXPECT_EQ(fault_of(turn(90.0, bank(nan))), "leg 2 (turn): a number is not finite");
  EXPECT_EQ(fault_of(turn(90.0, radius(10.0)), 0.0), "leg 2 (turn): the speed is 0");
  EXPECT_EQ(fault_of(TurnLeg{std::nullopt, std::nullopt, TurnSide::right, bank(20.0)}),
            "leg 2 (turn): neither angle nor heading is given");
  EXPECT_EQ(fault_of(straight(-1.0)), "leg 2 (straight): the length is negative");
  EXPECT_EQ(fault_of(for_seconds(-1.0)), "leg 2 (straight): the duration is negative");
  EXPECT_EQ(fault_of(for_seconds(61.0, -2.0)), "leg 2 (straight): the speed comes to 0 before its end");
  EXPECT_EQ(fault_of(StraightLeg{std::nullopt, 3601.0, -2.0}), "leg 2 (straight): the speed comes to 0 before its end");
  EXPECT_EQ(fault_of(straight(1.0), 0.0), "leg 2 (straight): the speed comes to 0 before its end");
  EXPECT_EQ(fault_of(for_seconds(1e308, 1e10)), "leg 2 (straight): it leads beyond all numbers");
  EXPECT_EQ(fault_of(climb_to(4000.0, 0.0)), "leg 2 (climb): the rate to a height is not positive");
  EXPECT_EQ(fault_of(climb_to(4000.0, 1.0, -1.0)), "leg 2 (climb): the vertical acceleration is negative");
  EXPECT_EQ(fault_of(climb_for(-4.0, 1.0)), "leg 2 (climb): the duration is negative");
  EXPECT_EQ(fault_of(ClimbLeg{}), "leg 2 (climb): neither height nor duration is given");
  EXPECT_EQ(fault_of(HoldLeg{-1.0, std::nullopt, TurnSide::right}), "leg 2 (hold): the duration is negative");
  EXPECT_EQ(fault_of(HoldLeg{1.0, radius(-2.0), TurnSide::right}), "leg 2 (hold): the radius is not positive");
}

}  // namespace legs_test
}  // namespace sarsim::radar
