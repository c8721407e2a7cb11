#pragma once

#include <cmath>

#include "core/maths/vector.hpp"
#include "radar/earth/ellipsoid.hpp"

namespace sarsim::radar {

/// Height of a point above the WGS 84 ellipsoid along the line from its centre, m: |r| - a b/hypot(b cos(phi), a
/// sin(phi)) with the geocentric latitude phi. Relative difference to the height along the normal: 1e-5.
/// @param from_centre_m  r, from the centre of the Earth, not 0; any axes
/// @param axis           rotation axis of the Earth in the same axes, length 1
[[nodiscard]] inline double height_over_ellipsoid_m(const core::Vec3& from_centre_m, const core::Vec3& axis) {
  constexpr double semi_minor_m = wgs84_semi_major_m * (1.0 - wgs84_flattening);
  const double distance_m = core::norm(from_centre_m);
  const double sine = core::dot(from_centre_m, axis) / distance_m;
  const double along = semi_minor_m * std::sqrt(1.0 - sine * sine);
  return distance_m - wgs84_semi_major_m * semi_minor_m / std::hypot(along, wgs84_semi_major_m * sine);
}

}  // namespace sarsim::radar
