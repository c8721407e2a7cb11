#include "radar/earth/ellipsoid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace ellipsoid_test {

using core::pi;
using core::rad_per_deg;
using core::Vec3;

constexpr double semi_minor_m = wgs84_semi_major_m * (1.0 - wgs84_flattening);

Geodetic from_deg(double latitude, double longitude, double height_m) {
  return {latitude * rad_per_deg, longitude * rad_per_deg, height_m};
}

double spacing(double value) {
  const double size = std::abs(value);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

double largest(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

struct InDegrees {
  std::array<double, 3> place;  // latitude, longitude, height
  Vec3 ecef_m;
};

// Made by CartConvert -p 6 of GeographicLib 2.1.2: micrometres.
const std::vector<InDegrees>& by_geographiclib() {
  static const std::vector<InDegrees> table{
      {{0, 0, 0}, {6378137.000000, 0.000000, 0.000000}},
      {{0, 90, 0}, {0.000000, 6378137.000000, 0.000000}},
      {{0, 180, 1000}, {-6379137.000000, 0.000000, 0.000000}},
      {{0, -90, -10000}, {0.000000, -6368137.000000, 0.000000}},
      {{90, 0, 0}, {0.000000, 0.000000, 6356752.314245}},
      {{-90, 0, 2800}, {0.000000, 0.000000, -6359552.314245}},
      {{89.999999, 45, 0}, {0.078980, 0.078980, 6356752.314245}},
      {{-89.9999, -135, 500}, {-7.898574, -7.898574, -6357252.314235}},
      {{45, 45, 700000}, {3544419.145061, 3544419.145061, 4982323.155697}},
      {{-33.95, 18.46, 100}, {5023911.973046, 1677078.327519, -3541903.135506}},
      {{78.2298, 15.4078, 450}, {1258427.117579, 346812.900105, 6222660.937153}},
      {{27.99, 86.93, 8820}, {302271.432714, 5635928.367499, 2979666.134903}},
      {{-49.879481, -64.795067, 715933.903}, {1950200.214051, -4143460.396744, -5401629.607588}},
      {{0.0001, 179.9999, 12}, {-6378148.999981, 11.131970, 11.057449}},
      {{-0.0001, -179.9999, 12}, {-6378148.999981, -11.131970, -11.057449}},
      {{12.5, 180, 3000}, {-6230855.206964, 0.000000, 1372104.425859}},
      {{-62.1, -179.5, -10000}, {-2987560.549470, -26072.045932, -5604901.075331}},
      {{51.4779, 0, 45}, {3980600.533983, 0.000000, 4966866.657855}},
      {{35.6, 139.7, 40}, {-3959768.561756, 3358127.950577, 3692218.303454}},
      {{-77.85, 166.67, 0}, {-1310449.426779, 310501.699379, -6213433.229913}},
      {{19.82, -155.47, 4205}, {-5464448.516294, -2493748.892398, 2150387.036208}},
      {{64.1, -21.9, 120}, {2592013.435667, -1041982.720241, 5714701.015160}},
      {{1.3, 103.8, 15}, {-1521013.675137, 6192458.429652, 143734.813291}},
      {{-1.29, 36.82, 1795}, {5105991.589846, 3822550.262024, -142669.417535}},
      {{60, -100, 35786000}, {-3662258.228324, -20769698.509041, 36492062.233769}},
      {{-25, 130, 35786000}, {-24565507.014664, 29276031.238624, -17802891.577610}},
      {{5, 5, 100000000}, {105570236.476982, 9236198.897487, 9267758.234794}},
      {{-85, -85, 100000000}, {808223.208604, -9238033.546651, -105951870.673161}},
      {{30, 30, 20000000}, {19787610.688268, 11424382.357491, 13170373.735384}},
      {{-45, 135, 1300000}, {-3844419.145061, 3844419.145061, -5406587.224408}},
      {{66.5622, 25.8, 693000}, {2538670.629493, 1227241.332864, 6464987.450834}},
      {{-8.8, -140.1, -430}, {-4835537.774297, -4043137.147747, -969242.638268}},
      {{40, 0, -10000}, {4885047.155642, 0.000000, 4071557.696104}},
      {{89, 179, -10000}, {-111496.686219, 1946.181897, 6345779.149688}},
      {{10, -60, -5000000}, {678917.032271, -1175918.794018, 232007.659401}},
      {{-70, 20, -6000000}, {127616.637781, 46448.657550, -332884.282403}},
  };
  return table;
}

TEST(Ellipsoid, HasTheCoordinatesOfGeographicLib) {
  for (const auto& [place, ecef_m] : by_geographiclib()) {
    const Vec3 found = ecef_of(from_deg(place[0], place[1], place[2]));
    // The last digit, and what a rounding of the angles, 2.2e-16 each, moves.
    EXPECT_LE(core::norm(found - ecef_m), 9e-7 + 1e-15 * core::norm(ecef_m)) << place[0] << ' ' << place[1];
  }
}

TEST(Ellipsoid, HasThePlacesOfGeographicLib) {
  for (const auto& [place, ecef_m] : by_geographiclib()) {
    const Geodetic found = geodetic_of(ecef_m);
    const double meridian_m = curvature_radii(found.latitude_rad).meridian_m + found.height_m;
    const double axis_m = std::hypot(ecef_m.x, ecef_m.y);
    EXPECT_NEAR(found.height_m, place[2], 9e-7);
    EXPECT_NEAR(meridian_m * found.latitude_rad, meridian_m * place[0] * rad_per_deg, 9e-7);
    if (axis_m == 0.0) continue;
    EXPECT_NEAR(axis_m * std::remainder(found.longitude_rad - place[1] * rad_per_deg, 2.0 * pi), 0.0, 9e-7);
  }
}

// Made with 50 digits (mpmath 1.3) from the doubles that stand here.
TEST(Ellipsoid, IsExactToOneRounding) {
  struct Exact {
    Geodetic place;
    ExtendedVec3 ecef_m;
  };
  const std::vector<Exact> table{
      {{0.7, -1.2, 30.0}, {1770147.323752557290L, -4553087.310192701887L, 4087102.873003928911L}},
      {{-0.59, 0.322, 100.0}, {5032760.064164021376L, 1678981.692821499008L, -3528504.796180414152L}},
      {{1.57, 3.14, 0.0}, {-5096.160867811244L, 8.116425762845L, 6356750.285137775906L}},
      {{-1.5, -3.0, -10000.0}, {-447451.205358952668L, -63782.622518337470L, -6330746.702235084773L}},
      {{0.001, 1.5707963, 705000.0}, {0.1897918290887L, 7083133.479780611258L, 7040.438175092233L}},
      {{0.3, 2.2, 35786000.0}, {-23706426.054580709188L, 32568434.707367466151L, 12448283.986394214525L}},
      {{-0.785, 0.785, 1e8}, {53236775.006903778491L, 53194398.007222668634L, -75168073.467763074258L}},
      {{1.2, -0.4, 8848.0}, {2137896.006601520597L, -903887.933958519276L, 5930368.584483130802L}},
  };
  for (const auto& [place, ecef_m] : table) {
    const Vec3 found = ecef_of(place);
    const double unit = 0.5 * spacing(largest(found));
    EXPECT_LE(std::abs(static_cast<double>(found.x - ecef_m.x)), unit + 1e-11);
    EXPECT_LE(std::abs(static_cast<double>(found.y - ecef_m.y)), unit + 1e-11);
    EXPECT_LE(std::abs(static_cast<double>(found.z - ecef_m.z)), unit + 1e-11);
    if (std::numeric_limits<long double>::digits < 64 || place.height_m > 1e6) continue;
    const ExtendedVec3 off = extended_ecef_of(place) - ecef_m;
    EXPECT_LE(std::abs(static_cast<double>(off.x)), 3e-12);
    EXPECT_LE(std::abs(static_cast<double>(off.y)), 3e-12);
    EXPECT_LE(std::abs(static_cast<double>(off.z)), 3e-12);
    const Geodetic back = geodetic_of(ecef_m);
    EXPECT_LE(std::abs(back.latitude_rad - place.latitude_rad), spacing(place.latitude_rad));
    EXPECT_NEAR(back.height_m, place.height_m, 1e-11);
  }
}

TEST(Ellipsoid, HasTheValuesOfTheSpecification) {
  const std::vector<InDegrees> table{
      {{-33.95, 18.46, 100.0}, {5023911.9730, 1677078.3275, -3541903.1355}},
      {{45.0, 45.0, 700000.0}, {3544419.1451, 3544419.1451, 4982323.1557}},
      {{78.2298, 15.4078, 450.0}, {1258427.1176, 346812.9001, 6222660.9372}},
      {{27.99, 86.93, 8820.0}, {302271.4327, 5635928.3675, 2979666.1349}},
      {{90.0, 0.0, 0.0}, {0.0, 0.0, 6356752.3142}},
      {{0.0, 0.0, 0.0}, {6378137.0, 0.0, 0.0}},
  };
  for (const auto& [place, ecef_m] : table)
    EXPECT_LE(largest(ecef_of(from_deg(place[0], place[1], place[2])) - ecef_m), 5.1e-5);
}

// The reduced latitude b, tan b = (1 - f) tan(lat), gives the point of the ellipse as (a cos b, b sin b).
TEST(Ellipsoid, IsTheEllipseOfTheReducedLatitudeAndTheNormalOnIt) {
  for (double latitude = -1.55; latitude < 1.56; latitude += 0.05) {
    const double reduced = std::atan((1.0 - wgs84_flattening) * std::tan(latitude));
    const Vec3 found = ecef_of({latitude, 0.0, 1234.0});
    EXPECT_NEAR(found.x, wgs84_semi_major_m * std::cos(reduced) + 1234.0 * std::cos(latitude), 5e-9);
    EXPECT_NEAR(found.z, semi_minor_m * std::sin(reduced) + 1234.0 * std::sin(latitude), 5e-9);
  }
}

// Half a unit of each coordinate and of the result is lost on the way; nothing else is.
void expect_round_trip(const Geodetic& place) {
  const Vec3 ecef_m = ecef_of(place);
  const Geodetic back = geodetic_of(ecef_m);
  const double lost_m = 0.5 * std::sqrt(3.0) * spacing(largest(ecef_m));
  const double radius_m = curvature_radii(place.latitude_rad).meridian_m + place.height_m;
  const double axis_m = std::hypot(ecef_m.x, ecef_m.y);
  EXPECT_NEAR(back.height_m, place.height_m, lost_m + spacing(place.height_m) + 1e-11) << place.height_m;
  EXPECT_NEAR(back.latitude_rad, place.latitude_rad, lost_m / radius_m + spacing(place.latitude_rad));
  EXPECT_LE(lost_m / radius_m + spacing(place.latitude_rad), 1e-15);
  const double turned_rad = std::remainder(back.longitude_rad - place.longitude_rad, 2.0 * pi);
  EXPECT_LE(axis_m * std::abs(turned_rad), lost_m + axis_m * 5e-16) << place.latitude_rad;
}

TEST(Ellipsoid, LeadsBackToThePlaceItCameFrom) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> sine(-1.0, 1.0), turn(-pi, pi), power(0.0, 8.0), shallow(-1e4, 1e4);
  for (int i = 0; i < 10'000; ++i) {
    expect_round_trip({std::asin(sine(random)), turn(random), std::pow(10.0, power(random))});
    expect_round_trip({std::asin(sine(random)), turn(random), shallow(random)});
  }
}

TEST(Ellipsoid, LeadsBackAtThePolesTheEquatorAndTheDateline) {
  for (const double height_m : {-1e4, 0.0, 1.0, 7e5, 1e8})
    for (const double latitude :
         {-pi / 2.0, -pi / 2.0 + 1e-9, -0.3, -1e-17, 0.0, 1e-300, 1e-8, pi / 2.0 - 1e-7, pi / 2.0})
      for (const double longitude : {-pi, -pi + 1e-15, -pi / 2.0, 0.0, 1e-20, pi / 2.0, pi - 1e-15, pi})
        expect_round_trip({latitude, longitude, height_m});
}

// Deeper than any use: to 100 km from the centre.
TEST(Ellipsoid, LeadsBackFromDeepInside) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> sine(-1.0, 1.0), turn(-pi, pi), depth(-6.25e6, 0.0);
  for (int i = 0; i < 5'000; ++i) {
    const Geodetic place{std::asin(sine(random)), turn(random), depth(random)};
    const Geodetic back = geodetic_of(extended_ecef_of(place));
    EXPECT_NEAR(back.height_m, place.height_m, 1e-9);
    EXPECT_NEAR(back.latitude_rad, place.latitude_rad, 3e-16);
    EXPECT_NEAR(back.longitude_rad, place.longitude_rad, 5e-16);
  }
}

