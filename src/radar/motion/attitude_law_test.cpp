#include "radar/motion/attitude_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/motion/legs.hpp"
#include "radar/motion/level_turn.hpp"
#include "radar/motion/motion_test_support.hpp"

namespace sarsim::radar {
namespace attitude_law_test {

using core::Vec3;
using namespace motion_test;
using Kind = AttitudeLaw::Kind;

constexpr double deg = core::rad_per_deg;

// Ten turns: clockwise where the angle is positive.
Motion turn_at(double angle_rad, double bank_rad) {
  Motion motion;
  motion.path =
      leg_path({0.0, {0.0, 0.0, 3000.0}, 0.0, 200.0}, {TurnLeg{angle_rad, {}, TurnSide::shorter, {bank_rad, {}}}}).path;
  motion.attitude.kind = Kind::coordinated;
  return motion;
}

Motion with_law(MotionPath path, Kind kind) {
  Motion motion;
  motion.path = std::move(path);
  motion.attitude.kind = kind;
  motion.attitude.earth = turning_earth;
  motion.attitude.point_world_m = {40.0, 30.0, 0.0};
  return motion;
}

void wind(Motion& motion) {
  motion.rotation_rad = {spline({{0, 0.0}, {1, 0.4}, {2, -0.3}, {3, 0.1}}),
                         spline({{0, 0.2}, {1, -0.1}, {2, 0.3}, {3, 0.0}}),
                         spline({{0, -0.5}, {1, 0.5}, {2, 0.2}, {3, 0.9}})};
  motion.rotation_rate_rad_per_s = {0.3, -0.2, 0.7};
}

// Gravity less acceleration lies in the plane of x and z: the beer does not spill. By physics alone, whatever the signs
// of the angles.
TEST(Coordinated, TurnsLeaveApparentGravityInThePlaneOfSymmetry) {
  for (const double side : {1.0, -1.0}) {
    const Track track(turn_at(side * 20.0 * core::pi, 30.0 * deg), 1, "A");
    for (const double t : {1.0, 50.0, 130.0}) {
      const Pose pose = track.at(t, 0);
      const PoseAcceleration a = track.acceleration_at(t, 0);
      const Vec3 apparent = Vec3{0.0, 0.0, -standard_gravity_mps2} - a.acceleration_world_mps2;
      EXPECT_NEAR(core::dot(apparent, column(pose.world_from_platform, 1)), 0.0, 1e-12);
      EXPECT_NEAR(core::dot(apparent, column(pose.world_from_platform, 2)),
                  -standard_gravity_mps2 / std::cos(30.0 * deg), 1e-12);
      // The y axis is to the left: up in a right turn.
      EXPECT_NEAR(column(pose.world_from_platform, 1).z, side * 0.5, 1e-12);
      EXPECT_NEAR(core::norm(column(pose.world_from_platform, 0) - (1.0 / 200.0) * pose.velocity_world_mps), 0.0,
                  1e-12);
      EXPECT_NEAR(core::dot(pose.velocity_world_mps, pose.velocity_world_mps) / core::norm(a.acceleration_world_mps2),
                  7064.801, 1e-3);
      EXPECT_NEAR(pose.rotation_rate_rad_per_s[2], side * 200.0 / 7064.801, 1e-8);
      EXPECT_EQ(pose.rotation_rate_rad_per_s[1], 0.0);
      EXPECT_NEAR(pose.rotation_rate_rad_per_s[0], 0.0, 1e-17);
    }
  }
}

TEST(Coordinated, AttackLiftsTheNose) {
  Motion motion = with_law(straight_path({}, {0.0, 80.0, 0.0}), Kind::coordinated);
  motion.attitude.attack_rad = 4.0 * deg;
  const Pose pose = Track(motion, 1, "A").at(3.0, 0);
  EXPECT_NEAR(column(pose.world_from_platform, 0).z, std::sin(4.0 * deg), 1e-15);
  EXPECT_NEAR(column(pose.world_from_platform, 0).y, std::cos(4.0 * deg), 1e-15);
}

// A winding path has jerks, so the roll turns. Third derivatives in time of angles are below 1000 1/s^3 and fourth ones
// below 1e5 1/s^4: see track_test.cpp.
TEST(Coordinated, RatesAndAccelerationsAreDerivatives) {
  for (const bool winds : {false, true}) {
    Motion motion = with_law(winding_path(), Kind::coordinated);
    motion.attitude.attack_rad = 0.1;
    if (winds) wind(motion);
    const Track track(motion, 1, "A");
    EXPECT_TRUE(track.turns());
    for (const double t : {0.3, 0.75, 1.4, 2.2, 2.9}) expect_derivatives_of(track, t, {1e-4, 1e-6, 1e-9, 2e-6, 2e-4});
    EXPECT_GT(std::abs(coordinated_roll(motion.path.state(1.4), {}).slope), 0.05);
  }
  const Track turn(turn_at(20.0 * core::pi, 0.7), 1, "A");
  for (const double t : {1.0, 50.0}) expect_derivatives_of(turn, t, {1e-3, 1e-6, 1e-8, 1e-9, 1e-9});
}

// Angular velocities of the axes below 5 rad/s at 30 m from the centre and the point: rates to h^2/6 5^3 = 2e-7 1/s,
// second derivatives to h^2/6 times fourth derivatives below 1e5.
TEST(AttitudeLaws, DerivativesBelongToEachOtherOnAWindingPath) {
  for (const Kind kind : {Kind::zero_doppler, Kind::nadir, Kind::look_at})
    for (const FlightDirection flight : {FlightDirection::earth_fixed, FlightDirection::inertial})
      for (const bool winds : {false, true}) {
        Motion motion = with_law(winding_path(), kind);
        motion.attitude.earth = {{0.3, -0.2, 0.9}, {20.0, -40.0, -60.0}};
        motion.attitude.flight = flight;
        if (winds) wind(motion);
        motion.rotation_stddev_rad = {0.1, 0.1, 0.1};
        const Track track(motion, 1, "A");
        for (const double t : {0.3, 0.75, 1.4, 2.2}) expect_derivatives_of(track, t, {1e-4, 1e-6, 1e-9, 2e-6, 2e-4});
      }
}

// In orbit: positions of 7e6 m have 1e-9 m, so quotients over +-1 s have 1e-9 m/s, and 1e-6/6 of third derivatives:
// that of the velocity is 1e-5 m/s^4. Turning 1e-3 rad/s: 1e-9/6.
TEST(AttitudeLaws, DerivativesBelongToEachOtherInOrbit) {
  for (const Kind kind : {Kind::zero_doppler, Kind::nadir, Kind::look_at})
    for (const FlightDirection flight : {FlightDirection::earth_fixed, FlightDirection::inertial}) {
      Motion motion = with_law(ephemeris(), kind);
      motion.attitude.flight = flight;
      motion.attitude.point_world_m = 0.9 * j2_orbit()[1500].position_m;
      motion.rotation_rate_rad_per_s = {0.0, 0.001, 0.0};
      const Track track(motion, 1, "A");
      for (const double t : {55.3, 141.0, 230.7}) expect_derivatives_of(track, t, {1.0, 3e-3, 1e-5, 1e-6, 1e-7});
    }
}

// Total zero-Doppler steering: what is in the y-z plane and fixed on the Earth neither comes nor goes.
TEST(ZeroDoppler, BeamsAcrossSeeNoRadialSpeedOfTheEarth) {
  const Track track(with_law(ephemeris(), Kind::zero_doppler), 1, "A");
  for (const double t : {12.0, 150.0, 290.0}) {
    const Pose pose = track.at(t, 0);
    const Vec3 x = column(pose.world_from_platform, 0), y = column(pose.world_from_platform, 1),
               z = column(pose.world_from_platform, 2);
    for (const double look : {-50.0, -30.0, 0.0, 35.0, 60.0}) {
      const Vec3 beam = std::sin(look * deg) * y - std::cos(look * deg) * z;
      EXPECT_NEAR(core::dot(beam, pose.velocity_world_mps), 0.0, 1e-11);
    }
    EXPECT_GT(core::dot(x, pose.velocity_world_mps), 7000.0);
    EXPECT_GT(core::dot(z, pose.position_world_m), 0.999 * core::norm(pose.position_world_m));
    EXPECT_GT(core::dot(core::cross(x, y), z), 0.999999);
  }
}

TEST(Nadir, HasItsZAxisFromTheCentreOfTheEarth) {
  const Pose pose = Track(with_law(ephemeris(), Kind::nadir), 1, "A").at(100.0, 0);
  const Vec3& p = pose.position_world_m;
  EXPECT_LT(core::norm(column(pose.world_from_platform, 2) - (1.0 / core::norm(p)) * p), 1e-15);
}

TEST(LookAt, HasItsZAxisAwayFromThePointAndTurnsAsItPasses) {
  const Motion motion = with_law(straight_path({0.0, 0.0, 1000.0}, {100.0, 0.0, 0.0}), Kind::look_at);
  const Track track(motion, 1, "A");
  for (const double t : {-10.0, 0.4, 20.0}) {
    const Pose pose = track.at(t, 0);
    const Vec3 away = pose.position_world_m - motion.attitude.point_world_m;
    EXPECT_LT(core::norm(column(pose.world_from_platform, 2) - (1.0 / core::norm(away)) * away), 1e-15);
    EXPECT_GT(column(pose.world_from_platform, 0).x, 0.0);
  }
  // Straight above the point's line: w = v/h, seen across.
  const Vec3 spin = track.at(0.4, 0).world_from_platform_rate * Vec3{0.0, 0.0, 1.0};
  EXPECT_NEAR(core::norm(spin), 100.0 / std::hypot(1000.0, 30.0), 1e-12);
  EXPECT_TRUE(track.turns());
  EXPECT_FALSE(track.fixed());
}

// A roll of a platform within its axes: an antenna that looks to the right.
TEST(AttitudeLaws, OwnAnglesTurnThePlatformWithinTheAxes) {
  Motion motion = with_law(ephemeris(), Kind::zero_doppler);
  const core::Mat3 axes = Track(motion, 1, "A").at(77.0, 0).world_from_platform;
  motion.rotation_rad = {constant(0.1), constant(0.2), constant(0.3)};
  const Pose pose = Track(motion, 1, "A").at(77.0, 0);
  EXPECT_LT(difference(pose.world_from_platform, axes * world_from_platform({0.1, 0.2, 0.3})), 1e-15);
  motion.aligned = true;
  EXPECT_EQ(Track(motion, 1, "A").at(77.0, 0).world_from_platform, pose.world_from_platform);
}

std::shared_ptr<const AttitudeTable> tumbling_table() {
  AttitudeSamples samples;
  for (int k = 0; k <= 24; ++k) {
    const double t = 0.25 * k;
    samples.time_s.push_back(t);
    samples.world_from_platform.push_back(
        quaternion_of(world_from_platform({0.4 * std::sin(0.7 * t), 0.3 * t, -0.2 * t * t})));
  }
  return std::make_shared<const AttitudeTable>(std::get<AttitudeTable>(AttitudeTable::from(samples)));
}

TEST(Quaternions, AreTheAttitudeAndItsDerivatives) {
  Motion motion = with_law(winding_path(), Kind::quaternions);
  motion.attitude.table = tumbling_table();
  EXPECT_LT(difference(Track(motion, 1, "A").at(1.5, 0).world_from_platform,
                       motion.attitude.table->at(1.5).world_from_platform.matrix),
            1e-15);
  wind(motion);
  const Track track(motion, 1, "A");
  for (const double t : {-2.0, 0.3, 0.7, 1.4, 2.2, 7.1})
    expect_derivatives_of(track, t, {1e-4, 1e-6, 1e-9, 1e-6, 2e-5});
}

TEST(AttitudeLaws, SayWhetherTheyTurn) {
  const auto turns = [](Motion motion) { return Track(std::move(motion), 1, "A").turns(); };
  const auto fixed = [](Motion motion) { return Track(std::move(motion), 1, "A").fixed(); };
  const FunctionPath still{{constant(1.0), constant(2.0), constant(3.0)}};
  for (const Kind kind : {Kind::zero_doppler, Kind::nadir, Kind::look_at}) {
    EXPECT_FALSE(turns(with_law(still, kind)));
    EXPECT_TRUE(fixed(with_law(still, kind)));
    EXPECT_TRUE(turns(with_law(straight_path({}, {1.0, 0.0, 0.0}), kind)));
    EXPECT_FALSE(fixed(with_law(straight_path({}, {1.0, 0.0, 0.0}), kind)));
  }
  EXPECT_FALSE(turns(with_law(straight_path({}, {1.0, 0.0, 0.0}), Kind::coordinated)));
  EXPECT_TRUE(turns(with_law(winding_path(), Kind::coordinated)));
  EXPECT_TRUE(fixed(with_law(still, Kind::coordinated)));
  Motion motion = with_law(still, Kind::quaternions);
  motion.attitude.table = tumbling_table();
  EXPECT_TRUE(turns(motion));
  EXPECT_FALSE(fixed(motion));
  motion.attitude.table = std::make_shared<const AttitudeTable>(
      std::get<AttitudeTable>(AttitudeTable::from({{0.0}, {quaternion_of(world_from_platform({0.1, 0.2, 0.3}))}})));
  EXPECT_FALSE(turns(motion));
  EXPECT_TRUE(fixed(motion));
  EXPECT_LT(difference(Track(motion, 1, "A").at(9.0, 0).world_from_platform, world_from_platform({0.1, 0.2, 0.3})),
            1e-15);
}

}  // namespace attitude_law_test
}  // namespace sarsim::radar
