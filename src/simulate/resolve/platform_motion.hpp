#pragma once

#include <string>
#include <vector>

#include "core/maths/interpolator.hpp"
#include "radar/earth/sagnac.hpp"
#include "radar/motion/track.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::simulate {

/// How the axes of a world turn with its Earth; at rest over a flat one.
[[nodiscard]] radar::TurningAxes turning_of(const scene::World& world);

/// Ready motions of all platforms of a scene, in its order. Parents and leaders are followed; the scene must have
/// passed `check` and its files must be read, otherwise std::invalid_argument.
[[nodiscard]] std::vector<radar::Track> tracks_of(const scene::Scene& scene, core::InterpolationRules rule);

}  // namespace sarsim::simulate
