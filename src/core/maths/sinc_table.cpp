#include "core/maths/sinc_table.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"
#include "core/maths/window.hpp"

namespace sarsim::core {

namespace {

// Kaiser, "Nonrecursive digital filter design using the I0-sinh window function", 1974.
double kaiser_beta(double band) {
  const double attenuation_db = 2.285 * (SincTable::taps - 1) * 2.0 * pi * std::max(0.0, 1.0 - band) + 8.0;
  if (attenuation_db > 50.0) return std::min(0.1102 * (attenuation_db - 8.7), 12.0);
  if (attenuation_db < 21.0) return 0.0;
  return 0.5842 * std::pow(attenuation_db - 21.0, 0.4) + 0.07886 * (attenuation_db - 21.0);
}

std::complex<float> weighted_sum(const std::complex<float>* samples, const float* weights) {
  float real = 0.0F;
  float imag = 0.0F;
  for (std::size_t i = 0; i < SincTable::taps; ++i) {
    real += weights[i] * samples[i].real();
    imag += weights[i] * samples[i].imag();
  }
  return {real, imag};
}

}  // namespace

SincTable::SincTable(double band) : weights_((steps + 1) * taps) {
  const double beta = kaiser_beta(band);
  constexpr double half = taps / 2.0;
  // A position so far before a sample has the weights of the one so far behind it, backwards.
  for (std::size_t step = 0; step <= steps / 2; ++step) {
    const double fraction = static_cast<double>(step) / steps;
    double row[taps];
    double sum = 0.0;
    for (std::size_t i = 0; i < taps; ++i) {
      const double x = fraction + half - 1.0 - static_cast<double>(i);
      row[i] = sinc(x) * kaiser_window(x / half, beta);
      sum += row[i];
    }
    for (std::size_t i = 0; i < taps; ++i) {
      const auto weight = static_cast<float>(row[i] / sum);
      weights_[step * taps + i] = weight;
      weights_[(steps - step) * taps + taps - 1 - i] = weight;
    }
  }
}

SincTable::Place SincTable::place_of(double position) const {
  const double whole = std::floor(position);
  const auto step = static_cast<std::size_t>((position - whole) * steps + 0.5);
  return {static_cast<std::ptrdiff_t>(whole) - static_cast<std::ptrdiff_t>(taps / 2) + 1,
          weights_.data() + step * taps};
}

std::complex<float> SincTable::value(std::span<const std::complex<float>> samples, double position) const {
  const auto count = static_cast<double>(samples.size());
  if (!(position > -static_cast<double>(taps) && position < count + static_cast<double>(taps))) return {};
  const Place place = place_of(position);
  const auto size = static_cast<std::ptrdiff_t>(samples.size());
  if (place.first >= 0 && place.first + static_cast<std::ptrdiff_t>(taps) <= size)
    return weighted_sum(samples.data() + place.first, place.weights);
  std::complex<float> near[taps];
  for (std::size_t i = 0; i < taps; ++i) {
    const std::ptrdiff_t index = place.first + static_cast<std::ptrdiff_t>(i);
    if (index >= 0 && index < size) near[i] = samples[static_cast<std::size_t>(index)];
  }
  return weighted_sum(near, place.weights);
}

std::complex<float> SincTable::circular(std::span<const std::complex<float>> samples, double position) const {
  const Place place = place_of(position);
  const auto size = static_cast<std::ptrdiff_t>(samples.size());
  if (place.first >= 0 && place.first + static_cast<std::ptrdiff_t>(taps) <= size)
    return weighted_sum(samples.data() + place.first, place.weights);
  std::complex<float> near[taps];
  for (std::size_t i = 0; i < taps; ++i)
    near[i] = samples[static_cast<std::size_t>(((place.first + static_cast<std::ptrdiff_t>(i)) % size + size) % size)];
  return weighted_sum(near, place.weights);
}

}  // namespace sarsim::core
