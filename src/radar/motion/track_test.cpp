#include "radar/motion/track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace track_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

core::Interpolator constant(double value) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, value}}});
}

core::Interpolator smooth(std::vector<core::Knot> knots) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::cubic, std::move(knots)});
}

// A winding path and winding angles, knots 1 s apart.
Motion winding() {
  Motion motion;
  motion.path = FunctionPath{{smooth({{0, 0}, {1, 30}, {2, 70}, {3, 90}}), smooth({{0, 5}, {1, 0}, {2, 20}, {3, 60}}),
                              smooth({{0, 100}, {1, 110}, {2, 105}, {3, 130}})}};
  motion.rotation_rad = {smooth({{0, 0.0}, {1, 0.4}, {2, -0.3}, {3, 0.1}}),
                         smooth({{0, 0.2}, {1, -0.1}, {2, 0.3}, {3, 0.0}}),
                         smooth({{0, -0.5}, {1, 0.5}, {2, 0.2}, {3, 0.9}})};
  motion.rotation_rate_rad_per_s = {0.3, -0.2, 0.7};
  return motion;
}

void expect_near(const core::Vec3& a, const core::Vec3& b, double bound) { EXPECT_LT(core::norm(a - b), bound); }

void expect_near(const core::Mat3& a, const core::Mat3& b, double bound) {
  for (std::size_t i = 0; i < 3; ++i) expect_near(a.row[i], b.row[i], bound);
}

// The example of 10, 20, 30 degrees, printed to four places.
TEST(WorldFromPlatform, TurnsTheAxesOfTheWorkedExample) {
  const core::Mat3 m =
      world_from_platform({10.0 * core::rad_per_deg, 20.0 * core::rad_per_deg, 30.0 * core::rad_per_deg});
  expect_near(m * core::Vec3{1, 0, 0}, {0.8138, -0.4698, 0.3420}, 1e-4);
  expect_near(m * core::Vec3{0, 1, 0}, {0.5438, 0.8232, -0.1632}, 1e-4);
  expect_near(m * core::Vec3{0, 0, 1}, {-0.2049, 0.3188, 0.9254}, 1e-4);
}

TEST(WorldFromPlatform, TurnsEachAxisTheDocumentedWay) {
  constexpr double quarter = core::pi / 2.0;
  const double bound = 4.0 * epsilon;
  expect_near(world_from_platform({0, 0, quarter}) * core::Vec3{1, 0, 0}, {0, -1, 0}, bound);  // yaw: +x to -y
  expect_near(world_from_platform({0, quarter, 0}) * core::Vec3{1, 0, 0}, {0, 0, 1}, bound);   // pitch: nose up
  expect_near(world_from_platform({quarter, 0, 0}) * core::Vec3{0, 1, 0}, {0, 0, -1}, bound);  // roll: +y down
  expect_near(world_from_platform({quarter, 0, 0}) * core::Vec3{0, 0, 1}, {0, 1, 0}, bound);
}

TEST(WorldFromPlatform, AppliesRollBeforePitchBeforeYaw) {
  const core::Mat3 product =
      world_from_platform({0, 0, 0.3}) * world_from_platform({0, 0.2, 0}) * world_from_platform({0.1, 0, 0});
  expect_near(world_from_platform({0.1, 0.2, 0.3}), product, 10.0 * epsilon);
}

TEST(WorldFromPlatform, IsARotation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  for (int i = 0; i < 100; ++i) {
    const core::Mat3 m = world_from_platform({angle(random), angle(random), angle(random)});
    expect_near(m * core::transposed(m), core::Mat3(), 20.0 * epsilon);
    EXPECT_NEAR(core::dot(core::cross(m.row[0], m.row[1]), m.row[2]), 1.0, 20.0 * epsilon);
  }
}

