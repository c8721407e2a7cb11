#include "picture/echo/echo_picture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

// Arc tangent for 0 <= x <= 1 to 2e-8 (Abramowitz and Stegun 4.4.49).
double short_arc_tangent(double x) {
  const double y = x * x;
  return x * (1.0 +
              y * (-0.3333314528 +
                   y * (0.1999355085 +
                        y * (-0.1420889944 +
                             y * (0.1065626393 + y * (-0.0752896400 +
                                                      y * (0.0429096138 + y * (-0.0161657367 + y * 0.0028662257))))))));
}

double quick_phase_deg(std::complex<double> v) {
  const double a = std::abs(v.real());
  const double b = std::abs(v.imag());
  if (!(std::max(a, b) > 0.0)) return 0.0;
  double angle = a >= b ? short_arc_tangent(b / a) : 0.5 * core::pi - short_arc_tangent(a / b);
  if (v.real() < 0.0) angle = core::pi - angle;
  return (v.imag() < 0.0 ? -angle : angle) * core::deg_per_rad;
}

// Finds levels of samples; for decibels by comparing powers, so that no logarithm is taken for each.
class Leveller {
 public:
  explicit Leveller(const EchoColours& colours)
      : colours_(colours),
        levels_(static_cast<double>(colours.level.size())),
        low_(colours.limits.low),
        per_unit_(levels_ / (colours.limits.high - colours.limits.low)) {
    if (colours.quantity != DisplayQuantity::decibels) return;
    const double reference = colours.reference_v * colours.reference_v;
    from_power_.resize(colours.level.size());
    for (std::size_t i = 0; i < from_power_.size(); ++i)
      from_power_[i] = reference * std::pow(10.0, 0.1 * (low_ + static_cast<double>(i) / per_unit_));
    per_octave_ = 10.0 * std::log10(2.0) * per_unit_;
    first_octave_ = std::log2(from_power_[0]);
  }

  // Calls `take` with the level of each sample in turn; the quantity is decided once.
  template <class Take>
  void for_each(std::span<const std::complex<double>> samples, const Take& take) const {
    switch (colours_.quantity) {
      case DisplayQuantity::real:
        for (const std::complex<double>& v : samples) take(level_of_value(v.real()));
        return;
      case DisplayQuantity::imaginary:
        for (const std::complex<double>& v : samples) take(level_of_value(v.imag()));
        return;
      case DisplayQuantity::magnitude:
        for (const std::complex<double>& v : samples) take(level_of_value(std::sqrt(std::norm(v))));
        return;
      case DisplayQuantity::phase:
        for (const std::complex<double>& v : samples)
          take(colour_index(quick_phase_deg(v), colours_.limits, colours_.level.size(), true));
        return;
      case DisplayQuantity::decibels:
        for (const std::complex<double>& v : samples) take(level_of_power(std::norm(v)));
        return;
    }
  }

 private:
  [[nodiscard]] std::size_t level_of_value(double value) const {
    const double level = (value - low_) * per_unit_;
    if (!(level > 0.0)) return 0;
    return static_cast<std::size_t>(std::min(level, levels_ - 1.0));
  }

  [[nodiscard]] std::size_t level_of_power(double power) const {
    if (!(power >= from_power_[0])) return 0;
    const std::size_t last = from_power_.size() - 1;
    if (power >= from_power_[last]) return last;
    // Exponent and mantissa are a logarithm to a tenth of an octave; the neighbours decide.
    const auto bits = std::bit_cast<std::uint64_t>(power);
    const double octave = static_cast<double>(bits) * 0x1p-52 - 1023.0;
    const double guess = std::clamp((octave - first_octave_) * per_octave_, 0.0, static_cast<double>(last));
    auto level = static_cast<std::size_t>(guess);
    while (power < from_power_[level]) --level;
    while (power >= from_power_[level + 1]) ++level;
    return level;
  }

  const EchoColours& colours_;
  double levels_;
  double low_;
  double per_unit_;                 // levels
  std::vector<double> from_power_;  // lowest power of each level
  double per_octave_ = 0.0;         // levels
  double first_octave_ = 0.0;
};

// Row of the matrix for each row of pixels; rows() where there is none.
std::vector<std::size_t> rows_of_pixels(const EchoMatrix& matrix, RowPlacing placing) {
  const std::size_t height = matrix.size().height_px;
  const std::vector<std::size_t> nearest = matrix.nearest_ready();
  std::vector<std::size_t> rows(height, matrix.rows());
  if (nearest.empty()) return rows;
  if (placing == RowPlacing::own_row && matrix.rows() < height) {
    const EchoView view = view_of(matrix.window());
    for (std::size_t r = 0; r < matrix.rows(); ++r) {
      const double y =
          std::clamp(y_of_time(view, matrix.size(), matrix.time_s(r)), 0.0, static_cast<double>(height - 1));
      rows[static_cast<std::size_t>(std::lround(y))] = nearest[r];
    }
    return rows;
  }
  for (std::size_t y = 0; y < height; ++y) rows[y] = nearest[matrix.places().row_of_pixel[y]];
  return rows;
}

