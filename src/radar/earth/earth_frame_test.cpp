#include "radar/earth/earth_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {
namespace earth_frame_test {

using core::pi;
using core::rad_per_deg;
using core::Vec3;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Geodetic from_deg(double latitude, double longitude, double height_m) {
  return {latitude * rad_per_deg, longitude * rad_per_deg, height_m};
}

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
  EXPECT_NEAR(found.z, expected.z, tolerance);
}

const std::vector<Anchor>& anchors() {
  static const std::vector<Anchor> all{{from_deg(-33.95, 18.46, 100.0), 0.0}, {from_deg(46.0, 180.0, 5.0), 1.0},
                                       {from_deg(0.0, 0.0, 0.0), -2.0},       {from_deg(90.0, 30.0, -10.0), 0.3},
                                       {from_deg(-90.0, 0.0, 2800.0), pi},    {from_deg(51.0, -179.999, 8000.0), 6.0}};
  return all;
}

// The specification's value, by CartConvert -l of GeographicLib.
TEST(EarthFrame, HasTheLocalCoordinatesOfGeographicLib) {
  const EarthFrame frame({from_deg(-33.95, 18.46, 100.0), 0.0});
  expect_near(frame.world_of(from_deg(-33.94, 18.47, 150.0)), {924.518614, 1109.195047, 49.836275}, 5.1e-7);
}

// Made with 50 digits (mpmath 1.3) from the doubles that stand here: the true differences to the anchor.
TEST(EarthFrame, HasTheTrueDifferencesToTheAnchor) {
  struct Exact {
    Geodetic place;
    Vec3 world_m;
  };
  const std::vector<Exact> table{
      {{0.7, -1.2, 30.0}, {0.0, 0.0, 0.0}},
      {{0.7000001, -1.2, 30.0}, {-0.30500878918202, 0.55831484361208, -0.000000031809818715389}},
      {{0.7, -1.1999999, 31.25}, {0.42870634937576, 0.23420336400608, 1.2499999813184}},
      {{0.70015, -1.20031, -12.5}, {-1786.3962706530787, 111.6659530484322, -42.7510779137680}},
      {{0.71, -1.19, 2500.0}, {11935.9758428973570, 79223.2379658803485, 1966.4506727400904}},
      {{0.69, -1.25, 700000.0}, {-207983.9570480353270, -189073.2576003666093, 694392.5471452977309}},
      {{0.5, -1.1, 693000.0}, {1205858.5340626077762, -914204.7270171293003, 528773.6784192499250}},
      {{-0.7, 1.94, 0.0}, {-13370.9020629456385, 40703.4510634139694, -12738566.7006593436197}},
  };
  const EarthFrame frame({{0.7, -1.2, 30.0}, 0.5});
  for (const auto& [place, world_m] : table)
    expect_near(frame.world_of(place), world_m, 1e-11 + epsilon * core::norm(world_m));
}

TEST(EarthFrame, HasXEastYNorthAndZUpAtHeadingZero) {
  const Geodetic origin = from_deg(46.0, -67.5, 200.0);
  const EarthFrame frame({origin, 0.0});
  const double step = 1e-7;  // the tangent is left by step/2 of the way, 3e-8 m
  const CurvatureRadii radii = curvature_radii(origin.latitude_rad);
  const double east_m = (radii.prime_vertical_m + 200.0) * std::cos(origin.latitude_rad) * step;
  const double north_m = (radii.meridian_m + 200.0) * step;
  expect_near(frame.world_of({origin.latitude_rad, origin.longitude_rad + step, 200.0}), {east_m, 0.0, 0.0}, 5e-8);
  expect_near(frame.world_of({origin.latitude_rad + step, origin.longitude_rad, 200.0}), {0.0, north_m, 0.0}, 5e-8);
  expect_near(frame.world_of({origin.latitude_rad, origin.longitude_rad, 201.0}), {0.0, 0.0, 1.0}, 1e-12);
}

TEST(EarthFrame, TurnsYClockwiseFromNorthByTheHeading) {
  const Geodetic origin = from_deg(46.0, -67.5, 200.0), place = from_deg(46.01, -67.47, 500.0);
  const Vec3 plain = EarthFrame({origin, 0.0}).world_of(place);
  const Vec3 to_east = EarthFrame({origin, pi / 2.0}).world_of(place);
  expect_near(to_east, {-plain.y, plain.x, plain.z}, 1e-11);  // y east, x south
  const double heading = 0.7;
  const Vec3 turned = EarthFrame({origin, heading}).world_of(place);
  EXPECT_NEAR(core::azimuth_rad(turned) + heading, core::azimuth_rad(plain), 1e-15);
  EXPECT_NEAR(turned.z, plain.z, 1e-12);
}

TEST(EarthFrame, PutsItsAnchorAtZero) {
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    EXPECT_EQ(frame.world_of(anchor.origin), Vec3{});
    EXPECT_EQ(frame.anchor(), anchor);
    EXPECT_NEAR(frame.geodetic_of({}).height_m, anchor.origin.height_m, 1e-11);
    expect_near(frame.world_from_ecef(ecef_of(anchor.origin)), {}, 8.2e-10);  // a rounding of ECEF, turned
  }
}

