#pragma once

#include <string_view>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Message of an output whose name ends as another format does.
inline constexpr std::string_view other_extension = "the file name has the extension of another format";

/// Message about a recording's window, used where the echoes of its targets are not known. The survey, which knows
/// them, replaces it by one about targets (simulate::late_echoes).
inline constexpr std::string_view window_beyond_range = "the slant range window reaches beyond the unambiguous range";

/// Everything about the values of a scene that stops it from being simulated (errors) or that a radar engineer would
/// ask about (warnings, ranked by consequence). Needs no geometry of echoes; `survey` (simulate/survey/survey.hpp) adds
/// what does. Every problem names its subject; `place` is left empty. A sound scene gives no problem at all. The
/// outcome is the same for any number of threads. A requested stop throws Interrupted.
[[nodiscard]] core::Problems check(const Scene& scene, const core::WorkControl& control = {});

}  // namespace sarsim::scene
