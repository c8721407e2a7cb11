#pragma once

#include <complex>
#include <optional>
#include <span>

#include "radar/echo/echo_batch.hpp"
#include "radar/waveform/band_limited_pulse.hpp"
#include "radar/waveform/pulse.hpp"

namespace sarsim::radar {

/// The pulse that echoes repeat, as one simulation defines it.
struct EchoPulse {
  Pulse pulse;
  std::optional<BandLimitedPulse> band_limited;  ///< Set: the pulse is confined to a band (decision 7).
  double lead_s = 0.0;  ///< How long before its delay an echo begins: Tp/2 for CENTRE, 0 for BEGIN (thesis 6.19).
  double light_speed_mps = 0.0;

  /// The interval around an echo's delay, in seconds, in which it is not 0.
  [[nodiscard]] double first_s() const { return (band_limited ? band_limited->first_s() : 0.0) - lead_s; }
  [[nodiscard]] double last_s() const { return (band_limited ? band_limited->last_s() : pulse.width_s) - lead_s; }
};

/// Samples [begin, end) of the grid that an echo with this delay touches.
struct SampleSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};
[[nodiscard]] SampleSpan touched_samples(const EchoPulse& pulse, const SampleGrid& grid, double delay_s);

/// Adds the baseband echoes of one pulse to a row: the plain double-precision sum that every fast kernel is held
/// against.
///
/// Sample i at time t = grid.time_s(i) receives from each echo (tau, A, v), where it is on,
///
///     A p(w) exp(-j 2 pi f tau) exp(-j 2 pi (2v/c)(f u + K u^2/2)),   w = t - tau + lead,   u = w - Tp/2,
///
/// p the pulse's value at w after its leading edge and K its sweep rate: thesis (6.20) to (6.24) with the Doppler shift
/// for either sign of v. An ideal pulse is on for 0 <= w < Tp, where a time within 1e-9 of a sampling interval of an
/// edge counts as on it (decision 8). Echoes are added in the order of the batch.
///
/// @param[in,out] row  grid.count samples in volts (1 ohm); added to.
/// @param carrier_hz   f of this pulse.
///
/// Accuracy: rounding of double arithmetic, about 1e-15 (f tau + B Tp) of A. Cost: echoes times pulse samples.
void add_echoes(std::span<std::complex<double>> row, const SampleGrid& grid, const EchoPulse& pulse, double carrier_hz,
                const EchoBatch& echoes);

}  // namespace sarsim::radar
