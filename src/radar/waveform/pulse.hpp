#pragma once

#include <complex>
#include <vector>

#include "core/maths/interpolator.hpp"

namespace sarsim::radar {

/// Signs of the Barker code with the given index 0 to 6: lengths 2, 3, 4, 5, 7, 11, 13 (Barker 1953).
[[nodiscard]] const std::vector<int>& barker_code(int index);

/// The complex envelope of a transmitted pulse (thesis 4.4, 6.2.10): modulation times amplitude envelope.
struct Pulse {
  /// One frequency, a linear sweep, chips of either sign, or I and Q by points.
  enum class Kind { mono, chirp, code, user };
  /// Full amplitude throughout, straight rise and fall, or points.
  enum class Envelope { rectangular, linear, user };

  Kind kind = Kind::mono;
  double width_s = 1e-6;        ///< Tp, edge to edge; positive.
  double sweep_hz = 0.0;        ///< Swept bandwidth, negative for a down chirp; Kind::chirp.
  std::vector<int> code;        ///< +1 or -1 per chip; Kind::code.
  core::Interpolator in_phase;  ///< I and Q against the fraction of the width; Kind::user.
  core::Interpolator quadrature;
  Envelope envelope = Envelope::rectangular;
  double rise_s = 0.0;               ///< Envelope::linear: from 0 to 1 over the first `rise_s`,
  double fall_s = 0.0;               ///< back to 0 over the last `fall_s`.
  core::Interpolator envelope_gain;  ///< Against the fraction of the width; Envelope::user.

  /// Sweep rate K [Hz/s]: sweep/width for a chirp, otherwise 0 (thesis 6.16, 6.17).
  [[nodiscard]] double sweep_rate_hz_per_s() const { return kind == Kind::chirp ? sweep_hz / width_s : 0.0; }

  /// Value at `t_s` after the leading edge, 0 <= t < Tp; the caller decides whether the pulse is on.
  /// A chirp is exp(j pi K u^2), u = t - Tp/2 (thesis 6.20); a code's chip is floor(t L/Tp), where a time closer than
  /// `tolerance_s` to the end of a chip counts as the beginning of the next.
  [[nodiscard]] std::complex<double> value(double t_s, double tolerance_s = 0.0) const;

  /// Amplitude envelope alone, same argument.
  [[nodiscard]] double envelope_value(double t_s) const;

  /// Times inside (0, Tp) where the pulse or its slope jumps, ascending.
  [[nodiscard]] std::vector<double> breaks_s() const;
};

/// Bandwidth of a pulse for sampling and band limiting [Hz] (decision 7): |sweep| of a chirp, code length/Tp, 1/Tp, and
/// for a user-defined pulse the band about zero that holds 99 % of its energy.
[[nodiscard]] double bandwidth_hz(const Pulse& pulse);

/// The band about zero that holds `share` of the energy of a pulse of any shape [Hz].
/// @param share  0 to 1
[[nodiscard]] double energy_band_hz(const Pulse& pulse, double share);

/// Width of the main lobe of a pulse's autocorrelation where its power is half of the highest [s]: times c/2 what the
/// matched filter makes of a point, whatever the shape of the pulse. 0 for a pulse without energy.
[[nodiscard]] double half_power_width_s(const Pulse& pulse);

}  // namespace sarsim::radar
