#include "radar/earth/sagnac.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/maths/constants.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::radar {
namespace sagnac_test {

using core::Vec3;

constexpr double c = core::exact_light_speed_mps;
const TurningAxes earth{{0.0, 0.0, earth_rate_rad_per_s}, {}};

// A point that moves evenly in Earth-fixed axes, ECEF.
struct Moving {
  Vec3 place_m;
  Vec3 velocity_mps;

  [[nodiscard]] ExtendedVec3 at(long double time_s) const {
    return extended(place_m) + time_s * extended(velocity_mps);
  }
};

// The same seen from axes that rest and agree with the turning ones at time 0.
ExtendedVec3 resting(const ExtendedVec3& fixed, long double time_s) {
  const long double angle = earth_rate_rad_per_s * time_s;
  const long double s = std::sin(angle), co = std::cos(angle);
  return {co * fixed.x - s * fixed.y, s * fixed.x + co * fixed.y, fixed.z};
}

long double length(const ExtendedVec3& v) { return std::sqrt(dot(v, v)); }

// c (t1 - t0) of light that leaves one point at t0 and meets the other: iteration in axes that rest.
long double inertial_way_m(const Moving& from, const Moving& to, long double t0 = 0.0L) {
  const ExtendedVec3 start = resting(from.at(t0), t0);
  long double way_m = 0.0L;
  for (int i = 0; i < 20; ++i) {
    const long double t1 = t0 + way_m / c;
    way_m = length(resting(to.at(t1), t1) - start);
  }
  return way_m;
}

// The state of Sentinel-1B of 2020-07-28 in the specification, 4.3, looking to the right at 30 deg.
struct Sight {
  Vec3 satellite_m{2057735.247194, -6459802.571744, -2037501.319184};
  Vec3 velocity_mps{-886.585360, -2517.114487, 7108.167902};
  Vec3 ahead = (1.0 / core::norm(velocity_mps)) * velocity_mps;
  Vec3 right;
  Vec3 ground_m;

