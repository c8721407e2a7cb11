#include "radar/earth/transverse_mercator.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace transverse_mercator_test {

Geodetic place_at(double latitude_deg, double longitude_deg) {
  return {core::rad_per_deg * latitude_deg, core::rad_per_deg * longitude_deg, 0.0};
}

// Computed by GeographicLib 2.1.2, GeoConvert -u -p 9 and -c -p 9: zone, easting, northing, convergence, scale.
struct Known {
  double latitude_deg;
  double longitude_deg;
  UtmPlace utm;  // convergence in degrees
};
constexpr Known known[] = {
    {0.0, 3.0, {31, true, 500000.0, 0.0, 0.0, 0.9996}},
    {0.0, 0.0001, {31, true, 166032.585950233, 0.0, 0.0, 1.000980969331877}},
    {45.0, 10.0, {32, true, 578815.302916711, 4983436.768349295, 0.7071430455193, 0.999676381331436}},
    {-16.2, -76.2, {18, false, 371730.634652129, 8208566.742908003, 0.3348353211720, 0.999803461046426}},
    {60.0, 10.0, {32, true, 555776.266751610, 6651832.735433668, 0.8660474985462, 0.999638124356628}},
    {60.0, 5.0, {32, true, 276979.926401006, 6658157.202407252, -3.4655153412295, 1.000209576447437}},
    {75.0, 10.0, {33, true, 355706.566570205, 8329692.650741234, -4.8304504955847, 0.999854530496068}},
    {75.0, 22.0, {35, true, 355706.566570205, 8329692.650741234, -4.8304504955847, 0.999854530496068}},
    {70.5, 14.9, {33, true, 496274.469791126, 7821636.469038520, -0.0942641597985, 0.999600169772438}},
    {83.9, 179.99, {60, true, 535457.200006287, 9317850.302331258, 2.9731009195839, 0.999615357300096}},
    {-79.9, -179.5, {1, false, 451070.714912129, 1128524.571853051, 2.4613059989526, 0.999629252197617}},
    {52.3, 13.4, {33, true, 390898.459699140, 5795611.364196742, -1.2660816489331, 0.999746115647069}},
    {-33.9, 18.4, {34, false, 259583.221660430, 6245888.045440769, 1.4508329115288, 1.000312593681725}},
    {0.5, 5.9999, {31, true, 833954.759287304, 55341.383119678, 0.0262031672886, 1.000980863240350}},
    {48.1, -180.0, {1, true, 276657.242118629, 5331768.861465071, -2.2338531238309, 1.000212957763324}},
};

TEST(TransverseMercator, AgreesWithGeographicLib) {
  for (const Known& one : known) {
    SCOPED_TRACE(testing::Message() << one.latitude_deg << ", " << one.longitude_deg);
    const Geodetic place = place_at(one.latitude_deg, one.longitude_deg);
    const auto zone = utm_zone(place);
    ASSERT_TRUE(zone);
    EXPECT_EQ(*zone, one.utm.zone);
    const UtmPlace utm = utm_of(place, *zone, one.latitude_deg >= 0.0);
    // The rounding of the angles, 1.4e-9 m at 180 deg, of the digits above and of the result.
    EXPECT_NEAR(utm.easting_m, one.utm.easting_m, 3e-9);
    EXPECT_NEAR(utm.northing_m, one.utm.northing_m, 4e-9);
    EXPECT_NEAR(core::deg_per_rad * utm.convergence_rad, one.utm.convergence_rad, 1e-12);
    EXPECT_NEAR(utm.scale, one.utm.scale, 1e-14);
  }
}

TEST(TransverseMercator, ReachesBeyondItsZone) {
  const UtmPlace utm = utm_of(place_at(45.0, 0.0), 31, true);  // GeoConvert -z 31n
  EXPECT_NEAR(utm.easting_m, 263553.973898792, 2e-9);
  EXPECT_NEAR(utm.northing_m, 4987329.504698914, 2e-9);
  EXPECT_NEAR(core::deg_per_rad * utm.convergence_rad, -2.1222997165782, 1e-12);
}

TEST(TransverseMercator, ConvergenceAndScaleAreThoseOfItsDifferences) {
  const Geodetic place = place_at(52.3, 13.4);
  constexpr double step_rad = 1e-5;  // 64 m: rounding 2e-9/128, third order below 1e-10
  const auto at = [&](double north_rad) {
    return utm_of({place.latitude_rad + north_rad, place.longitude_rad, 0.0}, 33, true);
  };
  const UtmPlace ahead = at(step_rad);
  const UtmPlace behind = at(-step_rad);
  const double east_m = ahead.easting_m - behind.easting_m;
  const double north_m = ahead.northing_m - behind.northing_m;
  // True north on the map lies opposite to the grid's.
  EXPECT_NEAR(std::atan2(-east_m, north_m), at(0.0).convergence_rad, 1e-9);
  EXPECT_NEAR(std::hypot(east_m, north_m) / (2.0 * step_rad * curvature_radii(place.latitude_rad).meridian_m),
              at(0.0).scale, 1e-9);
}

TEST(TransverseMercator, IsEvenAboutItsMiddleAndTheEquator) {
  const UtmPlace east = utm_of(place_at(30.0, 5.0), 31, true);
  const UtmPlace west = utm_of(place_at(30.0, 1.0), 31, true);
  const UtmPlace south = utm_of(place_at(-30.0, 5.0), 31, false);
  EXPECT_NEAR(east.easting_m + west.easting_m, 1e6, 2e-9);
  EXPECT_NEAR(east.northing_m + south.northing_m, 1e7, 4e-9);
  EXPECT_NEAR(east.convergence_rad + west.convergence_rad, 0.0, 1e-15);
}

TEST(TransverseMercator, HasZonesAsTheConventionHasThem) {
  EXPECT_EQ(utm_zone(place_at(0.0, -180.0)), 1);
  EXPECT_EQ(utm_zone(place_at(0.0, 180.0)), 1);
  EXPECT_EQ(utm_zone(place_at(0.0, 179.9)), 60);
  EXPECT_EQ(utm_zone(place_at(0.0, 363.0)), 31);
  EXPECT_EQ(utm_zone(place_at(60.0, 4.0)), 32);
  EXPECT_EQ(utm_zone(place_at(64.0, 4.0)), 31);
  EXPECT_EQ(utm_zone(place_at(73.0, 8.0)), 31);
  EXPECT_EQ(utm_zone(place_at(73.0, 40.0)), 37);
  EXPECT_FALSE(utm_zone(place_at(84.1, 0.0)));
  EXPECT_FALSE(utm_zone(place_at(-80.1, 0.0)));
  EXPECT_FALSE(utm_zone(place_at(NAN, 0.0)));
}

}  // namespace transverse_mercator_test
}  // namespace sarsim::radar
