#pragma once

#include <cstddef>
#include <vector>

#include "core/maths/vector.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// Where the first `most` platforms of a scene are at a time, world coordinates, m; with the motion errors of pulse 0.
/// Those of the script come first, then the world where it carries anything.
[[nodiscard]] std::vector<core::Vec3> platform_places_m(const ResolvedScene& scene, double time_s, std::size_t most);

/// Where the first `most` targets are at a time, in the order of the scene and without the points of clouds, world
/// coordinates, m. Of the undisturbed targets, on platforms with the motion errors of pulse 0.
[[nodiscard]] std::vector<core::Vec3> target_places_m(const ResolvedScene& scene, double time_s, std::size_t most);

}  // namespace sarsim::simulate
