#pragma once

#include <optional>

#include "core/maths/vector.hpp"
#include "radar/earth/ellipsoid.hpp"

namespace sarsim::radar {

/// Seas and mines end above this height, m: no radar, target or reference point is deeper.
inline constexpr double deepest_place_m = -12e3;

/// Ten times the distance of the Moon: no radar, target or reference point is further from the centre of the Earth.
inline constexpr double farthest_place_m = 4e9;

/// How far below the WGS 84 ellipsoid an Earth-fixed position is, m, where that is deeper than `deepest_place_m`;
/// nothing for any other position.
[[nodiscard]] inline std::optional<double> impossible_depth_m(const core::Vec3& ecef_m) {
  if (core::norm(ecef_m) >= wgs84_semi_major_m + deepest_place_m) return std::nullopt;
  const double height_m = geodetic_of(ecef_m).height_m;
  return height_m < deepest_place_m ? std::optional(-height_m) : std::nullopt;
}

}  // namespace sarsim::radar
