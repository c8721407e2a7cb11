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
  DopplerRule doppler_rule = DopplerRule::stretch;

  /// The interval around an echo's delay, in seconds, in which it is not 0 where nothing moves.
  [[nodiscard]] double first_s() const { return (band_limited ? band_limited->first_s() : 0.0) - lead_s; }
  [[nodiscard]] double last_s() const { return (band_limited ? band_limited->last_s() : pulse.width_s) - lead_s; }
  /// How the pulse is stretched in echo k: not at all by the rule of the thesis.
  [[nodiscard]] PulseClock clock_of(const EchoBatch& echoes, std::size_t k) const { return clock_of(echoes.clock(k)); }
  [[nodiscard]] PulseClock clock_of(const PulseClock& echo) const {
    return doppler_rule == DopplerRule::stretch ? echo : PulseClock{};
  }
  /// Seconds from the pulse's middle of a time after the delay.
  [[nodiscard]] double from_middle_s(double after_delay_s) const {
    return after_delay_s + lead_s - 0.5 * pulse.width_s;
  }
};

/// Samples [begin, end) of a row.
struct SampleSpan {
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] bool is_empty() const { return begin >= end; }
  /// The shortest span that holds both.
  [[nodiscard]] SampleSpan with(const SampleSpan& other) const {
    if (is_empty()) return other;
    if (other.is_empty()) return *this;
    return {begin < other.begin ? begin : other.begin, end > other.end ? end : other.end};
  }
};
/// Those that an echo with this delay and stretch touches.
[[nodiscard]] SampleSpan touched_samples(const EchoPulse& pulse, const SampleGrid& grid, double delay_s,
                                         const PulseClock& clock);

/// Adds the baseband echoes of one pulse to a row: the plain double-precision sum that every fast kernel is held
/// against.
///
/// Sample i at time t = grid.time_s(i) receives from each echo (tau, A, D, a, phi), where it is on,
///
///     A p(e + Tp/2) exp(-j 2 pi (f tau - phi)) exp(-j 2 pi f (D u + a u^2/2)),
///     u = t - tau + lead - Tp/2,   e = u - (D u + a u^2/2),
///
/// p the pulse's value after its leading edge: what is received at u from the echo's middle was sent at e from the
/// pulse's. By the rule of the thesis (6.20 to 6.24), for either sign of v, it receives
///
///     A p(u + Tp/2) exp(-j 2 pi (f tau - phi)) exp(-j 2 pi D (f u + K u^2/2)),
///
/// K the sweep rate. An ideal pulse is on for -Tp/2 <= e < Tp/2, where a time within 1e-9 of a sampling interval of an
/// edge counts as on it (decision 8). Echoes are added in the order of the batch.
///
/// @param[in,out] row  grid.count samples in volts (1 ohm); added to.
/// @param carrier_hz   f of this pulse.
///
/// Accuracy: rounding of double arithmetic, about 1e-15 (f tau + B Tp) of A. Cost: echoes times pulse samples.
void add_echoes(std::span<std::complex<double>> row, const SampleGrid& grid, const EchoPulse& pulse, double carrier_hz,
                const EchoBatch& echoes);

}  // namespace sarsim::radar
