#pragma once

#include "radar/waveform/pulse.hpp"

namespace sarsim::radar {

/// The band about zero that holds `share` of the energy of a pulse of any shape [Hz].
/// @param share  0 to 1
[[nodiscard]] double energy_band_hz(const Pulse& pulse, double share);

/// Width of the main lobe of a pulse's autocorrelation where its power is half of the highest [s]: times c/2 what the
/// matched filter makes of a point, whatever the shape of the pulse. 0 for a pulse without energy.
[[nodiscard]] double half_power_width_s(const Pulse& pulse);

}  // namespace sarsim::radar
