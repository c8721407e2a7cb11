#pragma once

#include "core/maths/interpolator.hpp"
#include "radar/waveform/pulse.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The pulse that a radar sends, its functions ready to be evaluated. The radar has passed `check`.
/// @param rules  for I, Q and the envelope: those of FunctionRole::pulse
[[nodiscard]] radar::Pulse pulse_of(const Radar& radar, core::InterpolationRules rules);
/// Same, by the usual rules.
[[nodiscard]] radar::Pulse pulse_of(const Radar& radar);

}  // namespace sarsim::scene
