#include "signal/stepped/stepped_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "core/report/expect.hpp"
#include "signal/measure/image_quality.hpp"

namespace sarsim::signal {

namespace {

// The strongest of a target tell where it lies; the many weak ones are not needed.
constexpr std::size_t max_tried = 12;
constexpr std::size_t max_weighed = 64;
constexpr double min_peak_share = 0.1;  // Of the strongest peak's amplitude.

ImagePlace operator+(const ImagePlace& a, const ImagePlace& b) {
  return {a.azimuth_m + b.azimuth_m, a.range_m + b.range_m};
}

ImagePlace operator-(const ImagePlace& a, const ImagePlace& b) {
  return {a.azimuth_m - b.azimuth_m, a.range_m - b.range_m};
}

// Magnitudes of an image, 0 outside.
class Magnitudes {
 public:
  Magnitudes(const FocusedImage& image, const ImagePlace& cell)
      : image_(image),
        rows_(static_cast<std::ptrdiff_t>(image.azimuth.count)),
        columns_(static_cast<std::ptrdiff_t>(image.range.count)),
        row_reach_(reach(cell.azimuth_m, image.azimuth)),
        column_reach_(reach(cell.range_m, image.range)) {}

  [[nodiscard]] double at(std::ptrdiff_t row, std::ptrdiff_t column) const {
    if (row < 0 || column < 0 || row >= rows_ || column >= columns_) return 0.0;
    return std::abs(image_.values[static_cast<std::size_t>(row * columns_ + column)]);
  }

  // The largest at a place and half a cell beside it.
  [[nodiscard]] double near(const ImagePlace& place) const {
    const double row = std::round(image_.azimuth.index_of(place.azimuth_m));
    const double column = std::round(image_.range.index_of(place.range_m));
    // Places far outside do not become indices.
    const auto outside = [](double index, std::ptrdiff_t count, std::ptrdiff_t reach) {
      return !(index >= -static_cast<double>(reach) && index < static_cast<double>(count + reach));
    };
    if (outside(row, rows_, row_reach_) || outside(column, columns_, column_reach_)) return 0.0;
    double most = 0.0;
    for (const std::ptrdiff_t up : {-row_reach_, std::ptrdiff_t{0}, row_reach_})
      for (const std::ptrdiff_t right : {-column_reach_, std::ptrdiff_t{0}, column_reach_})
        most = std::max(most, at(static_cast<std::ptrdiff_t>(row) + up, static_cast<std::ptrdiff_t>(column) + right));
    return most;
  }

  // Places of the strongest peaks, strongest first, those beside a stronger one left out.
  [[nodiscard]] std::vector<ImagePlace> peaks(const ImagePlace& cell) const {
    std::vector<ImagePlace> places;
    for (const std::size_t index : tops()) {
      if (places.size() == max_tried) break;
      const ImagePlace place{image_.azimuth.at(static_cast<double>(index / image_.range.count)),
                             image_.range.at(static_cast<double>(index % image_.range.count))};
      const bool beside = std::ranges::any_of(places, [&](const ImagePlace& other) {
        const ImagePlace apart = place - other;
        return std::abs(apart.azimuth_m) < cell.azimuth_m && std::abs(apart.range_m) < cell.range_m;
      });
      if (!beside) places.push_back(place);
    }
    return places;
  }

 private:
  static std::ptrdiff_t reach(double cell_m, const ImageAxis& axis) {
    const double pixels = std::round(0.5 * cell_m / axis.step_m);
    return pixels >= 1.0 && pixels < static_cast<double>(axis.count) ? static_cast<std::ptrdiff_t>(pixels) : 1;
  }

  [[nodiscard]] bool tops_its_neighbours(std::ptrdiff_t row, std::ptrdiff_t column) const {
    const double here = at(row, column);
    for (std::ptrdiff_t r = row - 1; r <= row + 1; ++r)
      for (std::ptrdiff_t c = column - 1; c <= column + 1; ++c)
        if (at(r, c) > here) return false;
    return true;
  }

  // Indices of what no neighbour exceeds, strongest first.
  [[nodiscard]] std::vector<std::size_t> tops() const {
    double largest = 0.0;
    for (const auto& value : image_.values) largest = std::max(largest, static_cast<double>(std::norm(value)));
    const double least = min_peak_share * std::sqrt(largest);
    std::vector<std::size_t> found;
    if (!(largest > 0.0)) return found;
    for (std::ptrdiff_t row = 0; row < rows_; ++row)
      for (std::ptrdiff_t column = 0; column < columns_; ++column)
        if (at(row, column) >= least && tops_its_neighbours(row, column))
          found.push_back(static_cast<std::size_t>(row * columns_ + column));
    std::ranges::stable_sort(
        found, [&](std::size_t a, std::size_t b) { return std::norm(image_.values[a]) > std::norm(image_.values[b]); });
    return found;
  }

  const FocusedImage& image_;
  std::ptrdiff_t rows_;
  std::ptrdiff_t columns_;
  std::ptrdiff_t row_reach_;
  std::ptrdiff_t column_reach_;
};

std::vector<OverlayPoint> strongest_of(std::span<const OverlayPoint> points) {
  std::vector<OverlayPoint> strongest;
  for (const OverlayPoint& point : points)
    if (point.amplitude > 0.0) strongest.push_back(point);
  std::ranges::stable_sort(strongest, [](const auto& a, const auto& b) { return a.amplitude > b.amplitude; });
  strongest.resize(std::min(strongest.size(), max_weighed));
  return strongest;
}

double unexplained(const Magnitudes& magnitudes, std::span<const OverlayPoint> points, const ImagePlace& shift) {
  double sum = 0.0;
  for (const OverlayPoint& point : points)
    sum += std::min(std::abs(magnitudes.near(point.place + shift) - point.amplitude), point.amplitude);
  return sum;
}

// From samples to the peak of the strongest point that is found with half to one and a half of its amplitude.
ImagePlace refined(const FocusedImage& image, std::span<const OverlayPoint> points, const ImagePlace& shift,
                   const ImagePlace& cell) {
  const ImageReader reader = reader_of(image);
  for (const OverlayPoint& point : points.first(std::min(points.size(), max_tried))) {
    const ImagePlace expected = point.place + shift;
    const auto peak = measure_point(image, reader, expected, std::max(cell.azimuth_m, cell.range_m));
    if (peak && std::abs(peak->amplitude - point.amplitude) <= 0.5 * point.amplitude)
      return shift + (peak->place - expected);
  }
  return shift;
}

}  // namespace

std::optional<ImagePlace> shift_upon_image(const FocusedImage& image, std::span<const OverlayPoint> points,
                                           const ImagePlace& cell) {
  CORE_EXPECT(image.values.size() == image.azimuth.count * image.range.count);
  const Magnitudes magnitudes(image, cell);
  const std::vector<OverlayPoint> strongest = strongest_of(points);
  const std::vector<ImagePlace> peaks = magnitudes.peaks(cell);
  if (strongest.empty() || peaks.empty()) return std::nullopt;
  ImagePlace best = peaks.front() - strongest.front().place;
  double least = unexplained(magnitudes, strongest, best);
  for (std::size_t i = 0; i < std::min(strongest.size(), max_tried); ++i)
    for (const ImagePlace& peak : peaks) {
      const ImagePlace shift = peak - strongest[i].place;
      const double left = unexplained(magnitudes, strongest, shift);
      if (left >= least) continue;
      least = left;
      best = shift;
    }
  return refined(image, strongest, best, cell);
}

}  // namespace sarsim::signal
