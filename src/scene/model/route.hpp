#pragma once

#include "radar/motion/segment_path.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The path of a platform with Path::legs or Path::waypoints; the fault says which leg or point cannot be flown and
/// why.
[[nodiscard]] radar::PathResult route_of(const Platform& platform);

}  // namespace sarsim::scene
