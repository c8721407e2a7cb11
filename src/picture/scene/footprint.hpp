#pragma once

#include <optional>
#include <vector>

#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::picture {

/// Where lines from an antenna meet the ground, in the world: the plane z = 0, or the ellipsoid where the world has an
/// Earth; nothing for those that miss it.
/// @param directions_world  of unit length, such as those of `half_power_outline`
[[nodiscard]] std::vector<std::optional<core::Vec3>> ground_points(
    const core::Vec3& from_world_m, const std::vector<std::optional<core::Vec3>>& directions_world,
    const std::optional<radar::EarthFrame>& earth);

/// The points of the ground at a slant range, across the beam of a radar and half its width beyond it on both sides;
/// empty where the radar is at rest on the ground, sees none at that range, or the antenna is isotropic.
/// @param range_m  one way
[[nodiscard]] std::vector<core::Vec3> range_on_ground(const Snapshot::Radar& radar, double range_m,
                                                      const std::optional<radar::EarthFrame>& earth);

}  // namespace sarsim::picture
