#include "scene/check/path_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sarsim::scene {

namespace {

using core::Knot;

constexpr std::size_t max_segments = 1000;
constexpr std::size_t polynomial_points = 6;

// The polynomial through the points next to x (Neville's scheme), minus the first ordinate to spare digits.
double polynomial_value(const std::vector<Knot>& knots, double x) {
  const std::size_t count = std::min(polynomial_points, knots.size());
  const auto after = std::ranges::upper_bound(knots, x, {}, &Knot::x) - knots.begin();
  const auto latest = static_cast<std::ptrdiff_t>(knots.size() - count);
  const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(after - static_cast<std::ptrdiff_t>(count / 2), 0, latest);
  const Knot* const at = knots.data() + first;
  std::array<double, polynomial_points> value{};
  for (std::size_t i = 0; i < count; ++i) value[i] = at[i].y - at[0].y;
  for (std::size_t degree = 1; degree < count; ++degree)
    for (std::size_t i = 0; i + degree < count; ++i)
      value[i] = ((x - at[i + degree].x) * value[i] + (at[i].x - x) * value[i + 1]) / (at[i].x - at[i + degree].x);
  return at[0].y + value[0];
}

// No more than a constant or a straight line, whatever the rule for the ends.
bool cannot_err(const core::SampledFunction& part) {
  return part.knots.size() < 2 || (part.knots.size() == 2 && part.method != core::Interpolation::low_pass);
}

// Four places in each segment that overlaps the time, in at most `max_segments` evenly chosen ones.
void add_places(const std::vector<Knot>& knots, double from_s, double to_s, std::vector<double>& places_s) {
  const auto first = std::ranges::lower_bound(knots, from_s, {}, &Knot::x) - knots.begin();
  const auto last = std::ranges::upper_bound(knots, to_s, {}, &Knot::x) - knots.begin();
  const std::size_t begin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, first));
  const std::size_t end = std::min(knots.size(), static_cast<std::size_t>(last) + 1);
  if (begin >= end) return;
  const std::size_t step = 1 + (end - begin - 1) / max_segments;
  const auto add = [&](std::size_t i) {
    for (const double share : {0.2, 0.4, 0.6, 0.8}) {
      const double place_s = knots[i - 1].x + share * (knots[i].x - knots[i - 1].x);
      if (place_s >= from_s && place_s <= to_s) places_s.push_back(place_s);
    }
  };
  for (std::size_t i = begin; i < end; i += step) add(i);
  if (step > 1) add(end - 1);
  for (const double edge_s : {from_s, to_s})
    if (edge_s >= knots.front().x && edge_s <= knots.back().x) places_s.push_back(edge_s);
}

}  // namespace

std::optional<PathError> path_error(const std::array<core::SampledFunction, 3>& path,
                                    const core::InterpolationRules& rules, double from_s, double to_s) {
  std::vector<double> places_s;
  for (const core::SampledFunction& part : path)
    if (!cannot_err(part)) add_places(part.knots, from_s, to_s, places_s);
  if (places_s.empty()) return std::nullopt;
  std::vector<double> squared_m2(places_s.size(), 0.0);
  for (const core::SampledFunction& part : path) {
    if (cannot_err(part)) continue;
    const core::Interpolator function(part, rules);
    for (std::size_t i = 0; i < places_s.size(); ++i) {
      const double x = places_s[i];
      if (x < part.knots.front().x || x > part.knots.back().x) continue;
      const double off_m = function.value(x) - polynomial_value(part.knots, x);
      squared_m2[i] += off_m * off_m;
    }
  }
  const auto worst = std::ranges::max_element(squared_m2);
  return PathError{std::sqrt(*worst), places_s[static_cast<std::size_t>(worst - squared_m2.begin())]};
}

}  // namespace sarsim::scene
