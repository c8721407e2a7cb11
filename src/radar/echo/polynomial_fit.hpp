#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

namespace sarsim::radar {

/// Terms of the polynomials that the shapes of pulses are fitted by: degree 12.
inline constexpr std::size_t fit_terms = 13;

/// Values at the nodes, or coefficients of a polynomial of y in [-1, 1], lowest first.
using FitTerms = std::array<std::complex<double>, fit_terms>;

/// Where to sample a function of y in [-1, 1]: zeros of the Chebyshev polynomial of degree `fit_terms`.
[[nodiscard]] const std::array<double, fit_terms>& fit_nodes();

/// Chebyshev coefficients of the polynomial through the values at the nodes (Trefethen 2013, ch. 3).
[[nodiscard]] FitTerms chebyshev_series(const FitTerms& at_nodes);

/// Lowest degree to which the series can be cut without dropping coefficients that sum to more than `tolerance`.
[[nodiscard]] std::size_t degree_within(const FitTerms& series, double tolerance);

/// The series cut after `degree`, as powers of y; the rest is 0.
[[nodiscard]] FitTerms powers_of(const FitTerms& series, std::size_t degree);

/// Value of a polynomial in powers of y (Horner).
[[nodiscard]] inline std::complex<double> polynomial(std::span<const std::complex<double>> powers, double y) {
  double re = 0.0;
  double im = 0.0;
  for (std::size_t d = powers.size(); d-- > 0;) {
    re = re * y + powers[d].real();
    im = im * y + powers[d].imag();
  }
  return {re, im};
}

}  // namespace sarsim::radar