PlotAxis axis_of(const std::string& what, const Ticks& ticks) {
  PlotAxis axis;
  axis.title = fmt::format("{} ({})", what, ticks.unit);
  return axis;
}

}  // namespace

EchoColours colours_for(const EchoMatrix& matrix, const EchoWindow& how) {
  EchoColours colours;
  colours.quantity = how.quantity;
  std::vector<std::size_t> ready;
  for (std::size_t r = 0; r < matrix.rows(); ++r)
    if (matrix.ready(r)) ready.push_back(r);
  for (const std::size_t r : ready) colours.statistics = together(colours.statistics, matrix.row_statistics(r));
  if (how.limits.kind == LimitRule::Kind::automatic && how.limits.percentile < 100.0)
    colours.statistics.percentile_v = magnitude_percentile(
        ready.size(), [&](std::size_t i) { return matrix.row(ready[i]); }, how.limits.percentile);
  colours.reference_v = reference_v(how.decibels, colours.statistics);
  colours.limits = colour_limits(how.quantity, how.limits, how.decibels, colours.statistics);
  for (const raster::Rgb c : colour_table(how.map, how.sliders, how.inverted)) colours.level.push_back(pixel_of(c));
  return colours;
}

std::size_t level_of(const EchoColours& colours, std::complex<double> sample) {
  std::size_t found = 0;
  Leveller(colours).for_each({&sample, 1}, [&](std::size_t level) { found = level; });
  return found;
}

void paint(const EchoMatrix& matrix, const EchoColours& colours, RowPlacing placing, unsigned threads,
           EchoImage& image) {
  constexpr std::size_t rows_at_once = 32;
  const auto [width, height] = matrix.size();
  image.width_px = width;
  image.height_px = height;
  image.pixel.resize(width * height);
  const std::vector<std::size_t> rows = rows_of_pixels(matrix, placing);
  const std::vector<std::size_t>& columns = matrix.places().column_of_pixel;
  const Leveller leveller(colours);
  core::parallel_ranges(
      height, rows_at_once, {core::thread_count(threads), nullptr}, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> painted(matrix.columns());
        std::size_t painted_row = matrix.rows();
        for (std::size_t y = begin; y < end; ++y) {
          const auto out = std::span(image.pixel).subspan(y * width, width);
          if (rows[y] == matrix.rows()) {
            std::ranges::fill(out, 0U);
            continue;
          }
          if (rows[y] != painted_row) {
            painted_row = rows[y];
            auto next = painted.begin();
            leveller.for_each(matrix.row(painted_row), [&](std::size_t level) { *next++ = colours.level[level]; });
          }
          for (std::size_t x = 0; x < width; ++x) out[x] = painted[columns[x]];
        }
      });
}

DrawAs drawn_as(const EchoWindow& how, const EchoMatrix& matrix) {
  constexpr std::size_t apart_px = 20;
  if (how.draw_as != DrawAs::automatic) return how.draw_as;
  return matrix.size().height_px >= apart_px * matrix.plan().acquisition.timing.rows ? DrawAs::curves_per_pulse
                                                                                     : DrawAs::pixels;
}

ColourBar colour_bar(const EchoColours& colours, std::size_t height_px, double tick_spacing_px) {
  ColourBar bar;
  bar.pixel.resize(height_px);
  const std::size_t levels = colours.level.size();
  for (std::size_t y = 0; y < height_px; ++y) bar.pixel[y] = colours.level[(height_px - 1 - y) * levels / height_px];
  bar.ticks = axis_ticks(colours.limits.low, colours.limits.high, static_cast<double>(height_px), tick_spacing_px,
                         std::string(unit_of(colours.quantity)));
  return bar;
}

PlotAxes plot_axes(const EchoView& view, const PlotSize& size, double light_speed_mps, double spacing_px) {
  const auto width = static_cast<double>(size.width_px);
  const Ticks range = axis_ticks(view.range_start_m, view.range_end_m, width, spacing_px, "m");
  const Ticks delay = axis_ticks(radar::delay_of(view.range_start_m, light_speed_mps),
                                 radar::delay_of(view.range_end_m, light_speed_mps), width, spacing_px, "s");
  const Ticks time =
      axis_ticks(view.time_start_s, view.time_end_s, static_cast<double>(size.height_px), spacing_px, "s");
  PlotAxes axes{axis_of("Slant range", range), axis_of("Delay", delay), axis_of("Azimuth", time)};
  for (const Tick& t : range.ticks) axes.range.marks.push_back({x_of_range(view, size, t.value), t.label});
  for (const Tick& t : delay.ticks)
    axes.delay.marks.push_back({x_of_range(view, size, radar::range_of(t.value, light_speed_mps)), t.label});
  for (const Tick& t : time.ticks) axes.time.marks.push_back({y_of_time(view, size, t.value), t.label});
  return axes;
}

std::string highest_magnitude_text(const SampleStatistics& statistics) {
  if (statistics.count == 0) return "Highest magnitude: unknown";
  return "Highest magnitude: " + core::with_prefix(statistics.largest_v, "V");
}

}  // namespace sarsim::picture
