#include "core/maths/angle_function.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sarsim::core {

namespace {

constexpr double turn_deg = 360.0;
constexpr double rounding_deg = 1e-9;  // of angles that somebody typed or computed

double largest_spacing(const std::vector<Knot>& knots) {
  double largest = 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) largest = std::max(largest, knots[i].x - knots[i - 1].x);
  return largest;
}

// From the last point over half a turn to the first.
double gap_deg(const std::vector<Knot>& knots) { return turn_deg - (knots.back().x - knots.front().x); }

bool runs_across(const std::vector<Knot>& knots) {
  const double gap = gap_deg(knots);
  if (gap < -rounding_deg) return false;
  // Both ends are one angle: a step where they differ.
  if (gap <= rounding_deg) return knots.front().y == knots.back().y;
  return gap <= 2.0 * largest_spacing(knots) + rounding_deg;
}

// The points of a turn, repeated before and behind it. What a cubic spline does at an end falls to 0.27 from point to
// point, to 1e-14 over these; a low-pass value sums eleven points to either side. The first point of one turn more ends
// them, so that the grid of low-pass values is that of whole turns: 360 degrees over the number of points.
std::vector<Knot> repeated(std::vector<Knot> knots) {
  constexpr std::size_t enough = 25;
  if (gap_deg(knots) <= rounding_deg) knots.pop_back();
  const auto turns = static_cast<int>((enough + knots.size() - 1) / knots.size()) + 1;
  std::vector<Knot> all;
  for (int turn = -turns; turn < turns; ++turn)
    for (const Knot& knot : knots) all.push_back({knot.x + turn * turn_deg, knot.y});
  all.push_back({knots.front().x + turns * turn_deg, knots.front().y});
  return all;
}

}  // namespace

AngleFunction::AngleFunction(Interpolator of_magnitude) : function_(std::move(of_magnitude)) {
  if (function_.empty()) return;
  first_deg_ = function_.knots().front().x;
  last_deg_ = function_.knots().back().x;
}

AngleFunction::AngleFunction(const SampledFunction& function, InterpolationRules rules, AngleRule rule) {
  const std::vector<Knot>& knots = function.knots;
  if (!knots.empty()) {
    first_deg_ = knots.front().x;
    last_deg_ = knots.back().x;
  }
  if (rule != AngleRule::magnitude) {
    rules.beyond = Beyond::held;
    rules.low_pass = LowPassRule::first_knot;  // The other is anchored at 0 and decays to 0 dB.
  }
  even_ = rule == AngleRule::magnitude || knots.size() < 2 ||
          (first_deg_ >= 0.0 && last_deg_ <= 0.5 * turn_deg + rounding_deg);
  round_ = !even_ && rule == AngleRule::azimuth && runs_across(knots);
  function_ = Interpolator(round_ ? SampledFunction{function.method, repeated(knots)} : function, rules);
}

double AngleFunction::argument_deg(double angle_deg) const {
  if (even_) return std::abs(angle_deg);
  if (angle_deg >= first_deg_ - rounding_deg && angle_deg <= last_deg_ + rounding_deg) return angle_deg;
  return angle_deg - turn_deg * std::round((angle_deg - middle_deg()) / turn_deg);
}

bool AngleFunction::covers(double angle_deg) const {
  if (function_.knots().size() < 2 || round_) return true;
  const double argument = argument_deg(angle_deg);
  return argument >= first_deg_ - rounding_deg && argument <= last_deg_ + rounding_deg;
}

}  // namespace sarsim::core
