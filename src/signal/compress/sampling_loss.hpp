#pragma once

#include "radar/waveform/pulse.hpp"

namespace sarsim::signal {

/// What sampling makes of compressed echoes of a pulse with hard edges, whose spectrum does not end at half the
/// sampling rate: what lies beyond is folded with a phase that depends on where between two samples the echo begins.
struct SamplingLoss {
  double mean_db = 0.0;      ///< Of the peak's amplitude, mean over all beginnings of an echo; positive is lower.
  double max_db = 0.0;       ///< The greatest.
  double max_shift_s = 0.0;  ///< The greatest distance of the peak from the echo's true delay.
};

/// The loss against an echo that begins with a sample, which keeps its amplitude. Peaks are those of the band-limited
/// continuation of the compressed samples. Zero for chirps of a time-bandwidth product of 125 and more, which lose at
/// most 0.16 dB where the rate is 1.1 times the bandwidth (0.36 dB where it is the bandwidth); a code is cut to its
/// first chips, up to 4096 samples of them.
/// @param pulse           not confined to a band
/// @param sample_rate_hz  of the raw samples, complex; positive
[[nodiscard]] SamplingLoss sampling_loss(const radar::Pulse& pulse, double sample_rate_hz);

}  // namespace sarsim::signal
