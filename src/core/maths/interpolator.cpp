#include "core/maths/interpolator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/maths/constants.hpp"

namespace sarsim::core {

namespace {

constexpr long half_terms = 10;      // a low-pass value sums grid points within this many steps
constexpr double taper_half = 11.0;  // where the Hann taper of the low-pass kernel reaches zero

// sin(pi z)/(pi z) and its first two derivatives; series near 0, where the quotients cancel.
Jet sinc_jet(double z) {
  if (std::abs(z) < 1e-3) {
    const double p2 = pi * pi;
    const double z2 = z * z;
    return {1.0 - p2 * z2 / 6.0 + p2 * p2 * z2 * z2 / 120.0, -p2 * z / 3.0 + p2 * p2 * z * z2 / 30.0,
            -p2 / 3.0 + p2 * p2 * z2 / 10.0};
  }
  const double value = std::sin(pi * z) / (pi * z);
  const double slope = (std::cos(pi * z) - value) / z;
  return {value, slope, -pi * pi * value - 2.0 * slope / z};
}

Jet tapered_sinc_jet(double z) {
  if (std::abs(z) >= taper_half) return {};
  const double w = pi / taper_half;
  const Jet taper{0.5 * (1.0 + std::cos(w * z)), -0.5 * w * std::sin(w * z), -0.5 * w * w * std::cos(w * z)};
  const Jet s = sinc_jet(z);
  return {s.value * taper.value, s.slope * taper.value + s.value * taper.slope,
          s.curvature * taper.value + 2.0 * s.slope * taper.slope + s.value * taper.curvature};
}

// Solves the tridiagonal system in place (Thomas). No pivoting is needed: all but the rows of a spline's ends dominate
// their diagonals, and what is left of those after the first step does, too.
void solve_tridiagonal(const std::vector<double>& lower, std::vector<double> diagonal, const std::vector<double>& upper,
                       std::vector<double>& right) {
  for (std::size_t i = 1; i < right.size(); ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = right.size(); i-- > 0;) {
    if (i + 1 < right.size()) right[i] -= upper[i] * right[i + 1];
    right[i] /= diagonal[i];
  }
}

}  // namespace

Interpolator::Interpolator(const SampledFunction& function, InterpolationRules rules, double y_scale)
    : method_(function.method), rule_(rules.low_pass), beyond_(rules.beyond), knots_(function.knots) {
  for (Knot& knot : knots_) knot.y *= y_scale;
  if (knots_.size() < 2) return;
  if (method_ == Interpolation::cubic) prepare_cubic(rules.cubic_ends);
  if (method_ == Interpolation::low_pass) prepare_low_pass();
}

Jet Interpolator::jet(double x) const {
  if (knots_.empty()) return {};
  if (knots_.size() == 1) return {knots_.front().y, 0.0, 0.0};
  if (beyond_ != Beyond::extended && (x < knots_.front().x || x > knots_.back().x)) return outer_jet(x);
  return inner_jet(x);
}

Jet Interpolator::inner_jet(double x) const {
  switch (method_) {
    case Interpolation::linear: return linear_jet(x);
    case Interpolation::cubic: return cubic_jet(x);
    case Interpolation::low_pass: return rule_ == LowPassRule::first_knot ? tapered_jet(x) : bare_sinc_jet(x);
  }
  return {};
}

Jet Interpolator::outer_jet(double x) const {
  if (beyond_ == Beyond::zero) return {};
  const Knot& end = x < knots_.front().x ? knots_.front() : knots_.back();
  if (method_ != Interpolation::low_pass) return {end.y, 0.0, 0.0};
  // A tapered sinc holds its ends anyway.
  return {inner_jet(rule_ == LowPassRule::first_knot ? x : end.x).value, 0.0, 0.0};
}

double Interpolator::third_derivative(double x) const {
  if (knots_.size() < 2 || method_ == Interpolation::linear) return 0.0;
  if (method_ == Interpolation::cubic) {
    if (x < knots_.front().x || x > knots_.back().x) return 0.0;
    const std::size_t i = segment(x);
    const double h = knots_[i + 1].x - knots_[i].x;
    const double rise = knots_[i + 1].y - knots_[i].y;
    return 6.0 * (slopes_[i] + slopes_[i + 1] - 2.0 * rise / h) / (h * h);
  }
  const double half = 1e-3 * step_;
  return (jet(x + half).curvature - jet(x - half).curvature) / (2.0 * half);
}

// The curvature of a cubic is straight between knots.
double Interpolator::curvature_bound() const {
  if (knots_.size() < 2 || method_ == Interpolation::linear) return 0.0;
  if (method_ == Interpolation::low_pass) return std::numeric_limits<double>::infinity();
  double bound = 0.0;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double h = knots_[i + 1].x - knots_[i].x;
    const double chord = (knots_[i + 1].y - knots_[i].y) / h;
    const double left = 6.0 * chord - 4.0 * slopes_[i] - 2.0 * slopes_[i + 1];
    const double right = 2.0 * slopes_[i] + 4.0 * slopes_[i + 1] - 6.0 * chord;
    bound = std::max({bound, std::abs(left / h), std::abs(right / h)});
  }
  return bound;
}

