#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "radar/echo/reference_kernel.hpp"

namespace sarsim::radar {

/// A pulse seen as a smooth body plus the surroundings of its hard edges. Times in samples after the leading edge of
/// the ideal pulse (so that a band-limited pulse begins before 0).
class PulseBody {
 public:
  /// Edge regions are `edge_samples` long where the pulse leaves room; beta shapes the Kaiser step.
  PulseBody(const EchoPulse& pulse, double interval_s, std::size_t edge_samples, double beta);

  /// A one-sided edge region [start, start + edge_samples) inside the pulse.
  struct Edge {
    double start = 0.0;
    bool rising = true;  ///< The hard edge is at its start; otherwise at its end.
  };

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// False where the edges leave no room for a body: then the pulse is better added directly.
  [[nodiscard]] bool has_body() const { return has_body_; }
  /// The whole pulse, body and edges, without Doppler.
  [[nodiscard]] std::complex<double> value(double t) const;
  /// Share of the body, 0 at a hard edge to 1 away from it.
  [[nodiscard]] double body_share(double t) const;
  /// Same at `x` of an edge region, 0 at the hard edge, 1 at its end.
  [[nodiscard]] double step(double x) const;
  /// The body of an echo at `t` after the delay less the lead, with what motion does to it: 0 outside.
  [[nodiscard]] std::complex<double> echo(double t, const PulseClock& clock, double carrier_hz) const;
  /// The same without its ends: the pulse goes on as it does inside, where its modulation says how.
  [[nodiscard]] std::complex<double> endless_echo(double t, const PulseClock& clock, double carrier_hz) const;
  /// Whether motion changes how long a pulse is.
  [[nodiscard]] bool is_stretched() const { return pulse_->doppler_rule == DopplerRule::stretch; }
  /// When what stands at `t` of the pulse comes back in an echo.
  [[nodiscard]] double received(double t, const PulseClock& clock) const;
  /// Phase per unit of D by the rule of the thesis [turns]: f u + K u^2/2, u from the middle of the ideal pulse.
  [[nodiscard]] double doppler_turns(double t, double carrier_hz) const;
  /// Largest |f + K u| of the pulse, what a moving target's D shifts [Hz]: the carrier, unless a chirp sweeps far.
  [[nodiscard]] double largest_frequency_hz(double carrier_hz) const;
  /// Largest phase per unit of D over the pulse [turns], with what the stretch does to its own spectrum.
  [[nodiscard]] double largest_doppler_turns(double carrier_hz) const;
  /// Seconds from the middle of the ideal pulse.
  [[nodiscard]] double from_middle_s(double t) const;
  /// Half the band that the body needs, cycles per sample.
  [[nodiscard]] double half_band() const { return half_band_; }

 private:
  void find_edges(std::size_t edge_samples);
  [[nodiscard]] double share_of_echo(double t, const PulseClock& clock) const;
  [[nodiscard]] std::complex<double> part_of_echo(double share, double t, const PulseClock& clock,
                                                  double carrier_hz) const;

  const EchoPulse* pulse_;
  double interval_s_;
  double first_ = 0.0;
  double last_ = 0.0;
  double width_ = 0.0;  // edge regions, samples
  double half_band_ = 0.5;
  bool has_body_ = true;
  std::vector<Edge> edges_;
  std::vector<double> step_table_;
};

}  // namespace sarsim::radar