  Sight() {
    const Vec3 in = -(1.0 / core::norm(satellite_m)) * satellite_m;
    const Vec3 level = in - core::dot(in, ahead) * ahead;
    const Vec3 down = (1.0 / core::norm(level)) * level;
    right = core::cross(down, ahead);
    const double look = 30.0 * core::rad_per_deg;
    const Vec3 beam = std::cos(look) * down + std::sin(look) * right;
    double near_m = 6e5, far_m = 1e6;
    while (far_m - near_m > 1e-4) {
      const double middle_m = 0.5 * (near_m + far_m);
      (geodetic_of(satellite_m + middle_m * beam).height_m > 0.0 ? near_m : far_m) = middle_m;
    }
    ground_m = satellite_m + near_m * beam;
  }
};

// Out from the satellite and back to a receiver that flies along, displaced.
struct TwoWay {
  double excess_m = 0.0;  // both ways less their distances
  Vec3 receiver_m;        // as it receives
};

TwoWay two_way(const Sight& sight, const Vec3& displaced_m) {
  const Moving sender{sight.satellite_m, sight.velocity_mps}, ground{sight.ground_m, {}};
  const Moving receiver{sight.satellite_m + displaced_m, sight.velocity_mps};
  const long double out_m = inertial_way_m(sender, ground);
  const long double t1 = out_m / c;
  const long double back_m = inertial_way_m(ground, receiver, t1);
  const ExtendedVec3 received_m = receiver.at(t1 + back_m / c);
  const long double straight_m = length(ground.at(t1) - sender.at(0.0L)) + length(received_m - ground.at(t1));
  return {static_cast<double>(out_m + back_m - straight_m), rounded(received_m)};
}

double turning_excess_m(const Vec3& from_m, const Vec3& to_m) {
  return turning_way_m(earth, from_m, to_m, c) - core::norm(to_m - from_m);
}

// The specification's table, 3.3, by iteration and by the formulas.
TEST(Sagnac, IsThatOfSentinel1) {
  const Sight sight;
  EXPECT_NEAR(core::norm(sight.ground_m - sight.satellite_m), 826847.0, 1.0);
  EXPECT_NEAR(sagnac_m(earth, sight.satellite_m, sight.ground_m, c), 0.6665, 5.1e-5);
  EXPECT_NEAR(two_way(sight, {}).excess_m, -1.2e-5, 5.1e-7);
  EXPECT_NEAR(two_way(sight, -20e3 * sight.ahead).excess_m, 6.8e-3, 5.1e-5);
  EXPECT_NEAR(two_way(sight, 20e3 * sight.right).excess_m, 2.9e-2, 5.1e-4);
  for (const Vec3& displaced_m : {Vec3{}, -20e3 * sight.ahead, 20e3 * sight.right, -20e3 * sight.right}) {
    const auto [excess_m, receiver_m] = two_way(sight, displaced_m);
    const double out_m = turning_excess_m(sight.satellite_m, sight.ground_m);
    EXPECT_NEAR(out_m + turning_excess_m(sight.ground_m, receiver_m), excess_m, 1e-9);
    // The first order alone leaves out twice 1.3e-6 m.
    const double first_m =
        sagnac_m(earth, sight.satellite_m, sight.ground_m, c) + sagnac_m(earth, sight.ground_m, receiver_m, c);
    EXPECT_NEAR(excess_m - first_m, 2.6e-6, 2e-7);
  }
}

std::array<Vec3, 2> random_way(std::mt19937& random, double min_height_m, double max_height_m) {
  std::uniform_real_distribution<double> sine(-1.0, 1.0), turn(-core::pi, core::pi), beside(-0.15, 0.15);
  std::uniform_real_distribution<double> height(min_height_m, max_height_m);
  const Geodetic above{std::asin(sine(random)), turn(random), height(random)};
  const Geodetic below{above.latitude_rad + beside(random), above.longitude_rad + beside(random), 200.0};
  return {ecef_of(above), ecef_of(below)};
}

TEST(TurningWay, IsThatOfAnIterationInAxesThatRest) {
  std::mt19937 random(31);
  for (int i = 0; i < 2'000; ++i) {
    const auto [above_m, below_m] = random_way(random, 100.0, 1.2e6);
    const double down_m = static_cast<double>(inertial_way_m({above_m, {}}, {below_m, {}}));
    const double up_m = static_cast<double>(inertial_way_m({below_m, {}}, {above_m, {}}));
    EXPECT_NEAR(turning_way_m(earth, above_m, below_m, c), down_m, 1e-9);
    EXPECT_NEAR(turning_way_m(earth, below_m, above_m, c), up_m, 1e-9);
  }
}

TEST(TurningWay, HoldsToTheGeostationaryOrbit) {
  std::mt19937 random(32);
  for (int i = 0; i < 500; ++i) {
    const auto [above_m, below_m] = random_way(random, 3.5e7, 3.6e7);
    const double down_m = static_cast<double>(inertial_way_m({above_m, {}}, {below_m, {}}));
    EXPECT_NEAR(turning_way_m(earth, above_m, below_m, c), down_m, 1e-9 + 4e-16 * down_m);
  }
}

TEST(Sagnac, LeavesOutTheSecondOrderItStates) {
  std::mt19937 random(33);
  double most = 0.0;
  for (int i = 0; i < 2'000; ++i) {
    const auto [above_m, below_m] = random_way(random, 100.0, 1.2e6);
    const Vec3 line_of_sight_m = below_m - above_m;
    const double d = core::norm(line_of_sight_m);
    const Vec3 va = carried_mps(earth, above_m), vb = carried_mps(earth, below_m);
    const double g = sagnac_m(va, line_of_sight_m, c);
    const long double exact_m =
        inertial_way_m({above_m, {}}, {below_m, {}}) - length(extended(below_m) - extended(above_m));
    const double left_out_m = static_cast<double>(exact_m) - g;
    EXPECT_NEAR(left_out_m, 0.5 * (g * g / d + d * core::dot(va, vb) / (c * c)), 1e-9);
    const double faster = std::max(core::norm(va), core::norm(vb)) / c;
    EXPECT_LE(std::abs(left_out_m), d * faster * faster + 1e-9);
    most = std::max(most, std::abs(left_out_m));
  }
  EXPECT_GT(most, 1e-6);
}

// A way to the east is longer, to the west as much shorter; along the meridian nothing changes.
TEST(Sagnac, LengthensTheWayToTheEast) {
  const Vec3 here = ecef_of({0.0, 0.0, 0.0}), east = ecef_of({0.0, 0.01, 0.0}), north = ecef_of({0.01, 0.0, 0.0});
  EXPECT_NEAR(sagnac_m(earth, here, east, c), core::norm(east - here) * 465.1 / c, 1e-5);
  EXPECT_DOUBLE_EQ(sagnac_m(earth, east, here, c), -sagnac_m(earth, here, east, c));
  EXPECT_EQ(sagnac_m(earth, here, north, c), 0.0);
  EXPECT_EQ(turning_way_m(earth, here, here, c), 0.0);
}

TEST(Sagnac, IsTheCrossProductOfThePlacesSeenFromTheCentre) {
  std::mt19937 random(34);
  for (int i = 0; i < 100; ++i) {
    const auto [a, b] = random_way(random, 100.0, 1.2e6);
    const double expected_m = earth_rate_rad_per_s / c * (a.x * b.y - a.y * b.x);
    EXPECT_NEAR(sagnac_m(earth, a, b, c), expected_m, 1e-8);  // which cancels: 1e-16 of w a b/c, 10 m
  }
}

// World axes, whose origin is far from the axis, and any point of the axis for the centre.
TEST(Sagnac, IsTheSameInTheWorldOfAnAnchor) {
  std::mt19937 random(35);
  for (int i = 0; i < 200; ++i) {
    const auto [above_m, below_m] = random_way(random, 100.0, 1.2e6);
    const EarthFrame frame({geodetic_of(below_m), 0.01 * i});
    TurningAxes axes = frame.turning();
    const Vec3 a = frame.world_from_ecef(above_m), b = frame.world_from_ecef(below_m);
    const double expected_m = sagnac_m(earth, above_m, below_m, c);
    EXPECT_NEAR(sagnac_m(axes, a, b, c), expected_m, 1e-13);
    EXPECT_NEAR(sagnac_m(carried_mps(axes, b), b - a, c), expected_m, 1e-13);
    EXPECT_NEAR(turning_way_m(axes, a, b, c), static_cast<double>(inertial_way_m({above_m, {}}, {below_m, {}})),
                1.5e-9);
    axes.centre_m = axes.centre_m + 1e10 * axes.rotation_rad_per_s;
    EXPECT_NEAR(sagnac_m(axes, a, b, c), expected_m, 1e-13);
  }
}

constexpr TurningAxes at_rest{};
static_assert(sagnac_m(at_rest, {1.0, 2.0, 3.0}, {4.0, -5.0, 6.0}, c) == 0.0);

TEST(TurningWay, IsTheDistanceInAxesThatRest) {
  EXPECT_EQ(turning_way_m(at_rest, {1.0, 2.0, 3.0}, {3.0, 5.0, 9.0}, c), 7.0);
}

}  // namespace sagnac_test
}  // namespace sarsim::radar
