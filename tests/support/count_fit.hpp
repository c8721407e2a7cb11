#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <span>
#include <vector>

#include "workflow/verify/counts.hpp"

namespace sarsim::test {

using namespace workflow::verify;

/// LSBs for which every count lies within `slack` of v/LSB: an interval, empty where lowest > highest.
struct LsbInterval {
  double lowest = 0.0;
  double highest = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return !(lowest <= highest); }
};

/// |v/LSB - count| <= slack is v/(count + slack) <= LSB <= v/(count - slack) for each component (signs turned so that
/// v is positive; a count below the slack leaves the LSB unbounded above).
inline LsbInterval lsb_interval(std::span<const std::complex<double>> volts,
                                std::span<const std::complex<double>> counts, double slack) {
  LsbInterval interval;
  const auto narrow = [&](double v, double count) {
    if (v == 0.0) {
      if (std::abs(count) > slack) interval.lowest = std::numeric_limits<double>::infinity();
      return;
    }
    if (v < 0.0) v = -v, count = -count;
    if (count + slack <= 0.0) {
      interval.lowest = std::numeric_limits<double>::infinity();
      return;
    }
    interval.lowest = std::max(interval.lowest, v / (count + slack));
    if (count > slack) interval.highest = std::min(interval.highest, v / (count - slack));
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    narrow(volts[i].real(), counts[i].real());
    narrow(volts[i].imag(), counts[i].imag());
  }
  return interval;
}

/// The LSB that makes the largest |v/LSB - count| smallest, by bisection on that largest deviation.
inline double fitted_lsb_v(std::span<const std::complex<double>> volts, std::span<const std::complex<double>> counts) {
  double impossible = 0.0;
  double possible = 1e6;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (impossible + possible);
    (lsb_interval(volts, counts, middle).empty() ? impossible : possible) = middle;
  }
  const LsbInterval interval = lsb_interval(volts, counts, possible);
  return 0.5 * (interval.lowest + interval.highest);
}

/// Largest difference of two lists in I or in Q.
inline double largest_component_difference(std::span<const std::complex<double>> a,
                                           std::span<const std::complex<double>> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max({largest, std::abs(a[i].real() - b[i].real()), std::abs(a[i].imag() - b[i].imag())});
  return largest;
}

/// |sum of a conj(b)| over the product of the norms: 1 for proportional lists.
inline double correlation(std::span<const std::complex<double>> a, std::span<const std::complex<double>> b) {
  std::complex<double> product = 0.0;
  double a_power = 0.0;
  double b_power = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += a[i] * std::conj(b[i]);
    a_power += std::norm(a[i]);
    b_power += std::norm(b[i]);
  }
  return std::abs(product) / std::sqrt(a_power * b_power);
}

}  // namespace sarsim::test
