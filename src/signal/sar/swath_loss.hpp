#pragma once

#include "signal/sar/focusing.hpp"

namespace sarsim::signal {

/// What range-Doppler and chirp scaling do to a point off the middle of the swath.
struct SwathLoss {
  double from_middle_m = 0.0;  ///< Of its closest distance, from that of the middle of the swath.
  double amplitude = 1.0;      ///< Of its peak, relative to that of a point in the middle.
  double phase_rad = 0.0;      ///< Error of the peak's phase, in (-pi, pi].
  ImagePlace shift{};          ///< Displacement of the peak.
};

/// The loss of a point at a closest distance R, from the phase that these methods leave in its spectrum: they take out
/// the secondary range compression of the middle of the swath, Rm, for all ranges, and
///
///     -2 pi (2 (R - Rm)/c) (sqrt((f0 + f)^2 - (f0 sin a)^2) - f0 cos a - f/cos a)
///
/// remains at each range frequency f and angle a. The sum of the spectrum, filled evenly over the pulse's band and
/// between two Doppler frequencies, is taken where it is largest. Omega-k has none of it.
/// @param echoes  their track, waveform and window; no rows are read
/// @param options range_doppler or chirp_scaling
[[nodiscard]] SwathLoss loss_off_mid_swath(const EchoRows& echoes, const FocusOptions& options, double range_m,
                                           double lowest_doppler_hz, double highest_doppler_hz);

}  // namespace sarsim::signal
