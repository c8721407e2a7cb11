#pragma once

#include "math/interpolator.hpp"
#include "scene/scene.hpp"
#include "waveform/pulse.hpp"

namespace sarsim {

/// The pulse that a radar sends, its functions ready to be evaluated. The radar has passed `check`.
[[nodiscard]] Pulse pulse_of(const Radar& radar, LowPassRule rule = LowPassRule::first_knot);

}  // namespace sarsim
