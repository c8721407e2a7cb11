#include "workflow/verify/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace sarsim::workflow::verify {

namespace {

constexpr double width = 640.0;
constexpr double height = 360.0;
constexpr double left = 70.0;
constexpr double right = 20.0;
constexpr double top = 34.0;
constexpr double bottom = 48.0;

// Told apart with every kind of colour vision, and in print (Okabe and Ito 2008).
constexpr std::array<const char*, 6> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#555555"};

// One axis: from values to places between two pixels.
class Axis {
 public:
  Axis(bool logarithmic, double from_px, double to_px) : logarithmic_(logarithmic), from_px_(from_px), to_px_(to_px) {}

  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0.0); }
  void include(double value) {
    low_ = std::min(low_, scaled(value));
    high_ = std::max(high_, scaled(value));
  }
  // Leaves room for a chart of one value or of none.
  void finish() {
    if (!(low_ <= high_)) low_ = 0.0, high_ = 1.0;
    if (low_ == high_) low_ -= 0.5, high_ += 0.5;
  }
  [[nodiscard]] double place(double value) const {
    return from_px_ + (scaled(value) - low_) / (high_ - low_) * (to_px_ - from_px_);
  }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    const double step =
        logarithmic_ ? std::max(1.0, std::ceil((high_ - low_) / 7.0)) : round_step((high_ - low_) / 6.0);
    for (double v = std::ceil(low_ / step - 1e-9) * step; v <= high_ + 1e-9 * step; v += step)
      values.push_back(logarithmic_ ? std::pow(10.0, v) : v);
    return values;
  }

 private:
  [[nodiscard]] double scaled(double value) const { return logarithmic_ ? std::log10(value) : value; }
  // 1, 2 or 5 times a power of ten.
  static double round_step(double step) {
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0})
      if (factor * power >= step) return factor * power;
    return 10.0 * power;
  }

  bool logarithmic_;
  double from_px_;
  double to_px_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

std::string tick_text(double value) { return fmt::format("{:.6g}", std::abs(value) < 1e-15 ? 0.0 : value); }

std::string words(double x, double y, const char* anchor, const std::string& text, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     xml_text(text));
}

std::string axes_of(const Chart& chart, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double tick : x.ticks()) {
    const double place = x.place(tick);
    svg += fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\"/>\n", place, top,
                       height - bottom);
    svg += words(place, height - bottom + 16.0, "middle", tick_text(tick));
  }
  for (const double tick : y.ticks()) {
    const double place = y.place(tick);
    svg += fmt::format("<line class=\"grid\" x1=\"{1}\" y1=\"{0:.1f}\" x2=\"{2}\" y2=\"{0:.1f}\"/>\n", place, left,
                       width - right);
    svg += words(left - 6.0, place + 4.0, "end", tick_text(tick));
  }
  svg += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top,
                     width - left - right, height - top - bottom);
  svg += words(0.5 * (left + width - right), height - 10.0, "middle", chart.x_label);
  svg += words(0.0, 0.0, "middle", chart.y_label,
               fmt::format(" transform=\"translate(14 {}) rotate(-90)\"", 0.5 * (top + height - bottom)).c_str());
  return svg + words(0.5 * width, 20.0, "middle", chart.title, " class=\"title\"");
}

std::string curve_of(const Curve& curve, const Axis& x, const Axis& y, const char* colour) {
  std::string points;
  std::string dots;
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    if (!x.shows(curve.x[i]) || !y.shows(curve.y[i])) continue;
    const double px = x.place(curve.x[i]);
    const double py = y.place(curve.y[i]);
    points += fmt::format("{:.1f},{:.1f} ", px, py);
    dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", px, py, colour);
  }
  if (curve.dots) return dots;
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n", colour, points);
}

// Whether the names of the curves stand on the left: where fewer points are in the way.
bool legend_left(const Chart& chart, const Axis& x, const Axis& y) {
  const double lowest = top + 16.0 * static_cast<double>(chart.curves.size()) + 10.0;
  int balance = 0;
  for (const Curve& curve : chart.curves)
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (!x.shows(curve.x[i]) || !y.shows(curve.y[i]) || y.place(curve.y[i]) > lowest) continue;
      balance += x.place(curve.x[i]) > 0.5 * (left + width - right) ? 1 : -1;
    }
  return balance > 0;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  return result;
}

std::string svg_of(const Chart& chart) {
  Axis x(chart.log_x, left, width - right);
  Axis y(chart.log_y, height - bottom, top);
  for (const Curve& curve : chart.curves)
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (!x.shows(curve.x[i]) || !y.shows(curve.y[i])) continue;
      x.include(curve.x[i]);
      y.include(curve.y[i]);
    }
  x.finish();
  y.finish();
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", width, height, xml_text(chart.title));
  svg += axes_of(chart, x, y);
  const bool to_left = legend_left(chart, x, y);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const char* colour = colours[i % colours.size()];
    svg += curve_of(chart.curves[i], x, y, colour);
    const double line = top + 16.0 + 16.0 * static_cast<double>(i);
    svg += words(to_left ? left + 8.0 : width - right - 8.0, line, to_left ? "start" : "end", chart.curves[i].name,
                 fmt::format(" fill=\"{}\"", colour).c_str());
  }
  return svg + "</svg>\n";
}

}  // namespace sarsim::workflow::verify
