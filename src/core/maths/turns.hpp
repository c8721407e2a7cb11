#pragma once

#include <cmath>
#include <complex>

#include "core/maths/constants.hpp"

namespace sarsim::core {

/// exp(2 pi j turns) in float, for any |turns| below 2^51: the whole turns are taken away in double precision, the rest
/// goes through polynomials (Taylor about 0 on an eighth of a turn): error below 1.5e-7, and no branches, so that loops
/// of it become vector code.
inline std::complex<float> turned(double turns) {
  const double quarters = 4.0 * turns;
  const double whole = std::nearbyint(quarters);
  const auto x = static_cast<float>((quarters - whole) * 1.57079632679489662);
  const float xx = x * x;
  const float sine = x * (1.0F + xx * (-1.0F / 6 + xx * (1.0F / 120 + xx * (-1.0F / 5040 + xx * (1.0F / 362880)))));
  const float cosine =
      1.0F + xx * (-0.5F + xx * (1.0F / 24 + xx * (-1.0F / 720 + xx * (1.0F / 40320 + xx * (-1.0F / 3628800)))));
  const auto quadrant = static_cast<unsigned>(static_cast<long long>(whole)) & 3U;
  const float a = (quadrant & 1U) != 0 ? sine : cosine;
  const float b = (quadrant & 1U) != 0 ? cosine : sine;
  return {(quadrant == 1 || quadrant == 2) ? -a : a, quadrant >= 2 ? -b : b};
}

/// exp(2 pi j turns) in double: the whole turns are taken away first.
inline std::complex<double> turned_exactly(double turns) {
  return std::polar(1.0, 2.0 * pi * (turns - std::round(turns)));
}

/// a b without the care for infinities that std::complex takes.
template <class Real>
inline std::complex<Real> product(std::complex<Real> a, std::complex<Real> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace sarsim::core