TEST(EarthFrame, LeadsFromEcefToTheWorldAndBack) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> place(-8e6, 8e6);
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    for (int i = 0; i < 300; ++i) {
      const Vec3 ecef_m{place(random), place(random), place(random)};
      const Vec3 world_m = frame.world_from_ecef(ecef_m);
      expect_near(frame.ecef_from_world(world_m), ecef_m, 3e-9);
      EXPECT_NEAR(core::norm(world_m), core::norm(ecef_m - ecef_of(anchor.origin)), 4e-9);
    }
  }
}

// What a place and its world coordinates lose together: a rounding of the angles and one of the world coordinates.
TEST(EarthFrame, LeadsFromPlacesToTheWorldAndBack) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> sine(-1.0, 1.0), turn(-pi, pi), power(0.0, 7.6);
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    for (int i = 0; i < 1'000; ++i) {
      const Geodetic place{std::asin(sine(random)), turn(random), std::pow(10.0, power(random)) - 1e4};
      const Vec3 world_m = frame.world_of(place);
      const Geodetic back = frame.geodetic_of(world_m);
      const double lost_m = epsilon * core::norm(world_m) + 1e-11;
      const double axis_m = curvature_radii(place.latitude_rad).prime_vertical_m * std::cos(place.latitude_rad);
      EXPECT_NEAR(back.height_m, place.height_m, lost_m + epsilon * std::abs(place.height_m));
      EXPECT_NEAR(back.latitude_rad, place.latitude_rad, lost_m / 6.3e6 + epsilon);
      EXPECT_NEAR(std::remainder(back.longitude_rad - place.longitude_rad, 2.0 * pi), 0.0,
                  lost_m / axis_m + 2 * epsilon);
    }
  }
}

// Places that nanometres separate: ECEF could not tell. The way back has roundings of the radius in extended precision,
// 4e-13 m each.
TEST(EarthFrame, KeepsNanometresNearTheAnchor) {
  const EarthFrame frame({from_deg(-33.95, 18.46, 100.0), 0.4});
  for (double height_m = 100.0; height_m < 100.0000001; height_m += 1e-9) {
    const Geodetic place{-33.95 * rad_per_deg, 18.46 * rad_per_deg, height_m};
    EXPECT_NEAR(frame.world_of(place).z, height_m - 100.0, 1e-12);
    EXPECT_NEAR(frame.geodetic_of({0.0, 0.0, height_m - 100.0}).height_m, height_m, 5e-12);
  }
}

TEST(EarthFrame, LiesAboveTheEllipsoidByTheSquareOfTheDistance) {
  const EarthFrame frame({from_deg(45.0, 10.0, 0.0), 0.0});
  EXPECT_NEAR(frame.geodetic_of({3200.0, 0.0, 0.0}).height_m, 0.8, 0.005);
  EXPECT_NEAR(frame.geodetic_of({0.0, 100e3, 0.0}).height_m, 785.0, 1.0);
}

TEST(EarthFrame, TurnsVectorsWithoutChangingThem) {
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    const Vec3 a{7500.0, -200.0, 13.0}, b{1.0, 2.0, -3.0};
    const Vec3 a_world = frame.world_axes_from_ecef(a), b_world = frame.world_axes_from_ecef(b);
    EXPECT_NEAR(core::dot(a_world, b_world), core::dot(a, b), 1e-11);
    expect_near(core::cross(a_world, b_world), frame.world_axes_from_ecef(core::cross(a, b)), 2e-11);
    expect_near(frame.ecef_axes_from_world(a_world), a, 3e-12);
    const Vec3 way = frame.world_from_ecef({7e6 + 4.0, 1e6, 2e6}) - frame.world_from_ecef({7e6, 1e6, 2e6});
    expect_near(way, frame.world_axes_from_ecef({4.0, 0.0, 0.0}), 3e-9);
  }
}

TEST(EarthFrame, HasLocalAxesAlongTheDerivativesOfPlaces) {
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    const Geodetic at{anchor.origin.latitude_rad * 0.98 + 0.01, anchor.origin.longitude_rad - 0.02, 3000.0};
    const core::Mat3 axes = core::transposed(frame.world_from_enu(at));
    const double step = 1e-5;
    const auto towards = [&](double latitude, double longitude, double height_m) {
      const auto moved = [&](double sign) {
        return frame.world_of(
            {at.latitude_rad + sign * latitude, at.longitude_rad + sign * longitude, at.height_m + sign * height_m});
      };
      const Vec3 way = moved(1.0) - moved(-1.0);
      return (1.0 / core::norm(way)) * way;
    };
    expect_near(axes.row[0], towards(0.0, step, 0.0), 1e-9);
    expect_near(axes.row[1], towards(step, 0.0, 0.0), 1e-9);
    expect_near(axes.row[2], towards(0.0, 0.0, 100.0), 1e-9);
    expect_near(core::cross(axes.row[0], axes.row[1]), axes.row[2], 4.0 * epsilon);
  }
}

