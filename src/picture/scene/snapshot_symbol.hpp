#pragma once

#include <optional>

#include "picture/scene/snapshot.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/motion/track.hpp"

namespace sarsim::picture {

/// The place of the ground below or above a point: in the plane z = 0, or on the ellipsoid where the world has an
/// Earth.
[[nodiscard]] core::Vec3 ground_below(const core::Vec3& world_m, const std::optional<radar::EarthFrame>& earth);

/// What stands for a platform that moves: a satellite on an orbit, an aircraft from 20 m above the ground on, else a
/// vehicle. Its nose is along the way; it leans as the platform does. Nothing where the platform is at rest.
/// @param way_world  a velocity, or another step along the way, of any length
[[nodiscard]] std::optional<PlatformSymbol> symbol_of(const radar::Pose& pose, const core::Vec3& way_world, bool orbits,
                                                      const std::optional<radar::EarthFrame>& earth);

}  // namespace sarsim::picture