// No other point of the ellipse is nearer; half a degree of latitude between those that are tried.
TEST(Ellipsoid, TakesTheNearestPointNearTheCentre) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> near(-6e4, 6e4);
  for (int i = 0; i < 200; ++i) {
    const double z = i % 5 == 0 ? 0.0 : (i % 5 == 1 ? 1e-9 : 1.0) * near(random);
    const Vec3 point{i % 7 == 0 ? 0.0 : near(random), 0.0, z};
    const Geodetic place = geodetic_of(point);
    for (double latitude = -pi / 2.0; latitude <= pi / 2.0; latitude += pi / 360.0)
      for (const double longitude : {0.0, pi})
        EXPECT_LE(-place.height_m, core::norm(point - ecef_of({latitude, longitude, 0.0})) + 1e-8);
    EXPECT_LE(core::norm(ecef_of(place) - point), 2e-9) << point.x << ' ' << point.z;
  }
}

TEST(Ellipsoid, HasTheNorthPoleAboveTheCentre) {
  const Geodetic centre = geodetic_of(Vec3{});
  EXPECT_EQ(centre.latitude_rad, pi / 2.0);
  EXPECT_EQ(centre.longitude_rad, 0.0);
  EXPECT_NEAR(centre.height_m, -6356752.314245179, 1e-9);
}

