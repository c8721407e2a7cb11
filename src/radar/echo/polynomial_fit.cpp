#include "radar/echo/polynomial_fit.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using Matrix = std::array<std::array<double, fit_terms>, fit_terms>;

// T_d at each node.
Matrix polynomials_at_nodes() {
  Matrix t{};
  for (std::size_t d = 0; d < fit_terms; ++d)
    for (std::size_t k = 0; k < fit_terms; ++k)
      t[d][k] = std::cos(core::pi * static_cast<double>(d) * (static_cast<double>(k) + 0.5) / fit_terms);
  return t;
}

// Coefficient of y^p in T_d, by T_(d+1) = 2 y T_d - T_(d-1).
Matrix powers_of_polynomials() {
  Matrix c{};
  c[0][0] = 1.0;
  c[1][1] = 1.0;
  for (std::size_t d = 2; d < fit_terms; ++d)
    for (std::size_t p = 0; p < fit_terms; ++p) c[d][p] = (p > 0 ? 2.0 * c[d - 1][p - 1] : 0.0) - c[d - 2][p];
  return c;
}

}  // namespace

const std::array<double, fit_terms>& fit_nodes() {
  static const std::array<double, fit_terms> nodes = polynomials_at_nodes()[1];
  return nodes;
}

FitTerms chebyshev_series(const FitTerms& at_nodes) {
  static const Matrix t = polynomials_at_nodes();
  FitTerms series{};
  for (std::size_t d = 0; d < fit_terms; ++d) {
    for (std::size_t k = 0; k < fit_terms; ++k) series[d] += t[d][k] * at_nodes[k];
    series[d] *= (d == 0 ? 1.0 : 2.0) / fit_terms;
  }
  return series;
}

std::size_t degree_within(const FitTerms& series, double tolerance) {
  CORE_EXPECT(tolerance >= 0.0);
  double dropped = 0.0;
  for (std::size_t d = fit_terms - 1; d > 0; --d) {
    dropped += std::abs(series[d]);
    if (!(dropped <= tolerance)) return d;
  }
  return 0;
}

FitTerms powers_of(const FitTerms& series, std::size_t degree) {
  CORE_EXPECT(degree < fit_terms);
  static const Matrix c = powers_of_polynomials();
  FitTerms powers{};
  for (std::size_t d = 0; d <= degree; ++d)
    for (std::size_t p = 0; p <= d; ++p) powers[p] += c[d][p] * series[d];
  return powers;
}

}  // namespace sarsim::radar
