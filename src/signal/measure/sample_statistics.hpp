#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace sarsim::signal {

/// What one pass over the samples of a file finds.
struct SampleStatistics {
  double lowest = std::numeric_limits<double>::infinity();    ///< Of I and Q.
  double highest = -std::numeric_limits<double>::infinity();  ///< Of I and Q.
  double sum_of_squares = 0.0;                                ///< Of the magnitudes.
  double largest_magnitude = 0.0;
  std::size_t largest_row = 0;
  std::size_t largest_column = 0;
  std::uint64_t samples = 0;
  std::uint64_t zeros = 0;
  std::uint64_t not_finite = 0;  ///< Samples with a NaN or an infinity; counted nowhere else.

  /// Takes in whole rows; `first_row` is the number of the first.
  void add(std::span<const std::complex<double>> values, std::size_t first_row, std::size_t columns);
  /// Root mean square of the magnitude; 0 without samples.
  [[nodiscard]] double rms() const;

 private:
  double largest_power_ = 0.0;
};

}  // namespace sarsim::signal
