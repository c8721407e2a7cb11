#include "radar/echo/pulse_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double fit_tolerance = 2e-13;  // of the largest magnitude
constexpr double in_doubt = 2e-9;        // sampling intervals: twice the tolerance of edges (decision 8)
constexpr double shortest_piece = 1e-6;  // sampling intervals; a slope over less counts as a jump
constexpr double smallest_jump = 1e-12;  // of a curve's largest knot
constexpr int max_piece_halvings = 8;

void sort_and_unite(std::vector<double>& positions) {
  std::ranges::sort(positions);
  const auto same = std::ranges::unique(positions);
  positions.erase(same.begin(), same.end());
}

double position_of(double y, double begin, double end) { return begin + 0.5 * (1.0 + y) * (end - begin); }

}  // namespace

PulsePieces::PulsePieces(const Pulse& pulse, double interval_s) : pulse_(&pulse), interval_s_(interval_s) {
  CORE_EXPECT(interval_s > 0.0);
  CORE_EXPECT(pulse.width_s > 0.0);
  find_borders();
  find_largest();
  const std::vector<double> given = std::move(border_);
  border_ = {0.0};
  for (std::size_t i = 0; i + 1 < given.size(); ++i) fit(given[i], given[i + 1], 0);
  mark_sharp_borders();
}

void PulsePieces::find_borders() {
  const double width_s = pulse_->width_s;
  const double width = width_s / interval_s_;
  border_ = {0.0, width};
  for (const double t : pulse_->breaks_s()) border_.push_back(t / interval_s_);
  // Ramps that overlap meet below 1.
  const double ramps = pulse_->rise_s + pulse_->fall_s;
  if (pulse_->envelope == Pulse::Envelope::linear && ramps > width_s)
    border_.push_back(width_s * pulse_->rise_s / ramps / interval_s_);
  if (is_complex()) {
    add_curve(pulse_->in_phase);
    add_curve(pulse_->quadrature);
  }
  if (pulse_->envelope == Pulse::Envelope::user) add_curve(pulse_->envelope_gain);
  std::erase_if(border_, [&](double b) { return b < 0.0 || b > width; });
  sort_and_unite(border_);
  sort_and_unite(bends_);
  sort_and_unite(jumps_);
}

void PulsePieces::add_curve(const core::Interpolator& curve) {
  const std::vector<core::Knot>& knots = curve.knots();
  if (knots.size() < 2) return;
  const double width = pulse_->width_s / interval_s_;
  const double step = (knots.back().x - knots.front().x) / static_cast<double>(knots.size() - 1);
  for (std::size_t k = 0; k < knots.size(); ++k)
    bends_.push_back((knots.front().x + static_cast<double>(k) * step) * width);
  add_jumps(curve, step);
}

// A bare sinc of 21 terms takes up and drops terms halfway between grid points counted from 0, up to 10.5 steps beyond
// the knots.
void PulsePieces::add_jumps(const core::Interpolator& curve, double step) {
  const std::vector<core::Knot>& knots = curve.knots();
  double largest = 0.0;
  for (const core::Knot& knot : knots) largest = std::max(largest, std::abs(knot.y));
  const double first = std::max(0.0, std::floor(knots.front().x / step) - 12.0);
  const double last = std::min(1.0 / step, std::ceil(knots.back().x / step) + 12.0);
  const double reach = 1e-6 * step;
  for (double k = first; k <= last; k += 1.0) {
    const double x = (k + 0.5) * step;
    const auto across = [&](double r) { return curve.value(x + r) - curve.value(x - r); };
    // The slope drops out of this difference.
    if (std::abs(2.0 * across(reach) - across(2.0 * reach)) <= smallest_jump * largest) continue;
    const double jump = x * pulse_->width_s / interval_s_;
    border_.push_back(jump);
    jumps_.push_back(jump);
  }
}

FitTerms PulsePieces::values_at_nodes(double begin, double end) const {
  FitTerms values;
  for (std::size_t k = 0; k < fit_terms; ++k) values[k] = exact(position_of(fit_nodes()[k], begin, end) * interval_s_);
  return values;
}

void PulsePieces::find_largest() {
  for (std::size_t i = 0; i + 1 < border_.size(); ++i)
    for (const auto& value : values_at_nodes(border_[i], border_[i + 1]))
      largest_ = std::max(largest_, std::abs(value));
}

// Appends the piece, or where it is no polynomial its parts.
void PulsePieces::fit(double begin, double end, int halvings) {
  // A curve that changes within the piece feels the rounding of the position.
  const double tolerance = largest_ * (fit_tolerance + 5e-16 * end / (end - begin));
  const FitTerms series = chebyshev_series(values_at_nodes(begin, end));
  const std::size_t degree = degree_within(series, tolerance);
  const FitTerms powers = powers_of(series, degree);
  bool good = degree + 2 < fit_terms;
  for (const double y : {-1.0 + 1e-9, -0.995, -0.5, 0.1, 0.995, 1.0 - 1e-9})
    good = good && std::abs(polynomial(powers, y) - exact(position_of(y, begin, end) * interval_s_)) <= 4.0 * tolerance;
  if (good || halvings == max_piece_halvings) {
    border_.push_back(end);
    degree_.push_back(degree);
    powers_.push_back(powers);
    exact_only_.push_back(!good || end - begin < shortest_piece);
    return;
  }
  double middle = 0.5 * (begin + end);
  const auto bend = std::ranges::lower_bound(bends_, middle - 0.25 * (end - begin));
  const bool bends = bend != bends_.end() && *bend < middle + 0.25 * (end - begin);
  if (bends) middle = *bend;
  fit(begin, middle, halvings + (bends ? 0 : 1));
  fit(middle, end, halvings + (bends ? 0 : 1));
}

void PulsePieces::mark_sharp_borders() {
  sharp_.assign(border_.size(), 0);
  for (std::size_t k = 0; k < border_.size(); ++k)
    if (std::ranges::binary_search(jumps_, border_[k])) sharp_[k] = 1;
  for (std::size_t k = 0; k < size(); ++k)
    if (exact_only_[k] != 0) sharp_[k] = sharp_[k + 1] = 1;
}

std::size_t PulsePieces::piece_at(double position, std::size_t first, std::size_t last) const {
  std::size_t piece = first;
  if (last - first <= 8) {
    // Without branches: they could not be predicted.
    for (std::size_t k = first + 1; k < last; ++k) piece += border_[k] <= position ? 1U : 0U;
    return piece;
  }
  const auto begin = border_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto after = std::upper_bound(begin + 1, border_.begin() + static_cast<std::ptrdiff_t>(last), position);
  return first + static_cast<std::size_t>(after - begin) - 1;
}

std::complex<double> PulsePieces::value(std::size_t piece, double position) const {
  const double begin = border_[piece];
  const double end = border_[piece + 1];
  const double y = (2.0 * position - begin - end) / (end - begin);
  return polynomial({powers_[piece].data(), degree_[piece] + 1}, y);
}

bool PulsePieces::is_in_doubt(std::size_t piece, double position) const {
  const double begin = border_[piece];
  const double end = border_[piece + 1];
  return (is_sharp(piece) && position - begin < in_doubt) || (is_sharp(piece + 1) && end - position < in_doubt) ||
         exact_only_[piece] != 0;
}

}  // namespace sarsim::radar