// Central differences over +-h: third derivatives of the entries are below the cube of the summed rates (3), so
// h^2/6 * 27 plus rounding 2 epsilon/h.
TEST(WorldFromPlatformRate, IsTheDerivativeOfTheRotation) {
  constexpr double h = 1e-4;
  const std::array<double, 3> a{0.3, -0.9, 2.0};
  const std::array<double, 3> rate{0.5, -1.0, 1.5};
  const auto at = [&](double t) {
    return world_from_platform({a[0] + rate[0] * t, a[1] + rate[1] * t, a[2] + rate[2] * t});
  };
  const core::Mat3 quotient = (0.5 / h) * (at(h) + -1.0 * at(-h));
  expect_near(world_from_platform_rate(a, rate), quotient, h * h / 6.0 * 27.0 + 4.0 * epsilon / h);
}

constexpr core::Vec3 wing{3.0, -4.0, 12.0};

// A time of a track, with its poses a step before and after.
struct Neighbourhood {
  static constexpr double step_s = 1e-4;
  const Track& track;
  double time_s;
  Pose before;
  Pose after;
};

// Calls `body` with times of the winding track, aligned and not.
template <class Body>
void each_neighbourhood(const Body& body) {
  for (const bool aligned : {false, true}) {
    Motion motion = winding();
    motion.aligned = aligned;
    const Track track(motion, 1, "A");
    for (const double t : {0.3, 0.75, 1.4, 2.2, 2.9})
      body(Neighbourhood{track, t, track.at(t - Neighbourhood::step_s, 0), track.at(t + Neighbourhood::step_s, 0)});
  }
}

// Speeds below 60 m/s with third derivatives of the path below 500 m/s^3; numbers up to 200 m lose 200 epsilon/h. The
// rotation's entries have third derivatives below 1000.
TEST(Track, VelocityAndTurningAreDerivativesOfPositionAndRotation) {
  each_neighbourhood([](const Neighbourhood& n) {
    constexpr double h = Neighbourhood::step_s;
    const double bound = h * h / 6.0 * 1e3 + 200.0 * epsilon / h;
    const Pose pose = n.track.at(n.time_s, 0);
    expect_near(pose.velocity_world_mps, (0.5 / h) * (n.after.position_world_m - n.before.position_world_m), bound);
    expect_near(pose.world_from_platform_rate,
                (0.5 / h) * (n.after.world_from_platform + -1.0 * n.before.world_from_platform), bound);
    expect_near(world_velocity_mps(pose, wing),
                (0.5 / h) * (world_position_m(n.after, wing) - world_position_m(n.before, wing)), 20.0 * bound);
  });
}

// The same with second derivatives of a cubic path (third derivatives below 500 m/s^3, those of rotations below 1000
// 1/s^3 and fourth ones below 1e5 1/s^4, aligned ones among them).
TEST(Track, AccelerationsAreDerivativesOfVelocityAndTurning) {
  each_neighbourhood([](const Neighbourhood& n) {
    constexpr double h = Neighbourhood::step_s;
    const double bound = h * h / 6.0 * 1e5 + 200.0 * epsilon / h;
    const PoseAcceleration found = n.track.acceleration_at(n.time_s, 0);
    expect_near(found.acceleration_world_mps2, (0.5 / h) * (n.after.velocity_world_mps - n.before.velocity_world_mps),
                bound);
    expect_near(found.world_from_platform_acceleration,
                (0.5 / h) * (n.after.world_from_platform_rate + -1.0 * n.before.world_from_platform_rate), bound);
    expect_near(world_acceleration_mps2(found, wing),
                (0.5 / h) * (world_velocity_mps(n.after, wing) - world_velocity_mps(n.before, wing)), 20.0 * bound);
  });
}

// On a turntable of w rad/s a point r from the axis is drawn inwards by w^2 r.
TEST(Track, ATurntablesPointHasTheCentripetalAcceleration) {
  Motion motion;
  motion.rotation_rate_rad_per_s = {0.0, 0.0, 3.0};
  const Track track(motion, 1, "A");
  const Pose pose = track.at(0.7, 0);
  const core::Vec3 arm{2.0, 1.0, 5.0};
  const core::Vec3 level{2.0, 1.0, 0.0};
  expect_near(world_acceleration_mps2(track.acceleration_at(0.7, 0), arm), -9.0 * (pose.world_from_platform * level),
              1000.0 * epsilon);
}

