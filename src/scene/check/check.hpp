#pragma once

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Everything about the values of a scene that stops it from being simulated (errors) or that a radar engineer would
/// ask about (warnings, ranked by consequence). Needs no geometry of echoes; `survey` (simulate/survey/survey.hpp) adds
/// what does. Every problem names its subject; `place` is left empty. A sound scene gives no problem at all. The
/// outcome is the same for any number of threads. A requested stop throws Interrupted.
[[nodiscard]] core::Problems check(const Scene& scene, const core::WorkControl& control = {});

}  // namespace sarsim::scene
