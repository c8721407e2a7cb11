#include "radar/motion/gait_curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

// Points of one period, ascending, none twice.
std::vector<core::Knot> one_period(const std::vector<core::Knot>& points) {
  std::vector<core::Knot> knots;
  for (const core::Knot& point : points) {
    const double x = point.x - std::floor(point.x);
    const auto same = [x](const core::Knot& knot) { return std::abs(std::remainder(knot.x - x, 1.0)) < 1e-9; };
    if (std::ranges::none_of(knots, same)) knots.push_back({x, point.y});
  }
  std::ranges::sort(knots, {}, &core::Knot::x);
  return knots;
}

// The slope between two chords: 0 at an extreme, otherwise their weighted harmonic mean.
double slope_between(double width_a, double chord_a, double width_b, double chord_b) {
  if (chord_a * chord_b <= 0.0) return 0.0;
  const double weight_a = 2.0 * width_b + width_a;
  const double weight_b = width_b + 2.0 * width_a;
  return (weight_a + weight_b) / (weight_a / chord_a + weight_b / chord_b);
}

}  // namespace

GaitCurve::GaitCurve(const std::vector<core::Knot>& points) : knots_(one_period(points)) {
  CORE_EXPECT(!points.empty());
  const std::size_t count = knots_.size();
  knots_.push_back({knots_.front().x + 1.0, knots_.front().y});
  const auto width = [this](std::size_t i) { return knots_[i + 1].x - knots_[i].x; };
  const auto chord = [this, width](std::size_t i) { return (knots_[i + 1].y - knots_[i].y) / width(i); };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    slopes_.push_back(slope_between(width(before), chord(before), width(i), chord(i)));
  }
  slopes_.push_back(slopes_.front());
}

double GaitCurve::at(double x) const {
  const double first = knots_.front().x;
  const double place = first + (x - first) - std::floor(x - first);
  const auto next = std::ranges::upper_bound(knots_, place, {}, &core::Knot::x);
  const auto last = static_cast<std::ptrdiff_t>(knots_.size()) - 2;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next - knots_.begin() - 1, 0, last));
  const double width = knots_[i + 1].x - knots_[i].x;
  const double u = (place - knots_[i].x) / width;
  const double left = knots_[i].y, rise = knots_[i + 1].y - left;
  const double a = slopes_[i] * width, b = slopes_[i + 1] * width;
  return left + u * (a + u * (3.0 * rise - 2.0 * a - b + u * (a + b - 2.0 * rise)));
}

}  // namespace sarsim::radar
