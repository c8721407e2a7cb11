#include "radar/earth/ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sarsim::radar {

namespace {

constexpr long double semi_major_m = wgs84_semi_major_m;
// From 1/f, the decimal number that defines the ellipsoid.
constexpr long double flattening = 1.0L / 298.257223563L;
constexpr long double semi_minor_m = semi_major_m * (1.0L - flattening);
constexpr long double eccentricity2 = flattening * (2.0L - flattening);
constexpr long double focal2_m2 = semi_major_m * semi_major_m * eccentricity2;  // a^2 - b^2

// sqrt(1 - e^2 sin^2), the ratio a/N.
long double shrinkage(long double sine) { return std::sqrt(1.0L - eccentricity2 * sine * sine); }

// The ellipsoid's normal in the plane of a meridian: (cos lat, sin lat).
ExtendedTurn normal_of(long double outward, long double north) {
  const long double length = std::hypot(outward, north);
  return {north / length, outward / length};
}

// The nearest point of the ellipse to (p, z), z >= 0, is (a^2 p/(s + E^2), b^2 z/s) with E^2 = a^2 - b^2 and the
// largest root s of
//
//     n(s) = |(a p/(s + E^2), b z/s)| = 1.
//
// 1/n is concave and nearly straight: Newton's steps on it, from below the root, rise to it without passing it.
long double nearest_root_m2(long double axis_distance_m, long double z_m) {
  const long double ap = semi_major_m * axis_distance_m;
  const long double bz = semi_minor_m * z_m;
  long double s = std::max(ap - focal2_m2, bz);
  for (int step = 0; step < 60; ++step) {
    const long double y1 = ap / (s + focal2_m2);
    const long double y2 = bz / s;
    const long double n2 = y1 * y1 + y2 * y2;
    const long double rise = (std::sqrt(n2) - 1.0L) * n2 / (y1 * y1 / (s + focal2_m2) + y2 * y2 / s);
    s += rise;
    if (!(rise > 1e-11L * s)) break;  // the next step would be its square
  }
  return s;
}

ExtendedTurn nearest_normal(long double axis_distance_m, long double z_m) {
  const long double cosine = semi_major_m * axis_distance_m / focal2_m2;  // of the reduced latitude, where z = 0
  if (z_m == 0.0L && cosine <= 1.0L)
    return normal_of(cosine / semi_major_m, std::sqrt(1.0L - cosine * cosine) / semi_minor_m);
  const long double s = nearest_root_m2(axis_distance_m, z_m);
  return normal_of(axis_distance_m / (s + focal2_m2), z_m / s);
}

}  // namespace

ExtendedVec3 extended_ecef_of(const Geodetic& place) {
  const ExtendedTurn latitude = extended_turn(place.latitude_rad);
  const ExtendedTurn longitude = extended_turn(place.longitude_rad);
  const long double radius_m = semi_major_m / shrinkage(latitude.sine);
  const long double axis_distance_m = (radius_m + place.height_m) * latitude.cosine;
  return {axis_distance_m * longitude.cosine, axis_distance_m * longitude.sine,
          (radius_m * (1.0L - eccentricity2) + place.height_m) * latitude.sine};
}

core::Vec3 ecef_of(const Geodetic& place) { return rounded(extended_ecef_of(place)); }

Geodetic geodetic_of(const ExtendedVec3& ecef_m) {
  const long double axis_distance_m = std::hypot(ecef_m.x, ecef_m.y);
  const long double z_m = std::abs(ecef_m.z);
  if (!std::isfinite(axis_distance_m + z_m)) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing, nothing};
  }
  const ExtendedTurn normal = nearest_normal(axis_distance_m, z_m);
  const long double latitude_rad = std::atan2(normal.sine, normal.cosine);
  // To the first order this does not feel an error of the latitude.
  const long double height_m =
      axis_distance_m * normal.cosine + z_m * normal.sine - semi_major_m * shrinkage(normal.sine);
  const long double longitude_rad = axis_distance_m == 0.0L ? 0.0L : std::atan2(ecef_m.y + 0.0L, ecef_m.x);
  return {static_cast<double>(ecef_m.z < 0.0L ? -latitude_rad : latitude_rad), static_cast<double>(longitude_rad),
          static_cast<double>(height_m)};
}

Geodetic geodetic_of(const core::Vec3& ecef_m) { return geodetic_of(extended(ecef_m)); }

double CurvatureRadii::along_m(double azimuth_rad) const {
  const double north = std::cos(azimuth_rad);
  const double east = std::sin(azimuth_rad);
  return 1.0 / (north * north / meridian_m + east * east / prime_vertical_m);
}

CurvatureRadii curvature_radii(double latitude_rad) {
  const long double ratio = shrinkage(std::sin(static_cast<long double>(latitude_rad)));
  return {static_cast<double>(semi_major_m * (1.0L - eccentricity2) / (ratio * ratio * ratio)),
          static_cast<double>(semi_major_m / ratio)};
}

}  // namespace sarsim::radar
