#include "picture/figure/figure_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "picture/colour/display_quantity.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::picture {

void fit(FigureAxis& axis, const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!std::isfinite(low)) low = high = 0.0;
  const double margin = low < high ? 0.05 * (high - low) : 1.0;
  axis.first = low - margin;
  axis.last = high + margin;
}

FigureAxis axis_along(std::string label, std::string unit, const std::vector<double>& values) {
  FigureAxis axis{std::move(label), std::move(unit), 0.0, 1.0, {}};
  if (values.empty()) return axis;
  std::tie(axis.first, axis.last) = std::pair(std::ranges::min(values), std::ranges::max(values));
  if (axis.first == axis.last) fit(axis, values);
  return axis;
}

void break_where_it_turns_back(FigureCurve& curve) {
  FigureCurve whole = std::move(curve);
  curve = {whole.name, whole.role, whole.bars, {}, {}};
  for (std::size_t i = 0; i < whole.x.size(); ++i) {
    if (i > 0 && whole.x[i] < whole.x[i - 1]) {
      curve.x.push_back(whole.x[i]);
      curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    curve.x.push_back(whole.x[i]);
    curve.y.push_back(whole.y[i]);
  }
}

FigurePanel curve_panel(std::string title, FigureAxis across, FigureAxis up, std::vector<double> x,
                        std::vector<double> y) {
  FigurePanel panel;
  panel.title = std::move(title);
  panel.x = std::move(across);
  fit(up, y);
  panel.y = std::move(up);
  panel.curves.push_back({"", Role::curve, false, std::move(x), std::move(y)});
  return panel;
}

std::vector<double> decibels_of(std::vector<double> values, double factor, double depth_db) {
  double largest = -std::numeric_limits<double>::infinity();
  for (double& value : values) {
    value = factor * std::log10(value);
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  if (!std::isfinite(largest)) largest = lowest_db;
  for (double& value : values) value = std::isnan(value) ? value : std::max(value, largest - depth_db);
  return values;
}

namespace {

// A place to a ten-thousandth of what is seen, in the unit of the axis.
std::string place_text(const FigureAxis& axis, double place) {
  constexpr double any_length_px = 500.0;
  constexpr double any_spacing_px = 50.0;
  const Ticks ticks = axis_ticks(axis.first, axis.last, any_length_px, any_spacing_px, axis.unit);
  const double span = std::abs(axis.last - axis.first) / ticks.scale;
  const int digits = span > 0.0 ? std::clamp(static_cast<int>(-std::floor(std::log10(1e-4 * span))), 0, 9) : 6;
  const std::string number = fmt::format("{:.{}f}", place / ticks.scale, digits);
  return ticks.unit.empty() ? number : number + " " + ticks.unit;
}

// Whether words at a place would stand on those of another mark.
bool covered(const FigurePanel& panel, double x, double y) {
  const double width = 0.15 * std::abs(panel.x.last - panel.x.first);
  const double height = 0.06 * std::abs(panel.y.last - panel.y.first);
  return std::ranges::any_of(panel.marks, [&](const FigureMark& mark) {
    return !mark.text.empty() && std::abs(mark.x - x) < width && std::abs(mark.y - y) < height;
  });
}

}  // namespace

void mark_peaks(FigurePanel& panel, std::size_t count) {
  if (panel.curves.empty()) return;
  const std::vector<double>& x = panel.curves[0].x;
  const std::vector<double>& y = panel.curves[0].y;
  std::vector<std::size_t> maxima;
  for (std::size_t i = 1; i + 1 < y.size(); ++i)
    if (y[i] > y[i - 1] && y[i] >= y[i + 1]) maxima.push_back(i);
  std::ranges::stable_sort(maxima, std::ranges::greater{}, [&](std::size_t i) { return y[i]; });
  if (maxima.size() > count) maxima.resize(count);
  // Room for the words above the highest.
  if (!maxima.empty()) panel.y.last += 0.1 * (panel.y.last - panel.y.first);
  for (const std::size_t i : maxima) {
    const double bend = y[i - 1] - 2.0 * y[i] + y[i + 1];
    const double shift = bend < 0.0 ? 0.5 * (y[i - 1] - y[i + 1]) / bend : 0.0;
    const double place = x[i] + shift * (shift < 0.0 ? x[i] - x[i - 1] : x[i + 1] - x[i]);
    panel.marks.push_back({place, y[i], covered(panel, place, y[i]) ? "" : place_text(panel.x, place)});
  }
}

}  // namespace sarsim::picture
