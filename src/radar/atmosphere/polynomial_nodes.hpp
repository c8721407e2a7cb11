#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

/// How to make a polynomial of y in [-1, 1] from its values at n Chebyshev points, the ends among them (Trefethen 2013,
/// ch. 2), so that polynomials of neighbouring pieces meet.
template <std::size_t n>
struct PolynomialNodes {
  std::array<double, n> y{};  ///< The points, ascending.
  std::array<std::array<double, n>, n>
      powers{};  ///< By point: powers of y, lowest first, that are 1 at this point only.
};

/// The points and polynomials of one degree n - 1.
template <std::size_t n>
[[nodiscard]] const PolynomialNodes<n>& polynomial_nodes() {
  static const PolynomialNodes<n> made = [] {
    PolynomialNodes<n> nodes;
    for (std::size_t i = 0; i < n; ++i)
      nodes.y[i] = std::sin(0.5 * core::pi * (2.0 * static_cast<double>(i) / (n - 1.0) - 1.0));
    for (std::size_t i = 0; i < n; ++i) {
      auto& powers = nodes.powers[i];
      powers[0] = 1.0;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        const double scale = 1.0 / (nodes.y[i] - nodes.y[j]);
        for (std::size_t k = n - 1; k > 0; --k) powers[k] = scale * (powers[k - 1] - nodes.y[j] * powers[k]);
        powers[0] *= -scale * nodes.y[j];
      }
    }
    return nodes;
  }();
  return made;
}

/// Powers of y, lowest first, of the polynomial with these values at the points.
template <std::size_t n>
[[nodiscard]] std::array<double, n> powers_through(const std::array<double, n>& values) {
  const auto& nodes = polynomial_nodes<n>();
  std::array<double, n> powers{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) powers[k] += values[i] * nodes.powers[i][k];
  return powers;
}

/// Value of a polynomial in powers of y (Horner).
template <std::size_t n>
[[nodiscard]] double value_of_powers(const std::array<double, n>& powers, double y) {
  double value = powers[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) value = value * y + powers[k];
  return value;
}

}  // namespace sarsim::radar
