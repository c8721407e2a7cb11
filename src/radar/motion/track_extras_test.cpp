#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "core/maths/constants.hpp"
#include "radar/motion/legs.hpp"
#include "radar/motion/motion_test_support.hpp"
#include "radar/motion/track.hpp"

namespace sarsim::radar {
namespace track_extras_test {

using core::Vec3;
using namespace motion_test;

constexpr double deg = core::rad_per_deg;
constexpr double infinite = std::numeric_limits<double>::infinity();

// A helicopter in a banked turn that also shakes, as parent of what it carries.
Motion fuselage() {
  Motion motion;
  motion.path =
      leg_path({0.0, {10.0, 20.0, 500.0}, 0.3, 60.0}, {TurnLeg{4.0 * core::pi, {}, TurnSide::right, {20.0 * deg, {}}}})
          .path;
  motion.attitude.kind = AttitudeLaw::Kind::coordinated;
  motion.sines = {{SineAxis::z, 0.05, 3.0, 0.2}, {SineAxis::roll, 0.02, 1.7, 1.0}};
  return motion;
}

constexpr double rotor_rad_per_s = 10.0 * core::pi;  // 300 rpm

Motion rotor() {
  Motion motion;
  motion.path = FunctionPath{{constant(0.5), constant(0.0), constant(2.0)}};
  motion.rotation_rate_rad_per_s = {0.0, 0.0, rotor_rad_per_s};
  return motion;
}

constexpr Vec3 tip{6.0, 0.0, 0.0};

// Relative to the fuselage: what is left of the tip's velocity without that of the point of the fuselage where it is.
TEST(CarriedTrack, RotorTipsRunWithTheirSpeedRoundTheFuselage) {
  const auto parent = shared_track(fuselage());
  Motion motion = rotor();
  motion.parent = parent;
  const Track track(motion, 1, "Rotor");
  for (const double t : {0.0, 1.234, 7.7}) {
    const Pose of_parent = parent->at(t, 3), pose = track.at(t, 3);
    const Vec3 tip_m = world_position_m(pose, tip);
    const Vec3 in_parent_m = core::transposed(of_parent.world_from_platform) * (tip_m - of_parent.position_world_m);
    const Vec3 relative_mps = world_velocity_mps(pose, tip) - world_velocity_mps(of_parent, in_parent_m);
    EXPECT_NEAR(core::norm(relative_mps), 188.496, 5e-4);
    EXPECT_NEAR(core::norm(relative_mps), 6.0 * rotor_rad_per_s, 1e-9);
    EXPECT_NEAR(in_parent_m.z, 2.0, 1e-9);
    EXPECT_NEAR(std::hypot(in_parent_m.x - 0.5, in_parent_m.y), 6.0, 1e-9);
    // The axis of the rotor is the z axis of the fuselage, and yaw is clockwise seen from above: +x to -y.
    EXPECT_LT(core::norm(column(pose.world_from_platform, 2) - column(of_parent.world_from_platform, 2)), 1e-14);
    EXPECT_NEAR(in_parent_m.y, -6.0 * std::sin(rotor_rad_per_s * t), 1e-8);
  }
}

// 31 rad/s: third derivatives 3e4 1/s^3, fourth ones 1e6; with h = 1e-5, h^2/6 of them, and rounding 1e-13/h.
TEST(CarriedTrack, DerivativesBelongToEachOther) {
  Motion motion = rotor();
  motion.parent = shared_track(fuselage());
  motion.sines = {{SineAxis::x, 0.01, 5.0, 0.0}, {SineAxis::pitch, 0.03, 5.0, 0.4}};
  motion.path = winding_path();
  const Track track(motion, 1, "Rotor");
  for (const double t : {0.31, 1.234, 2.7}) expect_derivatives_of(track, t, {1e-5, 1e-5, 1e-4, 1e-6, 1e-4});
}

// Ship, radar mast that rocks upon it, and an antenna that turns: the same by hand.
TEST(CarriedTrack, ChainsOfThreeAreProducts) {
  Motion ship = fuselage();
  ship.rotation_stddev_rad = {0.01, 0.02, 0.03};
  ship.position_stddev_m = {0.1, 0.2, 0.3};
  Motion mast;
  mast.path = winding_path();
  mast.aligned = true;
  mast.position_stddev_m = {0.01, 0.01, 0.01};
  Motion antenna = rotor();
  antenna.rotation_rate_rad_per_s = {0.1, 0.2, 2.0};
  antenna.rotation_stddev_rad = {0.001, 0.001, 0.001};
  const Track alone[] = {Track(ship, 1, "Ship"), Track(mast, 1, "Mast"), Track(antenna, 1, "Antenna")};
  mast.parent = shared_track(ship, "Ship");
  antenna.parent = shared_track(mast, "Mast");
  const Track chain(antenna, 1, "Antenna");
  for (const double t : {0.4, 1.6, 2.8}) {
    const Pose a = alone[0].at(t, 5), b = alone[1].at(t, 5), c = alone[2].at(t, 5), got = chain.at(t, 5);
    EXPECT_LT(core::norm(got.position_world_m - world_position_m(a, world_position_m(b, c.position_world_m))), 1e-12);
    EXPECT_LT(
        difference(got.world_from_platform, a.world_from_platform * b.world_from_platform * c.world_from_platform),
        1e-14);
    EXPECT_NE(got.position_world_m, chain.at(t, 6).position_world_m);  // jitter
    expect_derivatives_of(chain, t, {1e-5, 1e-5, 1e-4, 1e-6, 1e-4}, 5);
  }
}

TEST(CarriedTrack, SaysWhetherItIsFixedOrTurnsAndHowItAccelerates) {
  Motion still;
  still.path = FunctionPath{{constant(1.0), constant(2.0), constant(3.0)}};
  still.rotation_rad = {constant(0.1), constant(0.2), constant(0.3)};
  Motion straight = still;
  straight.path = straight_path({}, {1.0, 2.0, 3.0});
  Motion bent = still;
  bent.path = winding_path();
  Motion turning = rotor();
  const auto carried = [](const Motion& parent, Motion child) {
    child.parent = shared_track(parent);
    return Track(std::move(child), 1, "Child");
  };
  EXPECT_TRUE(carried(still, still).fixed());
  EXPECT_FALSE(carried(straight, still).fixed());
  EXPECT_FALSE(carried(still, straight).fixed());
  EXPECT_FALSE(carried(turning, still).fixed());
  EXPECT_FALSE(carried(straight, still).turns());
  EXPECT_TRUE(carried(turning, still).turns());
  EXPECT_TRUE(carried(still, turning).turns());
  const double bound = Track(bent, 1, "A").acceleration_bound_mps2();
  EXPECT_EQ(carried(still, bent).acceleration_bound_mps2(), bound);
  EXPECT_EQ(carried(bent, bent).acceleration_bound_mps2(), 2.0 * bound);
  EXPECT_EQ(carried(turning, still).acceleration_bound_mps2(), infinite);
  for (int i = -10; i <= 40; ++i)
    EXPECT_LE(core::norm(carried(bent, bent).acceleration_at(0.1 * i, 0).acceleration_world_mps2), 2.0 * bound);
  Motion shaky = still;
  shaky.rotation_stddev_rad[0] = 0.1;
  EXPECT_FALSE(carried(shaky, still).fixed());
  EXPECT_NE(carried(shaky, still).at(0.0, 1).position_world_m, carried(shaky, still).at(0.0, 2).position_world_m);
}

TEST(CarriedTrack, FixedOnesStandWhereTheProductSays) {
  Motion mast;
  mast.path = FunctionPath{{constant(1.0), constant(2.0), constant(3.0)}};
  mast.rotation_rad = {constant(0.1), constant(0.2), constant(0.3)};
  Motion antenna = mast;
  antenna.parent = shared_track(mast);
  const Pose pose = Track(antenna, 1, "A").at(12.0, 3);
  const core::Mat3 m = world_from_platform({0.1, 0.2, 0.3});
  EXPECT_LT(core::norm(pose.position_world_m - (Vec3{1, 2, 3} + m * Vec3{1, 2, 3})), 1e-14);
  EXPECT_LT(difference(pose.world_from_platform, m * m), 1e-15);
  EXPECT_EQ(pose.velocity_world_mps, Vec3{});
}

// The deviation of the parent's envelopes is found again through the nested steps.
TEST(CarriedTrack, ErrorStepsChangeNoBit) {
  Motion parent = fuselage();
  for (std::size_t i = 0; i < 3; ++i)
    parent.position_envelope[i] = parent.rotation_envelope[i] = spline({{0, 0}, {1, 1}, {2, 0}});
  Motion motion = rotor();
  motion.parent = shared_track(parent);
  motion.position_envelope[1] = spline({{0, 0}, {1, 1}, {2, 0}});
  const Track track(motion, 3, "A");
  Track::ErrorSteps steps, travel_steps;
  for (const double t : {0.1, 0.1001, 0.2, 0.1, 2.5, -1.0}) {
    const Pose pose = track.at(t, 4), again = track.at(t, 4, steps);
    EXPECT_EQ(again.position_world_m, pose.position_world_m);
    EXPECT_EQ(again.velocity_world_mps, pose.velocity_world_mps);
    EXPECT_EQ(again.world_from_platform_rate, pose.world_from_platform_rate);
    EXPECT_EQ(track.travel_at(t, 4, travel_steps).velocity_world_mps, pose.velocity_world_mps);
  }
  EXPECT_EQ(steps.of_parent.size(), 1u);
}

TEST(SineMotion, HasTheVelocityOfADopplerTone) {
  Motion motion;
  motion.path = straight_path({0.0, 0.0, 100.0}, {50.0, 0.0, 0.0});
  motion.sines = {{SineAxis::y, 0.002, 25.0, 0.3}, {SineAxis::y, 0.001, 40.0, 1.0}, {SineAxis::yaw, 0.01, 2.0, 0.0}};
  const Track track(motion, 1, "A");
  EXPECT_TRUE(track.turns());
  double fastest = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = 1e-3 * i;
    const Pose pose = track.at(t, 0);
    const double a = 2.0 * core::pi * 25.0 * t + 0.3, b = 2.0 * core::pi * 40.0 * t + 1.0;
    EXPECT_NEAR(pose.position_world_m.y, 0.002 * std::sin(a) + 0.001 * std::sin(b), 1e-15);
    EXPECT_NEAR(pose.velocity_world_mps.y,
                0.002 * 50.0 * core::pi * std::cos(a) + 0.001 * 80.0 * core::pi * std::cos(b), 1e-12);
    EXPECT_NEAR(pose.rotation_rad[2], 0.01 * std::sin(4.0 * core::pi * t), 1e-15);
    EXPECT_LE(core::norm(track.acceleration_at(t, 0).acceleration_world_mps2), track.acceleration_bound_mps2());
    fastest = std::max(fastest, pose.velocity_world_mps.y);
  }
  EXPECT_GT(fastest, 0.4);  // nearly both amplitudes: 0.565 m/s
  for (const double t : {0.1, 0.77}) expect_derivatives_of(track, t, {1e-5, 1e-6, 1e-4, 1e-9, 1e-8});
}

TEST(SineMotion, ShakesNoAlignmentAndMakesNothingFixed) {
  Motion motion;
  motion.path = straight_path({}, {50.0, 0.0, 0.0});
  motion.aligned = true;
  const core::Mat3 calm = Track(motion, 1, "A").at(0.3, 0).world_from_platform;
  motion.sines = {{SineAxis::y, 1.0, 2.0, 0.0}};
  EXPECT_FALSE(Track(motion, 1, "A").turns());
  EXPECT_EQ(Track(motion, 1, "A").at(0.3, 0).world_from_platform, calm);
  Motion still;
  still.sines = {{SineAxis::y, 1.0, 2.0, 0.0}};
  EXPECT_FALSE(Track(still, 1, "A").fixed());
  still.sines = {{SineAxis::y, 1.0, 0.0, 0.5}, {SineAxis::roll, 0.2, 0.0, 0.5}};  // a shift and a tilt for ever
  EXPECT_TRUE(Track(still, 1, "A").fixed());
  EXPECT_NEAR(Track(still, 1, "A").at(3.0, 0).position_world_m.y, std::sin(0.5), 1e-15);
  EXPECT_NEAR(Track(still, 1, "A").at(3.0, 0).rotation_rad[0], 0.2 * std::sin(0.5), 1e-15);
}

Motion with_errors(MotionPath path, bool follow) {
  Motion motion;
  motion.path = std::move(path);
  motion.errors_follow_path = follow;
  for (std::size_t i = 0; i < 3; ++i) motion.position_envelope[i] = spline({{0, 0}, {100, 1.0}, {200, 0}});
  return motion;
}

// Northward: along is y, left is -x. The deviations are those of the same noises along the axes of the world.
TEST(ErrorsAlongThePath, AreThoseOfTheWorldInOtherDirections) {
  const MotionPath north = straight_path({}, {0.0, 50.0, 0.0});
  const Track turned(with_errors(north, true), 1, "A"), plain(with_errors(north, false), 1, "A");
  Motion calm;
  calm.path = north;
  const Track nominal(calm, 1, "A");
  for (const double t : {1.0, 33.3}) {
    const Pose at = nominal.at(t, 0), a = plain.at(t, 0), b = turned.at(t, 0);
    const Vec3 e = a.position_world_m - at.position_world_m, f = b.position_world_m - at.position_world_m;
    EXPECT_LT(core::norm(f - Vec3{-e.y, e.x, e.z}), 1e-12);
    EXPECT_GT(std::abs(e.x), 1e-3);
    const Vec3 v = a.velocity_world_mps - at.velocity_world_mps, w = b.velocity_world_mps - at.velocity_world_mps;
    EXPECT_LT(core::norm(w - Vec3{-v.y, v.x, v.z}), 1e-12);
  }
  EXPECT_EQ(turned.acceleration_bound_mps2(), 0.0);
}

// In a turn, at a place within one of the 200 s/512 steps of the deviations.
TEST(ErrorsAlongThePath, TurnWithItAndMoveTheSpeed) {
  const MotionPath path =
      leg_path({0.0, {}, 0.3, 60.0}, {TurnLeg{-4.0 * core::pi, {}, TurnSide::shorter, {20.0 * deg, {}}}}).path;
  const Track track(with_errors(path, true), 1, "A");
  for (const double t : {10.1, 20.05}) expect_derivatives_of(track, t, {1e-3, 1e-6, 1e-6, 1e-9, 1e-9});
  Motion winding = with_errors(winding_path(), true);
  winding.rotation_stddev_rad[1] = 0.1;
  for (const double t : {1.3, 2.2}) expect_derivatives_of(Track(winding, 1, "A"), t, {1e-4, 1e-5, 1e-3, 1e-9, 1e-9});
  EXPECT_EQ(track.acceleration_bound_mps2(), infinite);
  EXPECT_FALSE(track.fixed());
}

// A wingman keeps his place: 30 m behind, 20 m to the right, whatever the leader does.
TEST(Formation, KeepsItsPlaceInTheLeadersAxes) {
  Motion leader = fuselage();
  leader.sines.clear();
  Motion wingman;
  wingman.path = RelativePath{std::make_shared<const MotionPath>(leader.path), {-30.0, -20.0, 0.0, 0.0}};
  wingman.attitude.kind = AttitudeLaw::Kind::coordinated;
  const Track first(leader, 1, "Leader"), second(wingman, 1, "Wingman");
  for (const double t : {0.5, 11.0, 60.0}) {
    const Pose a = first.at(t, 0), b = second.at(t, 0);
    const Vec3 way = b.position_world_m - a.position_world_m;
    const Vec3 ahead = (1.0 / core::norm(a.velocity_world_mps)) * a.velocity_world_mps;
    EXPECT_NEAR(core::dot(way, ahead), -30.0, 1e-9);
    EXPECT_NEAR(core::dot(way, Vec3{-ahead.y, ahead.x, 0.0}), -20.0, 1e-9);
    expect_derivatives_of(second, t, {1e-3, 1e-4, 1e-5, 1e-8, 1e-8});
    EXPECT_LE(core::norm(second.acceleration_at(t, 0).acceleration_world_mps2), second.acceleration_bound_mps2());
  }
}

// What many threads see is what one sees.
TEST(CarriedTrack, IsTheSameFromManyThreads) {
  Motion parent = fuselage();
  parent.position_envelope[0] = parent.rotation_envelope[1] = spline({{0, 0}, {1, 1}, {2, 0}});
  Motion motion = rotor();
  motion.path = RelativePath{std::make_shared<const MotionPath>(ephemeris()), {10.0, 20.0, 0.0, 0.0}};
  motion.attitude.kind = AttitudeLaw::Kind::nadir;
  motion.parent = shared_track(parent);
  const Track track(motion, 1, "A");
  constexpr std::size_t times = 60;
  const auto run = [&](std::vector<Pose>& poses) {
    Track::ErrorSteps steps;
    for (std::size_t i = 0; i < times; ++i) poses.push_back(track.at(0.05 * static_cast<double>(i), 2, steps));
  };
  std::vector<Pose> alone;
  run(alone);
  std::vector<std::vector<Pose>> seen(4);
  std::vector<std::thread> threads;
  for (auto& poses : seen) threads.emplace_back(run, std::ref(poses));
  for (std::thread& thread : threads) thread.join();
  for (const auto& poses : seen)
    for (std::size_t i = 0; i < times; ++i) {
      EXPECT_EQ(poses[i].position_world_m, alone[i].position_world_m);
      EXPECT_EQ(poses[i].world_from_platform_rate, alone[i].world_from_platform_rate);
    }
}

}  // namespace track_extras_test
}  // namespace sarsim::radar