TEST(Track, StraightFlightsAndBrokenLinesHaveNoAcceleration) {
  Motion motion;
  motion.path = FunctionPath{
      {core::Interpolator({core::Interpolation::linear, {{0, 0}, {1, 10}, {2, 5}}}), constant(0), constant(0)}};
  motion.aligned = true;
  motion.position_envelope[1] = core::Interpolator({core::Interpolation::linear, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}});
  const PoseAcceleration found = Track(motion, 1, "A").acceleration_at(1.3, 0);
  EXPECT_EQ(found.acceleration_world_mps2, core::Vec3{});
  expect_near(found.world_from_platform_acceleration * core::Vec3{1, 2, 3}, {}, epsilon);
}

TEST(Track, AlignedPlatformHasItsXAxisAlongTheVelocityAndItsYAxisLevel) {
  Motion motion;
  motion.path = winding().path;
  motion.aligned = true;
  const Track track(motion, 1, "A");
  for (const double t : {-1.0, 0.0, 0.4, 1.0, 1.9, 2.7, 5.0}) {
    const Pose pose = track.at(t, 0);
    const core::Vec3 v = pose.velocity_world_mps;
    expect_near(pose.world_from_platform * core::Vec3{1, 0, 0}, (1.0 / core::norm(v)) * v, 10.0 * epsilon);
    EXPECT_NEAR((pose.world_from_platform * core::Vec3{0, 1, 0}).z, 0.0, 10.0 * epsilon);
    EXPECT_GT((pose.world_from_platform * core::Vec3{0, 0, 1}).z, 0.0);
  }
}

TEST(Track, RollOfAnAlignedPlatformLeavesTheXAxisAlone) {
  Motion motion;
  motion.path = winding().path;
  motion.aligned = true;
  motion.rotation_rad = {constant(0.4), constant(0.0), constant(0.0)};
  const Pose pose = Track(motion, 1, "A").at(1.3, 0);
  const core::Vec3 v = pose.velocity_world_mps;
  expect_near(pose.world_from_platform * core::Vec3{1, 0, 0}, (1.0 / core::norm(v)) * v, 10.0 * epsilon);
  EXPECT_NEAR((pose.world_from_platform * core::Vec3{0, 1, 0}).z, -std::sin(0.4) * std::hypot(v.x, v.y) / core::norm(v),
              10.0 * epsilon);
}

TEST(Track, AtTheKnotOfABrokenLineTheVelocityIsTheOneToTheRight) {
  Motion motion;
  motion.path = FunctionPath{
      {core::Interpolator({core::Interpolation::linear, {{0, 0}, {1, 10}, {2, 5}}}), constant(0), constant(0)}};
  EXPECT_EQ(Track(motion, 1, "A").at(1.0, 0).velocity_world_mps, (core::Vec3{-5, 0, 0}));
}

TEST(Track, AddsRatesTimesTimeToConstantAndToUserAngles) {
  Motion motion;
  motion.rotation_rad = {constant(0.1), core::Interpolator({core::Interpolation::linear, {{0, 0}, {1, 1}}}),
                         constant(0)};
  motion.rotation_rate_rad_per_s = {2.0, 3.0, 0.0};
  const Pose pose = Track(motion, 1, "A").at(-2.0, 0);
  EXPECT_NEAR(pose.rotation_rad[0], 0.1 - 4.0, 4.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rad[1], -2.0 - 6.0, 8.0 * epsilon);
  EXPECT_NEAR(pose.rotation_rate_rad_per_s[1], 4.0, 4.0 * epsilon);
}

