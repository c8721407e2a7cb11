#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::signal {

/// Moving-target indication by differences from pulse to pulse: order 1 is the two-pulse canceller x[p + 1] - x[p],
/// order 2 the three-pulse canceller x[p + 2] - 2 x[p + 1] + x[p], and so on with binomial weights (Skolnik, Radar
/// Handbook, 3rd ed., ch. 2).
///
/// @param volts    pulses of `samples` each, one after the other
/// @return         as many pulses less `order`; none where there are not more
/// @throw          std::invalid_argument where `volts` is not a whole number of pulses
[[nodiscard]] std::vector<std::complex<float>> cancelled(std::span<const std::complex<float>> volts,
                                                         std::size_t samples, std::size_t order);

/// Its weights, those of the earliest pulse first: the coefficients of (z - 1)^order.
[[nodiscard]] std::vector<double> canceller_weights(std::size_t order);

/// Power gain of the canceller for a Doppler frequency: (2 sin(pi f/PRF))^(2 order).
[[nodiscard]] double canceller_gain(std::size_t order, double doppler_hz, double prf_hz);

/// Power gain for noise that is white from pulse to pulse, the sum of the squared weights: 2, 6, 20 ...
[[nodiscard]] double canceller_noise_gain(std::size_t order);

}  // namespace sarsim::signal
