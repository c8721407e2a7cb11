#include "signal/search/canceller.hpp"

#include <cmath>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

std::vector<double> canceller_weights(std::size_t order) {
  std::vector<double> weights{1.0};
  for (std::size_t n = 0; n < order; ++n) {
    weights.push_back(0.0);
    for (std::size_t k = weights.size() - 1; k > 0; --k) weights[k] = weights[k - 1] - weights[k];
    weights[0] = -weights[0];
  }
  return weights;
}

std::vector<std::complex<float>> cancelled(std::span<const std::complex<float>> volts, std::size_t samples,
                                           std::size_t order) {
  if (samples == 0 || volts.size() % samples != 0)
    throw std::invalid_argument("canceller: the samples are not a whole number of pulses");
  const std::size_t pulses = volts.size() / samples;
  if (pulses <= order) return {};
  const std::vector<double> weights = canceller_weights(order);
  std::vector<std::complex<float>> out((pulses - order) * samples);
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::complex<double> sum;
    for (std::size_t k = 0; k <= order; ++k) sum += weights[k] * std::complex<double>(volts[i + k * samples]);
    out[i] = std::complex<float>(sum);
  }
  return out;
}

double canceller_gain(std::size_t order, double doppler_hz, double prf_hz) {
  CORE_EXPECT(prf_hz > 0.0);
  return std::pow(2.0 * std::sin(core::pi * doppler_hz / prf_hz), 2.0 * static_cast<double>(order));
}

double canceller_noise_gain(std::size_t order) {
  double sum = 0.0;
  for (const double w : canceller_weights(order)) sum += w * w;
  return sum;
}

}  // namespace sarsim::signal
