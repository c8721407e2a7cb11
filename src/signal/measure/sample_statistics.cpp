#include "signal/measure/sample_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::signal {

void SampleStatistics::add(std::span<const std::complex<double>> values, std::size_t first_row, std::size_t columns) {
  CORE_EXPECT(columns > 0);
  CORE_EXPECT(values.size() % columns == 0);
  double row_sum = 0.0;  // Summed row by row, so that a long file loses no digits.
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (columns > 0 && i % columns == 0) {
      sum_of_squares += row_sum;
      row_sum = 0.0;
    }
    const std::complex<double> v = values[i];
    ++samples;
    if (!std::isfinite(v.real()) || !std::isfinite(v.imag())) {
      ++not_finite;
      continue;
    }
    if (v == 0.0) ++zeros;
    lowest = std::min({lowest, v.real(), v.imag()});
    highest = std::max({highest, v.real(), v.imag()});
    const double power = std::norm(v);
    row_sum += power;
    // The root that neither overflows nor vanishes is taken of candidates alone: it is slow.
    if (power < largest_power_) continue;
    largest_power_ = power;
    const double magnitude = std::abs(v);
    if (magnitude > largest_magnitude) {
      largest_magnitude = magnitude;
      largest_row = first_row + i / columns;
      largest_column = i % columns;
    }
  }
  sum_of_squares += row_sum;
}

double SampleStatistics::rms() const {
  const std::uint64_t counted = samples - not_finite;
  return counted > 0 ? std::sqrt(sum_of_squares / static_cast<double>(counted)) : 0.0;
}

}  // namespace sarsim::signal