TEST(Ellipsoid, HasOneLongitudeOnTheAxisAndNoMinusPiWithoutSign) {
  EXPECT_EQ(geodetic_of(Vec3{-0.0, -0.0, 7e6}).longitude_rad, 0.0);
  EXPECT_EQ(geodetic_of(Vec3{0.0, 0.0, -7e6}).latitude_rad, -pi / 2.0);
  EXPECT_EQ(geodetic_of(Vec3{-7e6, -0.0, 0.0}).longitude_rad, pi);
  EXPECT_EQ(geodetic_of(Vec3{-7e6, 0.0, 0.0}).latitude_rad, 0.0);
}

TEST(Ellipsoid, GivesNothingForWhatIsNotFinite) {
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(geodetic_of(Vec3{odd, 0.0, 1.0}).height_m));
    EXPECT_TRUE(std::isnan(geodetic_of(Vec3{1.0, 2.0, odd}).latitude_rad));
  }
  EXPECT_TRUE(std::isfinite(geodetic_of(Vec3{1e300, 1e300, -1e300}).latitude_rad));
}

TEST(CurvatureRadii, AreThoseOfTheEquatorAndThePole) {
  EXPECT_NEAR(curvature_radii(0.0).meridian_m, 6335439.3273, 1e-4);
  EXPECT_EQ(curvature_radii(0.0).prime_vertical_m, wgs84_semi_major_m);
  EXPECT_NEAR(curvature_radii(pi / 2.0).meridian_m, 6399593.6258, 1e-4);
  EXPECT_DOUBLE_EQ(curvature_radii(-pi / 2.0).meridian_m, curvature_radii(pi / 2.0).prime_vertical_m);
}

