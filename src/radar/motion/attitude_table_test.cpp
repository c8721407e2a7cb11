#include "radar/motion/attitude_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "radar/motion/motion_test_support.hpp"
#include "radar/orbit/steering.hpp"

namespace sarsim::radar {
namespace attitude_table_test {

using namespace motion_test;

AttitudeTable table_of(const AttitudeSamples& samples) { return std::get<AttitudeTable>(AttitudeTable::from(samples)); }

core::Mat3 tumbling(double t) { return world_from_platform({0.4 * std::sin(0.7 * t), 0.3 * t, -0.2 * t * t}); }

AttitudeSamples samples_of(double step_s, int count, bool scrambled) {
  AttitudeSamples samples;
  for (int k = 0; k < count; ++k) {
    const Quaternion q = quaternion_of(tumbling(step_s * k));
    const double sign = scrambled && k % 3 == 1 ? -1.0 : 1.0;
    samples.time_s.push_back(step_s * k);
    samples.world_from_platform.push_back({sign * q.w, sign * q.x, sign * q.y, sign * q.z});
  }
  return samples;
}

TEST(Quaternion, AndMatrixAreTheSameRotation) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-4.0, 4.0);
  for (int i = 0; i < 200; ++i) {
    const core::Mat3 m = world_from_platform({angle(random), angle(random), angle(random)});
    const Quaternion q = quaternion_of(m);
    EXPECT_LT(difference(matrix_of(q), m), 1e-14);
    EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-14);
    EXPECT_GE(q.w, 0.0);
  }
  for (const core::Mat3& half_turn : {core::Mat3{{core::Vec3{1, 0, 0}, core::Vec3{0, -1, 0}, core::Vec3{0, 0, -1}}},
                                      core::Mat3{{core::Vec3{-1, 0, 0}, core::Vec3{0, 1, 0}, core::Vec3{0, 0, -1}}},
                                      core::Mat3{{core::Vec3{-1, 0, 0}, core::Vec3{0, -1, 0}, core::Vec3{0, 0, 1}}}})
    EXPECT_LT(difference(matrix_of(quaternion_of(half_turn)), half_turn), 1e-15);
}

// A right-handed quarter turn about z: x becomes y.
TEST(Quaternion, TurnsRightHanded) {
  const core::Mat3 m = matrix_of({std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)});
  EXPECT_LT(core::norm(m * core::Vec3{1, 0, 0} - core::Vec3{0, 1, 0}), 1e-15);
}

TEST(AttitudeTable, MeetsItsSamplesWhateverTheirSigns) {
  const AttitudeTable plain = table_of(samples_of(0.25, 25, false)), scrambled = table_of(samples_of(0.25, 25, true));
  for (int k = 0; k < 25; ++k) EXPECT_LT(difference(plain.turning_at(0.25 * k).matrix, tumbling(0.25 * k)), 1e-14);
  for (const double t : {0.1, 2.3, 5.9})
    EXPECT_LT(difference(plain.turning_at(t).matrix, scrambled.turning_at(t).matrix), 1e-14);
}

// Fourth derivatives of the components are below (1/2 * 2.7)^4 = 4 1/s^4 (angular velocities up to 2.7 rad/s), so
// 5/192 h^4 * 4 in the middle.
TEST(AttitudeTable, ErrorsFallWithTheFourthPowerOfTheStep) {
  for (const double h : {0.25, 0.125}) {
    const AttitudeTable table = table_of(samples_of(h, static_cast<int>(6.0 / h) + 1, false));
    double worst = 0.0;
    for (double t = 1.0; t < 5.0; t += 0.013)
      worst = std::max(worst, difference(table.turning_at(t).matrix, tumbling(t)));
    EXPECT_LT(worst, 5.0 / 192.0 * 4.0 * h * h * h * h);
  }
}