// Index of the segment [i, i + 1] that holds x; a knot, within rounding, belongs to the segment on its right.
std::size_t Interpolator::segment(double x) const {
  const double guarded = x + 4e-16 * std::max(std::abs(x), std::abs(knots_.back().x));
  const auto after = std::ranges::upper_bound(knots_, guarded, {}, &Knot::x);
  const auto index = after - knots_.begin() - 1;
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(knots_.size()) - 2));
}

Jet Interpolator::linear_jet(double x) const {
  const std::size_t i = segment(x);
  const Knot& a = knots_[i];
  const Knot& b = knots_[i + 1];
  const double slope = (b.y - a.y) / (b.x - a.x);
  return {a.y + slope * (x - a.x), slope, 0.0};
}

void Interpolator::prepare_cubic(CubicEnds ends) {
  const std::size_t count = knots_.size();
  const auto width = [&](std::size_t i) { return knots_[i + 1].x - knots_[i].x; };
  const auto chord = [&](std::size_t i) { return (knots_[i + 1].y - knots_[i].y) / width(i); };
  slopes_ = {chord(0), chord(count - 2)};
  if (count == 2) return;
  std::vector<double> lower(count), diagonal(count, 1.0), upper(count), right(count);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    lower[i] = width(i);
    diagonal[i] = 2.0 * (width(i - 1) + width(i));
    upper[i] = width(i - 1);
    right[i] = 3.0 * (width(i) * chord(i - 1) + width(i - 1) * chord(i));
  }
  right.front() = chord(0);
  right.back() = chord(count - 2);
  if (ends == CubicEnds::not_a_knot) {
    // End slope and its neighbour's, from equal third derivatives on both sides of the knot next to the end. Of three
    // knots that is one knot, and the second equation is a parabola's: the mean of two slopes is the chord's.
    const auto equation = [](double outer, double inner, double outer_chord, double inner_chord) {
      return ((outer + 2.0 * (outer + inner)) * inner * outer_chord + outer * outer * inner_chord) / (outer + inner);
    };
    diagonal.front() = width(1);
    upper.front() = width(0) + width(1);
    right.front() = equation(width(0), width(1), chord(0), chord(1));
    diagonal.back() = width(count - 3);
    lower.back() = width(count - 2) + width(count - 3);
    right.back() = equation(width(count - 2), width(count - 3), chord(count - 2), chord(count - 3));
    if (count == 3) {
      diagonal.back() = lower.back() = 1.0;
      right.back() = 2.0 * chord(1);
    }
  }
  solve_tridiagonal(lower, diagonal, upper, right);
  slopes_ = std::move(right);
}

