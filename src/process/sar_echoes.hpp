#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "math/vector.hpp"

namespace sarsim {

/// Where the antenna was when one pulse left it.
struct TrackPoint {
  double time_s = 0.0;
  Vec3 position_m;    ///< World.
  Vec3 velocity_mps;  ///< World.
};

/// The waveform and the receiver, as far as focusing needs to know them.
struct SarWaveform {
  double carrier_hz = 0.0;
  double bandwidth_hz = 0.0;   ///< Of the pulse.
  double pulse_width_s = 0.0;  ///< Chirp rate: bandwidth_hz/pulse_width_s.
  double sample_rate_hz = 0.0;
  double light_speed_mps = 0.0;
};

/// Range-compressed echoes of a train of pulses and the path the antenna took: what every focusing algorithm begins
/// with. Sample (p, n) is the compressed baseband echo of pulse p at the delay first_delay_s + n/sample_rate_hz; a
/// target at distance d that recedes with v has its peak at 2 d/(c - v) with the phase -2 pi carrier_hz times that
/// delay (docs/theory/echo-model.md).
struct SarEchoes {
  SarWaveform waveform;
  std::vector<TrackPoint> track;  ///< One for each pulse.
  std::size_t samples = 0;        ///< Of each pulse.
  double first_delay_s = 0.0;
  std::vector<std::complex<float>> volts;  ///< track.size() rows of `samples`.
};

}  // namespace sarsim