// M is the way along the meridian for a radian of latitude; N cos(lat) is the distance from the axis. A difference of
// extended coordinates over 2e-4 rad: (1e-4)^2/6 of the third derivative.
TEST(CurvatureRadii, AreWaysOnTheGroundForARadian) {
  for (const double latitude : {-1.3, -0.6, 0.0, 0.4, 1.1}) {
    const CurvatureRadii radii = curvature_radii(latitude);
    const ExtendedVec3 way =
        extended_ecef_of({latitude + 1e-4, 0.0, 0.0}) - extended_ecef_of({latitude - 1e-4, 0.0, 0.0});
    EXPECT_NEAR(core::norm(rounded(way)) / 2e-4, radii.meridian_m, 2e-9 * radii.meridian_m);
    EXPECT_NEAR(ecef_of({latitude, 0.0, 0.0}).x, radii.prime_vertical_m * std::cos(latitude), 3e-9);
    EXPECT_DOUBLE_EQ(radii.along_m(0.0), radii.meridian_m);
    EXPECT_DOUBLE_EQ(radii.along_m(pi / 2.0), radii.prime_vertical_m);
    EXPECT_DOUBLE_EQ(1.0 / radii.along_m(pi / 4.0), 0.5 / radii.meridian_m + 0.5 / radii.prime_vertical_m);
  }
}

}  // namespace ellipsoid_test
}  // namespace sarsim::radar