TEST(EarthFrame, HasTheWorldsOwnAxesAtTheAnchor) {
  const Geodetic origin = from_deg(-33.95, 18.46, 100.0);
  const core::Mat3 plain = EarthFrame({origin, 0.0}).world_from_enu(origin);
  for (std::size_t i = 0; i < 3; ++i) expect_near(plain.row[i], core::Mat3().row[i], 1e-17);
  const core::Mat3 turned = EarthFrame({origin, 0.3}).world_from_enu(origin);
  expect_near(turned * Vec3{std::sin(0.3), std::cos(0.3), 0.0}, {0.0, 1.0, 0.0}, epsilon);
}

TEST(EarthFrame, TurnsAboutTheEarthsAxis) {
  for (const Anchor& anchor : anchors()) {
    const EarthFrame frame(anchor);
    const auto& [w, centre_m] = frame.turning();
    EXPECT_NEAR(core::norm(w), earth_rate_rad_per_s, 1e-20);
    EXPECT_NEAR(w.z, earth_rate_rad_per_s * std::sin(anchor.origin.latitude_rad), 1e-20);
    EXPECT_NEAR(core::norm(centre_m), core::norm(ecef_of(anchor.origin)), 2e-9);
    // Towards the east, faster the farther from the axis.
    const Vec3 carried = carried_mps(frame.turning(), {});
    const double east_mps = earth_rate_rad_per_s * std::hypot(ecef_of(anchor.origin).x, ecef_of(anchor.origin).y);
    const core::Mat3 world_from_enu = frame.world_from_enu(anchor.origin);
    expect_near(carried, world_from_enu * Vec3{east_mps, 0.0, 0.0}, 1e-12);
  }
}

struct Satellite {
  Vec3 position_ecef_m;
  Vec3 velocity_ecef_mps;
  Geodetic place;  // degrees
  double speed_mps;
  double inertial_mps;
};

// Published states; the other numbers are those of the specification, 4.3. The last velocity is rounded to 5e-5 m/s.
TEST(EarthFrame, HasThePlacesAndSpeedsOfSatellites) {
  const std::vector<Satellite> satellites{
      {{1950200.216160, -4143460.384445, -5401629.615817},
       {579.550068, -5889.842297, 4730.338429},
       {-49.879481, -64.795067, 715933.903},
       7576.4254,
       7495.9160},
      {{2057735.247194, -6459802.571744, -2037501.319184},
       {-886.585360, -2517.114487, 7108.167902},
       {-16.823020, -72.331003, 702817.751},
       7592.6247,
       7503.4458},
      {{-1659308.501505, 6753819.113038, -1317158.267893},
       {1875.247563, -954.537857, -7297.506531},
       {-10.787898, 103.803292, 700903.258},
       7594.8204,
       7504.8239},
      {{2500149.266, -6714929.064, 0.0},
       {-1530.874437, -560.873432, 7377.493385},
       {0.0, -69.578344, 787127.733},
       7555.4989,
       7460.2173},
      {{3610265.1977, -6139538.4368, 159314.0910},
       {-1429.7297, -647.2513, 7405.3360},
       {1.289112, -59.542970, 746010.741},
       7569.8125,
       7480.0284},
  };
  for (const Anchor& anchor : anchors())
    for (const Satellite& satellite : satellites) {
      const EarthFrame frame(anchor);
      const Vec3 world_m = frame.world_from_ecef(satellite.position_ecef_m);
      const Vec3 velocity = frame.world_axes_from_ecef(satellite.velocity_ecef_mps);
      const Geodetic place = frame.geodetic_of(world_m);
      EXPECT_NEAR(place.latitude_rad / rad_per_deg, satellite.place.latitude_rad, 5.1e-7);
      EXPECT_NEAR(place.longitude_rad / rad_per_deg, satellite.place.longitude_rad, 5.1e-7);
      EXPECT_NEAR(place.height_m, satellite.place.height_m, 5.1e-4);
      EXPECT_NEAR(core::norm(velocity), satellite.speed_mps, 1.4e-4);
      const Vec3 inertial = frame.inertial_velocity_mps(world_m, velocity);
      EXPECT_NEAR(core::norm(inertial), satellite.inertial_mps, 1.4e-4);
      expect_near(frame.fixed_velocity_mps(world_m, inertial), velocity, 3e-12);
    }
}

TEST(EarthFrame, ExpectsAnAnchorOnTheEarth) {
  if (!core::checks_expectations()) GTEST_SKIP();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(EarthFrame({{1.6, 0.0, 0.0}, 0.0}), core::BrokenExpectation);
  EXPECT_THROW(EarthFrame({{0.0, nan, 0.0}, 0.0}), core::BrokenExpectation);
  EXPECT_THROW(EarthFrame({{0.0, 0.0, 0.0}, nan}), core::BrokenExpectation);
}

}  // namespace earth_frame_test
}  // namespace sarsim::radar
