#pragma once

#include <cmath>
#include <cstddef>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

// What the parts of SGP4 share. Units of Spacetrack Report 3: minutes, radians, Earth radii of 6378.135 km.

/// WGS-72 as SGP4 uses it: two-line elements are fitted with these values, so that others would be wrong.
struct Sgp4Earth {
  static constexpr double radius_km = 6378.135;
  static constexpr double mu_km3_per_s2 = 398'600.8;
  static constexpr double j2 = 0.001082616;
  static constexpr double j3 = -0.00000253881;
  static constexpr double j4 = -0.00000165597;
  /// Root of the gravitational parameter, Earth radii^1.5 per minute.
  static double root_mu() { return 60.0 / std::sqrt(radius_km * radius_km * radius_km / mu_km3_per_s2); }
};

/// Mean elements, at the epoch or at another time.
struct Sgp4Elements {
  double motion = 0.0;  ///< rad/min; at the epoch the mean motion n0'' of Brouwer's theory.
  double axis = 0.0;    ///< Semi-major axis, Earth radii.
  double eccentricity = 0.0;
  double inclination = 0.0;  ///< rad
  double node = 0.0;         ///< Right ascension of the ascending node, rad.
  double perigee = 0.0;      ///< Argument of perigee, rad.
  double anomaly = 0.0;      ///< Mean anomaly, rad.
};

/// How the zonal harmonics of the Earth turn the orbit, rad/min.
struct Sgp4Rates {
  double anomaly = 0.0;
  double perigee = 0.0;
  double node = 0.0;
};

/// Remainder of a division by one turn, with the sign of the angle. SGP4 is defined with this one: in orbits of low
/// inclination the lunar and solar terms depend on the turn that the node is in.
inline double sgp4_remainder(double angle_rad) { return std::fmod(angle_rad, 2.0 * core::pi); }

}  // namespace sarsim::radar
