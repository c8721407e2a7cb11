#include "signal/measure/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

constexpr std::size_t max_along = 65;

struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The samples of an axis within `half_m` of a place; empty if there are none.
Stretch stretch_of(const ImageAxis& axis, double place_m, double half_m) {
  const double middle = axis.index_of(place_m);
  const double half = std::abs(half_m / axis.step_m);
  const auto last = static_cast<double>(axis.count);
  const double begin = std::clamp(std::ceil(middle - half), 0.0, last);
  const double end = std::clamp(std::floor(middle + half) + 1.0, 0.0, last);
  if (!(begin < end)) return {};
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

std::size_t step_of(const Stretch& stretch) { return 1 + (stretch.end - stretch.begin - 1) / max_along; }

}  // namespace

double noise_power_near(const FocusedImage& image, const ImageReader& reader, const ImagePlace& place,
                        double half_azimuth_m, double half_range_m) {
  CORE_EXPECT(reader);
  CORE_EXPECT(half_azimuth_m > 0.0 && half_range_m > 0.0);
  const Stretch rows = stretch_of(image.azimuth, place.azimuth_m, half_azimuth_m);
  const Stretch columns = stretch_of(image.range, place.range_m, half_range_m);
  if (rows.begin == rows.end || columns.begin == columns.end) return 0.0;
  std::vector<std::complex<float>> row(columns.end - columns.begin);
  std::vector<double> powers;
  for (std::size_t r = rows.begin; r < rows.end; r += step_of(rows)) {
    reader(r, columns.begin, row);
    for (std::size_t c = 0; c < row.size(); c += step_of(columns)) {
      const double power = std::norm(std::complex<double>(row[c]));
      if (power > 0.0) powers.push_back(power);
    }
  }
  if (powers.empty()) return 0.0;
  const auto quartile = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 4);
  std::ranges::nth_element(powers, quartile);
  return *quartile / std::log(4.0 / 3.0);
}

double peak_false_alarm(double ratio, double azimuth_cells, double range_cells) {
  CORE_EXPECT(azimuth_cells >= 0.0 && range_cells >= 0.0);
  if (!(ratio > 0.5)) return 1.0;
  const double border = (azimuth_cells + range_cells) * std::sqrt(core::pi * ratio / 3.0);
  const double inside = azimuth_cells * range_cells * core::pi / 6.0 * (2.0 * ratio - 1.0);
  return std::min(1.0, std::exp(-ratio) * (1.0 + border + inside));
}

double peak_threshold(double false_alarm, double azimuth_cells, double range_cells) {
  CORE_EXPECT(false_alarm > 0.0 && false_alarm < 0.5);
  double low = 0.5;
  double high = 1000.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (peak_false_alarm(middle, azimuth_cells, range_cells) > false_alarm ? low : high) = middle;
  }
  return high;
}

}  // namespace sarsim::signal