Jet Interpolator::cubic_jet(double x) const {
  if (x < knots_.front().x) return {knots_.front().y + slopes_.front() * (x - knots_.front().x), slopes_.front(), 0.0};
  if (x > knots_.back().x) return {knots_.back().y + slopes_.back() * (x - knots_.back().x), slopes_.back(), 0.0};
  const std::size_t i = segment(x);
  const double h = knots_[i + 1].x - knots_[i].x;
  const double rise = knots_[i + 1].y - knots_[i].y;
  const double u = x - knots_[i].x;
  const double c1 = slopes_[i];
  const double c2 = 3.0 * rise / (h * h) - (2.0 * slopes_[i] + slopes_[i + 1]) / h;
  const double c3 = -2.0 * rise / (h * h * h) + (slopes_[i] + slopes_[i + 1]) / (h * h);
  return {knots_[i].y + u * (c1 + u * (c2 + u * c3)), c1 + u * (2.0 * c2 + 3.0 * u * c3), 2.0 * c2 + 6.0 * u * c3};
}

void Interpolator::prepare_low_pass() {
  const double anchor = rule_ == LowPassRule::first_knot ? knots_.front().x : 0.0;
  step_ = (knots_.back().x - knots_.front().x) / static_cast<double>(knots_.size() - 1);
  // Knot x falls into the bin of grid point k where k - 1/2 < x/step <= k + 1/2.
  const auto bin = [&](double x) { return static_cast<long>(std::ceil((x - anchor) / step_ - 0.5 - 1e-9)); };
  grid_first_ = bin(knots_.front().x);
  const long last = bin(knots_.back().x);
  grid_.assign(static_cast<std::size_t>(last - grid_first_ + 1), 0.0);
  std::vector<int> members(grid_.size(), 0);
  for (const Knot& knot : knots_) {
    const auto k = static_cast<std::size_t>(bin(knot.x) - grid_first_);
    grid_[k] += knot.y;
    ++members[k];
  }
  for (std::size_t k = 0; k < grid_.size(); ++k) {
    if (members[k] > 0)
      grid_[k] /= members[k];
    else if (rule_ == LowPassRule::first_knot)
      grid_[k] = linear_jet(anchor + static_cast<double>(static_cast<long>(k) + grid_first_) * step_).value;
  }
}

Jet Interpolator::tapered_jet(double x) const {
  if (std::isnan(x)) return {x, x, x};
  if (x < knots_.front().x) return {grid_.front(), 0.0, 0.0};
  if (x > knots_.back().x) return {grid_.back(), 0.0, 0.0};
  const double u = (x - knots_.front().x) / step_;
  const long centre = std::lround(u);
  const long last = static_cast<long>(grid_.size()) - 1;
  Jet sum;
  Jet weight;
  for (long k = centre - half_terms - 1; k <= centre + half_terms + 1; ++k) {
    const double a = grid_[static_cast<std::size_t>(std::clamp(k, 0L, last))];
    const Jet g = tapered_sinc_jet(u - static_cast<double>(k));
    sum = {sum.value + a * g.value, sum.slope + a * g.slope, sum.curvature + a * g.curvature};
    weight = {weight.value + g.value, weight.slope + g.slope, weight.curvature + g.curvature};
  }
  const double value = sum.value / weight.value;
  const double slope = (sum.slope - value * weight.slope) / weight.value;
  const double curvature = (sum.curvature - 2.0 * slope * weight.slope - value * weight.curvature) / weight.value;
  return {value, slope / step_, curvature / (step_ * step_)};
}

Jet Interpolator::bare_sinc_jet(double x) const {
  const double u = x / step_;
  const double centre = std::floor(u + 0.5);
  if (!(std::abs(centre) <= 1e15)) return {};  // NaN neither.
  Jet sum;
  const long first = std::max(static_cast<long>(centre) - half_terms, grid_first_);
  const long last = std::min(static_cast<long>(centre) + half_terms, grid_first_ + static_cast<long>(grid_.size()) - 1);
  for (long k = first; k <= last; ++k) {
    const double a = grid_[static_cast<std::size_t>(k - grid_first_)];
    const Jet g = sinc_jet(u - static_cast<double>(k));
    sum = {sum.value + a * g.value, sum.slope + a * g.slope, sum.curvature + a * g.curvature};
  }
  return {sum.value, sum.slope / step_, sum.curvature / (step_ * step_)};
}

}  // namespace sarsim::core
