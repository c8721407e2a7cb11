#pragma once

#include <optional>

#include "radar/earth/ellipsoid.hpp"

namespace sarsim::radar {

/// Coordinates on the universal transverse Mercator map of WGS 84.
struct UtmPlace {
  int zone = 0;       ///< 1 to 60.
  bool north = true;  ///< Southern places have 10000 km added to their northing.
  double easting_m = 0.0;
  double northing_m = 0.0;
  double convergence_rad = 0.0;  ///< Azimuth of the map's grid north, clockwise from true north.
  double scale = 1.0;            ///< Metres on the map for a metre of the ellipsoid, in all directions.
};

/// The zone in which a place lies by convention: 6 deg wide from 180 deg west, with the exceptions of Norway and
/// Svalbard; nothing beyond 80 deg south and 84 deg north, where UTM ends.
[[nodiscard]] std::optional<int> utm_zone(const Geodetic& place);

/// The coordinates of a place in a zone, whatever its height, which does not count. Krueger's series to n^6 (Karney
/// 2011, "Transverse Mercator with an accuracy of a few nanometers", J. Geod. 85, eqs 7 to 12, 23 to 28, 35) in
/// extended precision: within 2e-9 m, the rounding of the northing, up to 20 deg from the zone's middle. The
/// longitude is the nearest one to the zone. Of the pole the convergence is that of its longitude.
/// @param zone   1 to 60
/// @param north  false: with the northing of the southern half
[[nodiscard]] UtmPlace utm_of(const Geodetic& place, int zone, bool north);

}  // namespace sarsim::radar
