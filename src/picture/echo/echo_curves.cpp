#include "picture/echo/echo_curves.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::picture {

namespace {

constexpr double nearest_px = 20.0;

// Pixels per unit of value above `zero`.
struct Scale {
  double zero = 0.0;
  double px_per_unit = 0.0;

  [[nodiscard]] double px(double value) const { return std::isfinite(value) ? (value - zero) * px_per_unit : 0.0; }
};

Scale scale_for(const EchoColours& colours, double spacing_px) {
  constexpr double share = 0.75;
  constexpr double decibel_share = 0.9;
  if (colours.quantity == DisplayQuantity::decibels)
    return {colours.limits.low, decibel_share * spacing_px / (colours.limits.high - colours.limits.low)};
  const double largest = colours.quantity == DisplayQuantity::phase ? 180.0 : colours.statistics.largest_v;
  return {0.0, largest > 0.0 ? share * spacing_px / (2.0 * largest) : 0.0};
}

double shown_value(const EchoColours& colours, std::complex<double> sample) {
  const double value = value_of(colours.quantity, sample, colours.reference_v);
  return colours.quantity == DisplayQuantity::decibels ? std::max(value, colours.limits.low) : value;
}

double top_px(const EchoColours& colours, const Scale& scale) {
  if (colours.quantity == DisplayQuantity::decibels) return scale.px(colours.limits.high);
  return scale.px(colours.quantity == DisplayQuantity::phase ? 180.0 : colours.statistics.largest_v);
}

double pixels(std::size_t count) { return static_cast<double>(std::max<std::size_t>(count, 1)); }

// Every how many elements a curve is drawn, for elements that are so far apart.
std::size_t stride_for(double apart_px) {
  return apart_px >= nearest_px ? 1 : static_cast<std::size_t>(std::ceil(nearest_px / apart_px - 1e-9));
}

}  // namespace

EchoCurves curves_per_pulse(const EchoMatrix& matrix, const EchoColours& colours) {
  EchoCurves out;
  const EchoView view = view_of(matrix.window());
  const double apart = pixels(matrix.size().height_px) / static_cast<double>(matrix.rows());
  const std::size_t stride = stride_for(apart);
  out.spacing_px = apart * static_cast<double>(stride);
  const Scale scale = scale_for(colours, out.spacing_px);
  out.scale_px = top_px(colours, scale);
  for (std::size_t r = 0; r < matrix.rows(); r += stride) {
    if (!matrix.ready(r)) continue;
    const double base = y_of_time(view, matrix.size(), matrix.time_s(r));
    EchoCurve curve{r, {0.0, base}, {static_cast<double>(matrix.size().width_px), base}, {}};
    const auto samples = matrix.row(r);
    curve.points.reserve(samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k)
      curve.points.push_back(
          {x_of_range(view, matrix.size(), matrix.range_m(k)), base - scale.px(shown_value(colours, samples[k]))});
    out.curves.push_back(std::move(curve));
  }
  return out;
}

EchoCurves curves_per_range(const EchoMatrix& matrix, const EchoColours& colours) {
  EchoCurves out;
  const EchoView view = view_of(matrix.window());
  const double apart = pixels(matrix.size().width_px) / static_cast<double>(matrix.columns());
  const std::size_t stride = stride_for(apart);
  out.spacing_px = apart * static_cast<double>(stride);
  const Scale scale = scale_for(colours, out.spacing_px);
  out.scale_px = top_px(colours, scale);
  for (std::size_t k = 0; k < matrix.columns(); k += stride) {
    const double base = x_of_range(view, matrix.size(), matrix.range_m(k));
    EchoCurve curve{k, {base, static_cast<double>(matrix.size().height_px)}, {base, 0.0}, {}};
    for (std::size_t r = 0; r < matrix.rows(); ++r)
      if (matrix.ready(r))
        curve.points.push_back({base + scale.px(shown_value(colours, matrix.row(r)[k])),
                                y_of_time(view, matrix.size(), matrix.time_s(r))});
    out.curves.push_back(std::move(curve));
  }
  return out;
}

}  // namespace sarsim::picture
