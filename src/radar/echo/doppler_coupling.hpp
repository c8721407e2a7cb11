#pragma once

#include <cstddef>

#include "radar/echo/pulse_body.hpp"

namespace sarsim::radar {

/// What a unit of D does to the body of an echo once the echo is taken where its phase is: a frequency that Doppler
/// adds to a chirp looks like a delay (range-Doppler coupling), so the echo at delay + shift_s (D - D0) changes far
/// less with D than the one at its own delay. What is left are the ends of the pulse, which stay where they are, and
/// the stretch of the sweep.
struct DopplerCoupling {
  double shift_s = 0.0;      ///< f/K for a chirp; 0: nothing is shifted.
  double change = 0.0;       ///< What a unit of D changes, root mean square over that of the pulse.
  double curvature = 0.0;    ///< The same of the second derivative.
  double fastest_rad = 0.0;  ///< What each further derivative brings at most.

  /// Error of an interpolation between Chebyshev nodes over a half span of D: 2 (half/2)^R/R! times the largest
  /// derivative of order R.
  [[nodiscard]] double remainder(std::size_t terms, double half) const;
  /// The least number of terms with a remainder below `error`; at most one more than `max_doppler_terms`.
  [[nodiscard]] std::size_t terms_for(double half, double error) const;
  /// The largest half span of D for which so many terms have a remainder of at most `error`, and whose shift is no more
  /// than a sample; may be infinite.
  [[nodiscard]] double widest(std::size_t terms, double interval_s, double error) const;
};

/// Without a shift.
[[nodiscard]] DopplerCoupling no_coupling(const PulseBody& body, double carrier_hz);

/// With the shift of a chirp, its changes measured on the body itself at some thousand places; without one for other
/// pulses, for carriers that are 0, and where the shift gains nothing.
[[nodiscard]] DopplerCoupling coupling_of(const EchoPulse& pulse, const PulseBody& body, double interval_s,
                                          double carrier_hz);

/// The coupling that takes fewer terms: `coupled`, or none; none, too, where its shift would be more than a sample.
[[nodiscard]] DopplerCoupling best_coupling(const DopplerCoupling& coupled, const PulseBody& body, double carrier_hz,
                                            double half, double interval_s, double error);

}  // namespace sarsim::radar
