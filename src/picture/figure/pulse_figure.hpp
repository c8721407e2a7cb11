#pragma once

#include "picture/figure/figure.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::picture {

/// The pulse that a radar sends: I and Q against time, and below them its energy spectrum about the carrier, in
/// decibels below the largest. The pulse is the ideal one, with hard edges where it has them; the spectrum is that of
/// samples at 16 times the bandwidth, fewer where the pulse is very long.
/// @param span_db  of the spectrum
[[nodiscard]] Figure sent_pulse_figure(const radar::Pulse& pulse, double span_db = 60.0);

}  // namespace sarsim::picture
