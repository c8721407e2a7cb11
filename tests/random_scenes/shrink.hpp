#pragma once

#include <functional>

#include "scene/model/scene.hpp"

namespace sarsim::test {

/// Makes a scene plainer as long as it still fails: leaves out objects, puts initial values in place of others.
/// @param fails   whether a scene shows the same failure
/// @param trials  the most scenes that are tried
[[nodiscard]] scene::Scene shrunk(scene::Scene scene, const std::function<bool(const scene::Scene&)>& fails,
                                  int trials = 400);

}  // namespace sarsim::test
