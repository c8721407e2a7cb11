#include "signal/search/detection_peaks.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/sinc.hpp"
#include "core/maths/window.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

// Where a function with one maximum between `low` and `high` has it, by golden section.
template <class Function>
double maximum_place(const Function& function, double low, double high) {
  constexpr int steps = 32;  // 0.618^32 = 2e-7 of the interval.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double at_a = function(a);
  double at_b = function(b);
  for (int i = 0; i < steps; ++i) {
    if (at_a < at_b) {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = function(b);
    } else {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = function(a);
    }
  }
  return 0.5 * (low + high);
}

// Whether cell `at` yields to a neighbour: to a larger one, and of equal ones to the earlier.
bool yields(std::span<const float> power, std::size_t at, std::size_t neighbour) {
  if (power[neighbour] != power[at]) return power[neighbour] > power[at];
  return neighbour < at;
}

bool is_peak(std::span<const float> power, std::size_t columns, const CfarDetection& cell) {
  const std::size_t rows = power.size() / columns;
  const std::size_t at = cell.row * columns + cell.column;
  const std::size_t first = cell.column > 0 ? cell.column - 1 : 0;
  const std::size_t last = std::min(cell.column + 1, columns - 1);
  for (const std::size_t row : {(cell.row + rows - 1) % rows, cell.row, (cell.row + 1) % rows})
    for (std::size_t column = first; column <= last; ++column) {
      const std::size_t neighbour = row * columns + column;
      if (neighbour != at && yields(power, at, neighbour)) return false;
    }
  return true;
}

// The value of a line at a place between its samples.
std::complex<double> interpolated(std::span<const std::complex<float>> line, double place) {
  constexpr double half = 8.0;
  constexpr double beta = 6.0;
  const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(place - half)));
  const auto last =
      static_cast<std::size_t>(std::min(std::floor(place + half), static_cast<double>(line.size()) - 1.0));
  std::complex<double> sum;
  for (std::size_t n = first; n <= last; ++n) {
    const double d = place - static_cast<double>(n);
    sum += core::sinc(d) * core::kaiser_window(d / half, beta) * std::complex<double>(line[n]);
  }
  return sum;
}

}  // namespace

std::vector<CfarDetection> peaks_of(std::span<const CfarDetection> found, std::span<const float> power,
                                    std::size_t columns) {
  CORE_EXPECT(columns > 0);
  CORE_EXPECT(power.size() % columns == 0);
  std::vector<CfarDetection> peaks;
  for (const CfarDetection& cell : found)
    if (is_peak(power, columns, cell)) peaks.push_back(cell);
  return peaks;
}

double peak_frequency(std::span<const std::complex<double>> values, double near, double reach) {
  CORE_EXPECT(!values.empty());
  CORE_EXPECT(reach >= 0.0);
  const auto power = [values](double frequency) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * core::pi * frequency);
    std::complex<double> sum;
    // Horner's rule: the last value first.
    for (std::size_t p = values.size(); p-- > 0;) sum = sum * turn + values[p];
    return std::norm(sum);
  };
  return maximum_place(power, near - reach, near + reach);
}

double peak_place(std::span<const std::complex<float>> line, std::size_t near) {
  CORE_EXPECT(near < line.size());
  const auto middle = static_cast<double>(near);
  constexpr double reach = 0.6;  // Farther away lies the next sidelobe.
  const double low = std::max(0.0, middle - reach);
  const double high = std::min(middle + reach, static_cast<double>(line.size()) - 1.0);
  return maximum_place([line](double place) { return std::norm(interpolated(line, place)); }, low, high);
}

}  // namespace sarsim::signal
