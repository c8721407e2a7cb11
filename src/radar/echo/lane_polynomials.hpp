#pragma once

#include <cstddef>

#include "core/os/aligned_vector.hpp"

namespace sarsim::radar {

/// Functions of x in [0, 1), one for each of some lanes, as polynomials on equal pieces of that interval: on piece p
/// they are polynomials in y = pieces x - p - 1/2, evaluated together. Real is float or double.
template <class Real>
struct LanePolynomials {
  std::size_t lanes = 0;  ///< Padded to whole vectors, a multiple of `granularity` or what was asked for, by zeros.
  std::size_t degree = 0;
  std::size_t pieces = 1;
  core::AlignedVector<Real> coefficients;  ///< [pieces][degree + 1][lanes], highest power first.

  /// One lane at x in [0, 1], one at a time.
  [[nodiscard]] double value(std::size_t lane, double x) const;
  /// Its second derivative by x.
  [[nodiscard]] double second_derivative(std::size_t lane, double x) const;

  static constexpr std::size_t granularity = 64 / sizeof(Real);
};

}  // namespace sarsim::radar
