#include "picture/echo/echo_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "picture/echo/echo_curves.hpp"
#include "picture/echo/echo_readout.hpp"
#include "picture/figure/figure_axes.hpp"
#include "radar/path/path.hpp"

namespace sarsim::picture {

namespace {

constexpr int title_digits = 9;

// What is not drawn: neither of the ends that colours have.
constexpr raster::Rgb nothing{128, 128, 128};

FigureAxis range_axis(const EchoMatrix& matrix) {
  const EchoView view = view_of(matrix.window());
  const double delay_per_range = radar::delay_of(1.0, matrix.plan().acquisition.scene->conventions.light_speed_mps);
  return {"Slant range", "m", range_at(view, matrix.size(), -0.5),
          range_at(view, matrix.size(), static_cast<double>(matrix.size().width_px) - 0.5),
          FigureAxis::Twin{"Delay (there and back)", "s", delay_per_range}};
}

FigureAxis time_axis(const EchoMatrix& matrix) {
  const EchoView view = view_of(matrix.window());
  return {"Azimuth time", "s", time_at(view, matrix.size(), static_cast<double>(matrix.size().height_px) - 0.5),
          time_at(view, matrix.size(), -0.5), std::nullopt};
}

raster::Rgb rgb(std::uint32_t pixel) {
  if (pixel >> 24U == 0) return nothing;
  return {static_cast<std::uint8_t>(pixel >> 16U), static_cast<std::uint8_t>(pixel >> 8U),
          static_cast<std::uint8_t>(pixel)};
}

void add_pixels(FigurePanel& panel, const EchoMatrix& matrix, const EchoColours& colours, const EchoWindow& how) {
  EchoImage painted;
  paint(matrix, colours, how.placing, 0, painted);
  FigureImage& image = panel.image.emplace();
  image.width = painted.width_px;
  image.height = painted.height_px;
  image.x_first = panel.x.first;
  image.x_last = panel.x.last;
  image.y_first = panel.y.last;  // rows from the top
  image.y_last = panel.y.first;
  image.cells.reserve(painted.pixel.size());
  for (const std::uint32_t pixel : painted.pixel) image.cells.push_back(rgb(pixel));
  FigureColourBar& bar = panel.colour_bar.emplace();
  bar.label = axis_title_of(colours.quantity);
  bar.unit = unit_of(colours.quantity);
  bar.first = colours.limits.low;
  bar.last = colours.limits.high;
  bar.kind = kind_for(colours.quantity);
  for (const std::uint32_t level : colours.level) bar.colours.push_back(rgb(level));
}

void add_curves(FigurePanel& panel, const EchoMatrix& matrix, const EchoCurves& drawn, bool across) {
  const EchoView view = view_of(matrix.window());
  for (const EchoCurve& curve : drawn.curves) {
    FigureCurve& line = panel.curves.emplace_back();
    for (const EchoCurve::Point& point : curve.points) {
      line.x.push_back(range_at(view, matrix.size(), point.x_px));
      line.y.push_back(time_at(view, matrix.size(), point.y_px));
    }
    if (across) break_where_it_turns_back(line);
  }
}

FigureAxis value_axis(const EchoColours& colours, const std::vector<double>& values) {
  FigureAxis axis{std::string(axis_title_of(colours.quantity)), std::string(unit_of(colours.quantity)), 0.0, 0.0, {}};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (colours.quantity == DisplayQuantity::decibels) low = std::max(low, colours.limits.low);
  if (colours.quantity == DisplayQuantity::magnitude) low = std::min(low, 0.0);
  if (!(low < high))
    std::tie(low, high) = std::pair(std::isfinite(low) ? low - 1.0 : -1.0, std::isfinite(low) ? low + 1.0 : 1.0);
  const double margin = 0.05 * (high - low);
  axis.first = low - margin;
  axis.last = high + margin;
  return axis;
}

FigurePanel cut_panel(std::string title, FigureAxis across, const EchoColours& colours, SideCut cut) {
  FigurePanel panel;
  panel.title = std::move(title);
  panel.x = std::move(across);
  panel.y = value_axis(colours, cut.value);
  panel.curves.push_back({"", Role::curve, false, std::move(cut.position), std::move(cut.value)});
  return panel;
}

}  // namespace

Figure echo_figure(const EchoMatrix& matrix, const EchoWindow& how) {
  Figure figure;
  FigurePanel& panel = figure.panels.emplace_back();
  panel.x = range_axis(matrix);
  panel.y = time_axis(matrix);
  const EchoColours colours = colours_for(matrix, how);
  figure.note = highest_magnitude_text(colours.statistics);
  switch (drawn_as(how, matrix)) {
    case DrawAs::curves_per_pulse: add_curves(panel, matrix, curves_per_pulse(matrix, colours), true); break;
    case DrawAs::curves_per_range: add_curves(panel, matrix, curves_per_range(matrix, colours), false); break;
    default: add_pixels(panel, matrix, colours, how);
  }
  return figure;
}

Figure cut_figure(const EchoMatrix& matrix, const EchoColours& colours, std::size_t row, std::size_t column) {
  Figure figure;
  FigureAxis across = range_axis(matrix);
  across.twin.reset();
  FigureAxis along = time_axis(matrix);
  figure.panels.push_back(
      cut_panel("Pulse at " + core::format_number(core::tidy(matrix.time_s(row), title_digits)) + " s",
                std::move(across), colours, row_cut(matrix, colours, row)));
  figure.panels.push_back(
      cut_panel("Range " + core::format_number(core::tidy(matrix.range_m(column), title_digits)) + " m",
                std::move(along), colours, column_cut(matrix, colours, column)));
  return figure;
}

std::string pulse_table(const EchoMatrix& matrix, std::size_t row, char separator) {
  std::string text = "slant range [m]";
  for (const char* name : {"I [V]", "Q [V]", "magnitude [V]", "phase [deg]"}) (text += separator) += name;
  text += '\n';
  const auto samples = matrix.row(row);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    text += core::format_number(matrix.range_m(k));
    const double values[] = {samples[k].real(), samples[k].imag(), std::abs(samples[k]),
                             std::arg(samples[k]) * 180.0 / std::numbers::pi};
    for (const double value : values) (text += separator) += core::format_number(value);
    text += '\n';
  }
  return text;
}

}  // namespace sarsim::picture
