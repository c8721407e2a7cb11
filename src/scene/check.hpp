#pragma once

#include "base/problem.hpp"
#include "scene/scene.hpp"

namespace sarsim {

/// Everything about the values of a scene that stops it from being simulated (errors) or that a radar engineer would
/// ask about (warnings, ranked by consequence). Needs no geometry of echoes; `survey` (simulate/survey.hpp) adds what
/// does. Every problem names its subject; `place` is left empty. A sound scene gives no problem at all.
[[nodiscard]] Problems check(const Scene& scene);

}  // namespace sarsim
