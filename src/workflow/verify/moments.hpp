#pragma once

#include <cmath>
#include <cstddef>
#include <span>

/// Sample moments, and how far they may lie from the truth by chance: five standard deviations, which one sound test in
/// two million exceeds. Seeds are fixed, so what holds once holds for ever.
namespace sarsim::workflow::verify {

inline constexpr double gate_sigmas = 5.0;

/// Arithmetic mean; not a number of nothing.
inline double mean(std::span<const double> x) {
  double sum = 0.0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

/// Mean square deviation from a known mean.
inline double mean_square(std::span<const double> x, double about = 0.0) {
  double sum = 0.0;
  for (const double value : x) sum += (value - about) * (value - about);
  return sum / static_cast<double>(x.size());
}

/// Mean of x[i] x[i + lag].
inline double mean_product(std::span<const double> x, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < x.size(); ++i) sum += x[i] * x[i + lag];
  return sum / static_cast<double>(x.size() - lag);
}

/// Correlation coefficient of two lists of mean 0.
inline double correlation_coefficient(std::span<const double> x, std::span<const double> y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum / static_cast<double>(x.size()) / std::sqrt(mean_square(x) * mean_square(y));
}

/// Gate of the mean of n independent values.
inline double mean_gate(double stddev, std::size_t n) {
  return gate_sigmas * stddev / std::sqrt(static_cast<double>(n));
}

/// Gate of the mean square of n independent normal values of the given variance.
inline double variance_gate(double variance, std::size_t n) {
  return gate_sigmas * variance * std::sqrt(2.0 / static_cast<double>(n));
}

/// Gate of a correlation coefficient of n independent pairs that are not correlated.
inline double correlation_gate(std::size_t n) { return gate_sigmas / std::sqrt(static_cast<double>(n)); }

}  // namespace sarsim::workflow::verify
