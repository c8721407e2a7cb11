#pragma once

#include "core/maths/vector.hpp"
#include "radar/earth/extended.hpp"

namespace sarsim::radar {

/// WGS-84 (NIMA TR8350.2; NGA.STND.0036): semi-major axis, m, and flattening. GRS-80, which goes
/// with ITRF, differs by 0.1 mm at the poles.
inline constexpr double wgs84_semi_major_m = 6'378'137.0;
inline constexpr double wgs84_flattening = 1.0 / 298.257223563;

/// Rate at which the Earth turns about its +z axis, rad/s (WGS-84's nominal value).
inline constexpr double earth_rate_rad_per_s = 7.292115e-5;

/// A place over the WGS-84 ellipsoid. A double of pi rad is good to 2.2e-16 rad: 1.4e-9 m on the ground.
struct Geodetic {
  double latitude_rad = 0.0;   ///< Of the ellipsoid's normal, north positive, in [-pi/2, pi/2].
  double longitude_rad = 0.0;  ///< East of Greenwich.
  double height_m = 0.0;       ///< Along the normal, over the ellipsoid, not over the sea.

  friend constexpr bool operator==(const Geodetic&, const Geodetic&) = default;
};

/// Earth-centred, Earth-fixed Cartesian coordinates, m: x towards latitude 0, longitude 0, z towards the north pole.
/// With the radius of curvature N,
///
///     x = (N + h) cos(lat) cos(lon)     y = (N + h) cos(lat) sin(lon)     z = (N (1 - e^2) + h) sin(lat)
///
/// computed in extended precision: the result is the true one for these doubles, rounded once, at most 5e-10 m off for
/// each coordinate up to 8e6 m from the centre. Any height.
[[nodiscard]] core::Vec3 ecef_of(const Geodetic& place);
/// The same before it is rounded: within 3e-12 m up to 1e7 m from the centre, where a long double has 64 bits.
[[nodiscard]] ExtendedVec3 extended_ecef_of(const Geodetic& place);

/// The place of Earth-fixed Cartesian coordinates: the nearest point of the ellipsoid and the signed distance to it.
/// Accurate to the rounding of the result (2.2e-16 rad; 1e-9 m up to 8e6 m height, 8e-9 m at 1e8 m) for what is at
/// least 100 km from the centre; `ecef_of` leads back there. Within 43 km of the centre lies the evolute, inside which
/// a place has several normals: the nearest point is taken, which is ill-conditioned near the evolute itself. The
/// longitude is in [-pi, pi]; on the axis it is 0. In the plane of the equator within 43 km of the axis the northern
/// one of two nearest points is taken; for the centre it is the north pole, at height -b. What is not finite gives NaN.
[[nodiscard]] Geodetic geodetic_of(const core::Vec3& ecef_m);
/// The same from coordinates that are not rounded.
[[nodiscard]] Geodetic geodetic_of(const ExtendedVec3& ecef_m);

/// The two principal radii of curvature of the ellipsoid at a latitude, m.
struct CurvatureRadii {
  double meridian_m = 0.0;        ///< M, of the north-south section: a (1 - e^2)/(1 - e^2 sin^2 lat)^(3/2).
  double prime_vertical_m = 0.0;  ///< N, of the east-west section: a/sqrt(1 - e^2 sin^2 lat).

  /// Of the normal section in a direction, clockwise from north: 1/R = cos^2(az)/M + sin^2(az)/N (Euler).
  [[nodiscard]] double along_m(double azimuth_rad) const;
};

/// The radii of curvature at a latitude; relative error 4e-16.
[[nodiscard]] CurvatureRadii curvature_radii(double latitude_rad);

}  // namespace sarsim::radar