TEST(Track, JitterHasTheGivenMomentsAndIndependentAxes) {
  Motion motion;
  motion.position_stddev_m = {1.0, 2.0, 0.5};
  motion.rotation_stddev_rad = {0.1, 0.2, 0.3};
  const Track track(motion, 1, "Plane");
  constexpr int pulses = 20'000;
  std::array<double, 6> sum{};
  std::array<std::array<double, 6>, 6> product{};
  for (int p = -pulses / 2; p < pulses / 2; ++p) {
    const Pose pose = track.at(0.0, p);
    const std::array<double, 6> unit{pose.position_world_m.x / 1.0, pose.position_world_m.y / 2.0,
                                     pose.position_world_m.z / 0.5, pose.rotation_rad[0] / 0.1,
                                     pose.rotation_rad[1] / 0.2,    pose.rotation_rad[2] / 0.3};
    for (std::size_t i = 0; i < 6; ++i) {
      sum[i] += unit[i];
      for (std::size_t k = 0; k < 6; ++k) product[i][k] += unit[i] * unit[k];
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(sum[i] / pulses, 0.0, 5.0 / std::sqrt(pulses));
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(product[i][k] / pulses, i == k ? 1.0 : 0.0, 5.0 * std::sqrt((i == k ? 2.0 : 1.0) / pulses));
  }
}

TEST(Track, JitterBelongsToThePulseAndThePlatformsNameAndLeavesSpeedsAlone) {
  Motion motion = winding();
  const Track calm(motion, 1, "Plane");
  motion.position_stddev_m = {1.0, 1.0, 1.0};
  motion.rotation_stddev_rad = {0.1, 0.1, 0.1};
  const Track shaken(motion, 1, "Plane");
  const auto shift = [&](const Track& track, double t, std::int64_t pulse) {
    return track.at(t, pulse).position_world_m - calm.at(t, pulse).position_world_m;
  };
  // Positions up to 200 m come back from the difference to 200 epsilon.
  expect_near(shift(shaken, 0.5, 7), shift(shaken, 2.5, 7), 400.0 * epsilon);
  EXPECT_GT(core::norm(shift(shaken, 0.5, 7) - shift(shaken, 0.5, 8)), 1e-3);
  EXPECT_EQ(shaken.at(0.5, 7).velocity_world_mps, calm.at(0.5, 7).velocity_world_mps);
  EXPECT_EQ(shaken.at(0.5, 7).rotation_rate_rad_per_s, calm.at(0.5, 7).rotation_rate_rad_per_s);
  EXPECT_EQ(Track(motion, 1, "PLANE").at(0.5, 7).position_world_m, shaken.at(0.5, 7).position_world_m);
  EXPECT_NE(Track(motion, 1, "Boat").at(0.5, 7).position_world_m, shaken.at(0.5, 7).position_world_m);
  EXPECT_NE(Track(motion, 2, "Plane").at(0.5, 7).position_world_m, shaken.at(0.5, 7).position_world_m);
}

// Between two grid times of the deviation (512 steps over the envelope's support) it is a straight line.
TEST(Track, EnvelopeErrorsMoveThePositionAndTheSpeed) {
  Motion motion;
  const core::Interpolator h({core::Interpolation::linear, {{0, 0}, {256, 1}, {512, 0}}});
  motion.position_envelope[1] = h;
  motion.rotation_envelope[2] = h;
  const Track track(motion, 1, "Plane");
  EXPECT_FALSE(track.fixed());
  const Pose a = track.at(10.25, 0), b = track.at(10.75, 1);
  EXPECT_EQ(a.position_world_m.x, 0.0);
  EXPECT_NE(a.position_world_m.y, 0.0);
  EXPECT_NEAR(a.velocity_world_mps.y, (b.position_world_m.y - a.position_world_m.y) / 0.5, 1e4 * epsilon);
  EXPECT_NE(a.velocity_world_mps.y, 0.0);
  EXPECT_NEAR(a.rotation_rate_rad_per_s[2], (b.rotation_rad[2] - a.rotation_rad[2]) / 0.5, 1e4 * epsilon);
  EXPECT_NE(a.rotation_rad[2], a.position_world_m.y);  // position and rotation have noises of their own
}

// Times that come and go between the 512 steps of the deviations.
TEST(Track, ErrorStepsAndTravelsChangeNoBit) {
  Motion motion = winding();
  motion.aligned = true;
  motion.position_stddev_m = {0.1, 0.2, 0.3};
  motion.rotation_stddev_rad = {0.01, 0.02, 0.03};
  for (std::size_t i = 0; i < 3; ++i)
    motion.position_envelope[i] = motion.rotation_envelope[i] = smooth({{0, 0}, {1, 1}, {2, 0}});
  const Track track(motion, 3, "A");
  Track::ErrorSteps steps, travel_steps;
  for (const double t : {0.1, 0.1001, 0.2, 0.1, 2.5, -1.0}) {
    const Pose pose = track.at(t, 4);
    const Pose again = track.at(t, 4, steps);
    const Travel travel = track.travel_at(t, 4, travel_steps);
    EXPECT_EQ(again.position_world_m, pose.position_world_m);
    EXPECT_EQ(again.velocity_world_mps, pose.velocity_world_mps);
    EXPECT_EQ(again.world_from_platform, pose.world_from_platform);
    EXPECT_EQ(again.world_from_platform_rate, pose.world_from_platform_rate);
    EXPECT_EQ(travel.position_world_m, pose.position_world_m);
    EXPECT_EQ(travel.velocity_world_mps, pose.velocity_world_mps);
  }
}

TEST(Track, BoundsItsAccelerationAndSaysWhetherItTurns) {
  Motion motion;
  motion.path = winding().path;
  const Track track(motion, 1, "A");
  EXPECT_FALSE(track.turns());
  for (int i = -10; i <= 40; ++i)
    EXPECT_LE(core::norm(track.acceleration_at(0.1 * i, 0).acceleration_world_mps2), track.acceleration_bound_mps2());
  EXPECT_GT(track.acceleration_bound_mps2(), 0.0);
  motion.aligned = true;
  EXPECT_TRUE(Track(motion, 1, "A").turns());
  motion.path = FunctionPath{{smooth({{0, 0}, {1, 30}}), constant(0), constant(0)}};
  EXPECT_FALSE(Track(motion, 1, "A").turns());
  EXPECT_EQ(Track(motion, 1, "A").acceleration_bound_mps2(), 0.0);
  motion.rotation_rate_rad_per_s[1] = 0.1;
  EXPECT_TRUE(Track(motion, 1, "A").turns());
}

// White noise has no speed: what the grid makes of it must not reach the Doppler shift.
TEST(Track, ErrorsWithABoxEnvelopeMoveThePositionAndTheRotationAlone) {
  Motion motion;
  const core::Interpolator box({core::Interpolation::linear, {{0, 1}, {512, 1}}});
  motion.position_envelope[1] = box;
  motion.rotation_envelope[2] = box;
  const Track track(motion, 1, "Plane");
  const Pose a = track.at(10.25, 0), b = track.at(10.75, 1);
  EXPECT_NE(a.position_world_m.y, b.position_world_m.y);
  EXPECT_NE(a.rotation_rad[2], b.rotation_rad[2]);
  EXPECT_EQ(a.velocity_world_mps, core::Vec3{});
  EXPECT_EQ(a.rotation_rate_rad_per_s, (std::array<double, 3>{}));
}

TEST(Track, IsFixedOnlyWhereNothingMovesIt) {
  Motion still;
  still.path = FunctionPath{{constant(1), constant(2), constant(3)}};
  still.rotation_rad = {constant(0.1), constant(0), constant(0)};
  EXPECT_TRUE(Track(still, 1, "A").fixed());
  const auto with = [&](auto change) {
    Motion motion = still;
    change(motion);
    return Track(motion, 1, "A").fixed();
  };
  EXPECT_FALSE(with([](Motion& m) { m.path = FunctionPath{{constant(1), constant(2), smooth({{0, 0}, {1, 1}})}}; }));
  EXPECT_FALSE(with([](Motion& m) { m.rotation_rad[1] = smooth({{0, 0}, {1, 1}}); }));
  EXPECT_FALSE(with([](Motion& m) { m.rotation_rate_rad_per_s[0] = 0.1; }));
  EXPECT_FALSE(with([](Motion& m) { m.position_stddev_m[1] = 0.1; }));
  EXPECT_FALSE(with([](Motion& m) { m.rotation_stddev_rad[2] = 0.1; }));
  EXPECT_FALSE(with([](Motion& m) { m.rotation_envelope[0] = smooth({{0, 1}, {1, 1}}); }));
}

}  // namespace track_test
}  // namespace sarsim::radar