// Central differences over +-0.1 ms; third derivatives are below 60 1/s^3 (3 times in a second derivative's).
TEST(AttitudeTable, RatesAndAccelerationsAreDerivatives) {
  const AttitudeTable table = table_of(samples_of(0.25, 25, false));
  constexpr double h = 1e-4;
  for (const double t : {0.1, 0.6, 2.35, 5.9}) {
    const AttitudeMotion before = table.at(t - h), now = table.at(t), after = table.at(t + h);
    const auto slope = [](const core::Mat3& a, const core::Mat3& b) { return (0.5 / h) * (b + -1.0 * a); };
    EXPECT_LT(difference(slope(before.world_from_platform.matrix, after.world_from_platform.matrix),
                         now.world_from_platform.rate),
              1e-6);
    EXPECT_LT(difference(slope(before.world_from_platform.rate, after.world_from_platform.rate), now.acceleration),
              1e-5);
    EXPECT_EQ(table.turning_at(t).rate, now.world_from_platform.rate);
  }
}

TEST(AttitudeTable, StaysAsAtItsEndsBeyondThem) {
  const AttitudeTable table = table_of(samples_of(0.25, 25, false));
  for (const double t : {-5.0, -1e-9, 6.0, 6.1, 1e6}) {
    const AttitudeMotion got = table.at(t);
    EXPECT_LT(difference(got.world_from_platform.matrix, tumbling(t < 0.0 ? 0.0 : 6.0)), 1e-14);
    EXPECT_EQ(got.world_from_platform.rate, (core::Mat3{{core::Vec3{}, core::Vec3{}, core::Vec3{}}}));
    EXPECT_EQ(got.acceleration, (core::Mat3{{core::Vec3{}, core::Vec3{}, core::Vec3{}}}));
  }
  EXPECT_TRUE(table.turns());
  const AttitudeTable one = table_of({{3.0}, {quaternion_of(tumbling(3.0))}});
  EXPECT_FALSE(one.turns());
  EXPECT_LT(difference(one.turning_at(7.0).matrix, tumbling(3.0)), 1e-14);
}

// The accuracy that the header states for a satellite.
TEST(AttitudeTable, HoldsTheAttitudeOfASatelliteEveryTenSeconds) {
  const auto exact = [](std::size_t tenth) {
    const OrbitState& s = j2_orbit()[tenth];
    return with_z_up(zero_doppler_attitude(
        {s.position_m, s.velocity_mps, orbit_test::j2_acceleration(s.position_m, s.velocity_mps)}, turning_earth));
  };
  AttitudeSamples samples;
  for (std::size_t k = 0; k <= 30; ++k) {
    samples.time_s.push_back(10.0 * static_cast<double>(k));
    samples.world_from_platform.push_back(quaternion_of(exact(100 * k).world_from_platform));
  }
  const AttitudeTable table = table_of(samples);
  double worst = 0.0, worst_rate = 0.0;
  for (std::size_t tenth = 200; tenth < 2800; ++tenth) {
    const TurningMatrix got = table.turning_at(0.1 * static_cast<double>(tenth));
    worst = std::max(worst, difference(got.matrix, exact(tenth).world_from_platform));
    worst_rate = std::max(worst_rate, difference(got.rate, exact(tenth).world_from_platform_rate));
  }
  EXPECT_LT(worst, 3e-11);
  EXPECT_LT(worst_rate, 2e-11);
  RecordProperty("worst", std::to_string(worst * 1e12) + " prad, " + std::to_string(worst_rate * 1e12) + " prad/s");
}

TEST(AttitudeTable, RefusesWhatIsNoTable) {
  const Quaternion one;
  const auto message = [](const AttitudeSamples& samples) {
    const auto made = AttitudeTable::from(samples);
    return std::holds_alternative<core::Problem>(made) ? std::get<core::Problem>(made).message : std::string("none");
  };
  EXPECT_EQ(message({{}, {}}), "there are no attitudes");
  EXPECT_EQ(message({{0.0, 1.0}, {one}}), "attitudes and times differ in number");
  EXPECT_EQ(message({{0.0, 0.0}, {one, one}}), "the time of attitude 2 does not ascend");
  EXPECT_EQ(message({{0.0}, {{0.9, 0.0, 0.0, 0.0}}}), "quaternion 1 has not the length 1");
  EXPECT_EQ(message({{0.0}, {{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 0.0}}}), "attitude 1 is not finite");
  EXPECT_EQ(message({{std::numeric_limits<double>::infinity()}, {one}}), "attitude 1 is not finite");
  EXPECT_EQ(message({{0.0}, {{1.0005, 0.0, 0.0, 0.0}}}), "none");
}

}  // namespace attitude_table_test
}  // namespace sarsim::radar
