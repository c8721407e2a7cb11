#pragma once

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::core {

/// Weights on x in [0, 1], symmetric about 1/2 (Harris 1978; the forms of the script language, docs/formats/script.md).

/// (1 + h - (1 - h) cos 2 pi x)/2: a Hann window on a pedestal h in [0, 1].
inline double hanning_window(double x, double pedestal) {
  return 0.5 * (1.0 + pedestal - (1.0 - pedestal) * std::cos(2.0 * pi * x));
}

/// 0.54 - 0.46 cos 2 pi x.
inline double hamming_window(double x) { return 0.54 - 0.46 * std::cos(2.0 * pi * x); }

/// The triangle from 0 at the ends to 1 in the middle.
inline double bartlett_window(double x) { return x <= 0.5 ? 2.0 * x : 2.0 - 2.0 * x; }

/// 0.42 - 0.5 cos 2 pi x + 0.08 cos 4 pi x, x from 0 to 1.
inline double blackman_window(double x) { return 0.42 - 0.5 * std::cos(2.0 * pi * x) + 0.08 * std::cos(4.0 * pi * x); }

/// Whether weights cancel to rounding, so that nothing is left to divide by: |sum w| <= 1e-9 sum |w|.
/// @param sum         of the weights, of either sign
/// @param magnitudes  sum of their magnitudes
inline bool weights_cancel(double sum, double magnitudes) { return std::abs(sum) <= 1e-9 * magnitudes; }

/// Modified Bessel function of the first kind and order 0, by its power series (Abramowitz and Stegun 9.6.12): all
/// terms are positive, so the sum is exact to rounding for any x whose value is finite. (std::cyl_bessel_i goes through
/// lgamma, which writes a global variable: not to be called from several threads.)
inline double bessel_i0(double x) {
  const double quarter = 0.25 * x * x;
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= quarter / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

/// Kaiser's window of the given beta at z in [-1, 1]: I0(beta sqrt(1 - z^2))/I0(beta); 0 outside.
inline double kaiser_window(double z, double beta) {
  if (std::abs(z) > 1.0) return 0.0;
  return bessel_i0(beta * std::sqrt((1.0 - z) * (1.0 + z))) / bessel_i0(beta);
}

}  // namespace sarsim::core
