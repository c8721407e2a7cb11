#pragma once

#include <memory>
#include <span>

#include "signal/sar/focusing.hpp"
#include "signal/sar/image_spectrum.hpp"

namespace sarsim::signal {

struct FocusFrame;

/// Image of a point by a method in the frequency domain, relative to the weighted mean of its echoes, each at its true
/// phase, as back-projection gives it.
struct SwathLoss {
  double from_middle_m = 0.0;  ///< Of its closest distance, from that of the middle of the swath.
  double amplitude = 1.0;      ///< Of its peak, relative to that mean.
  double phase_rad = 0.0;  ///< Error of the peak's phase, carried to the true place by the image's spectral centre, as
                           ///< `measure` does; in (-pi, pi].
  ImagePlace shift{};      ///< Displacement of the peak.
};

/// Losses of points, each at a closest distance R, from the phase that the method leaves in its spectrum. Range-Doppler
/// and chirp scaling take out the secondary range compression of the middle of the swath, Rm, for all ranges, and
///
///     -2 pi (2 (R - Rm)/c) (sqrt((f0 + f)^2 - (f0 sin a)^2) - f0 cos a - f/cos a)
///
/// remains at each range frequency f and each Doppler frequency 2 V f0 sin a/c. Omega-k leaves no phase. All lose the
/// frequencies that correspond to no direction and those that are aliased at the upper end of a wide band; omega-k also
/// those whose echoes are outside the span for which its rows are interpolated. The spectrum is that of
/// the pulses' echoes, with the windows of range and azimuth, filled evenly over the pulse's band; the peak is where
/// its sum is largest.
class PointLosses {
 public:
  /// @param echoes  their track, waveform and window; no rows are read
  PointLosses(const EchoRows& echoes, const FocusOptions& options);

  /// Closest distance of the middle of the swath.
  [[nodiscard]] double middle_m() const;
  /// @param range_m  closest distance
  /// @param seen     directions of the point (sines in (-1, 1)) and amplitudes of its echoes, for evenly spaced pulses,
  ///                 without the window over the pulses
  [[nodiscard]] SwathLoss of(double range_m, std::span<const SeenDirection> seen) const;
  /// Upper bound of the phase that range-Doppler and chirp scaling leave in the spectrum of a point between two sines,
  /// in cycles: to find which of many points may lose most. 0 for omega-k.
  [[nodiscard]] double left_turns(double range_m, double low_sine, double high_sine) const;

 private:
  std::shared_ptr<const FocusFrame> frame_;
};

}  // namespace sarsim::signal
