#pragma once

#include <optional>
#include <vector>

#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::picture {

/// The unit vector that lies at the given offsets from a beam's axis, in the world.
[[nodiscard]] core::Vec3 off_axis(const Snapshot::Radar& radar, double azimuth_rad, double elevation_rad);

/// Where the half-power contour of a beam meets the ground, in the world: the plane z = 0, or the ellipsoid where the
/// world has an Earth. In order around the beam; empty where the antenna is isotropic or some of the contour misses
/// the ground.
[[nodiscard]] std::vector<core::Vec3> footprint_of(const Snapshot::Radar& radar,
                                                   const std::optional<radar::EarthFrame>& earth);

/// The points of the ground at a slant range, across the beam of a radar and half its width beyond it on both sides;
/// empty where the radar is at rest on the ground, sees none at that range, or the antenna is isotropic.
/// @param range_m  one way
[[nodiscard]] std::vector<core::Vec3> range_on_ground(const Snapshot::Radar& radar, double range_m,
                                                      const std::optional<radar::EarthFrame>& earth);

}  // namespace sarsim::picture
