#pragma once

#include "core/maths/interpolator.hpp"
#include "radar/waveform/pulse.hpp"
#include "scene/model/scene.hpp"

namespace sarsim {

/// The pulse that a radar sends, its functions ready to be evaluated. The radar has passed `check`.
[[nodiscard]] Pulse pulse_of(const Radar& radar, LowPassRule rule = LowPassRule::first_knot);

}  // namespace sarsim
