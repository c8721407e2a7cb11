#pragma once

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::workflow {

/// What range-Doppler and chirp scaling lose off the middle of the swath, at the target that loses most; of more than
/// `most_examined_targets`, at the farther edge of the swath. A warning from 0.1 dB or 0.1 rad on, a note from a tenth
/// of that on. None for omega-k.
/// @param echoes  their track, waveform and window; no rows are read
/// @throw  Interrupted
[[nodiscard]] core::Problems remarks_on_swath_loss(const simulate::Plan& plan, const signal::EchoRows& echoes,
                                                   const signal::FocusOptions& options,
                                                   const core::WorkControl& control = {});

/// A warning where the area in azimuth that is asked for lies beyond all points whose echoes the record can hold: those
/// no farther from a pulse of it than the farthest sample, D: from x_first - D to x_last + D along the line of flight.
/// @param echoes  their track, waveform and window; no rows are read. At least two pulses, and a speed
[[nodiscard]] core::Problems remarks_on_area(const signal::EchoRows& echoes, const signal::FocusOptions& options);

}  // namespace sarsim::workflow
