#include "radar/motion/error_process.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr int steps_over_support = 512;

// Mean of h over one step by Simpson's rule on four panels; exact for the pieces of linear and cubic functions
// between knots.
double mean_over(const core::Interpolator& h, double start, double step) {
  constexpr int panels = 4;
  double sum = 0.0;
  for (int i = 0; i <= 2 * panels; ++i) {
    const double weight = (i == 0 || i == 2 * panels) ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * h.value(start + step * i / (2.0 * panels));
  }
  return sum / (6.0 * panels);
}

// True where h vanishes at both of its ends, within 1/100 of its largest value at the middles of 512 steps.
bool vanishes_at_ends(const core::Interpolator& h) {
  const double first = h.knots().front().x;
  const double last = h.knots().back().x;
  double largest = 0.0;
  for (int k = 0; k < steps_over_support; ++k)
    largest = std::max(largest, std::abs(h.value(first + (last - first) * (k + 0.5) / steps_over_support)));
  return std::abs(h.value(first)) <= 0.01 * largest && std::abs(h.value(last)) <= 0.01 * largest;
}

}  // namespace

ErrorProcess::ErrorProcess(const core::Interpolator& envelope, const core::RandomStream& stream, int axis, bool smooth)
    : stream_(stream), axis_(axis) {
  CORE_EXPECT(axis >= 0 && axis <= 2);
  if (envelope.knots().size() < 2) return;
  const double first = envelope.knots().front().x;
  const double last = envelope.knots().back().x;
  step_s_ = (last - first) / steps_over_support;
  first_lag_ = std::llround(first / step_s_);
  differentiable_ = vanishes_at_ends(envelope);
  weights_.resize(steps_over_support);
  for (int k = 0; k < steps_over_support; ++k)
    weights_[static_cast<std::size_t>(k)] = mean_over(envelope, first + k * step_s_, step_s_) * std::sqrt(step_s_);
  if (!smooth) return;
  slope_weights_.resize(steps_over_support);
  // What the mean over a step gains as time goes on. h is 0 outside.
  const auto edge = [&](int k) {
    return k == 0 || k == steps_over_support ? 0.0 : envelope.value(first + k * step_s_);
  };
  for (int k = 0; k < steps_over_support; ++k)
    slope_weights_[static_cast<std::size_t>(k)] = (edge(k + 1) - edge(k)) / std::sqrt(step_s_);
}

core::Jet ErrorProcess::at(double time_s) const {
  Step step;
  return at(time_s, step);
}

core::Jet ErrorProcess::at(double time_s, Step& step) const {
  if (!active()) return {};
  const double position = time_s / step_s_;
  const double below = std::floor(position + 1e-9);
  if (step.below != below) step = step_from(below);
  if (!slope_weights_.empty()) return on_cubic(step, position - below);
  const double rise = step.right - step.left;
  return {step.left + rise * (position - below), differentiable_ ? rise / step_s_ : 0.0, 0.0};
}

// Hermite's cubic between two grid times.
core::Jet ErrorProcess::on_cubic(const Step& step, double share) const {
  const double rise = step.right - step.left;
  const double a = step.left_slope * step_s_;
  const double b = step.right_slope * step_s_;
  const double square = 3.0 * rise - 2.0 * a - b;
  const double cube = a + b - 2.0 * rise;
  return {step.left + share * (a + share * (square + share * cube)),
          (a + share * (2.0 * square + 3.0 * share * cube)) / step_s_,
          (2.0 * square + 6.0 * share * cube) / (step_s_ * step_s_)};
}

ErrorProcess::Step ErrorProcess::step_from(double below) const {
  const std::int64_t newest = static_cast<std::int64_t>(below) + 1 - first_lag_;
  // White noise of the cells newest, newest - 1, ...; two neighbouring cells share one pair of normal numbers.
  std::array<double, steps_over_support + 2> noise;
  for (std::size_t i = 0; i <= weights_.size();) {
    const std::int64_t cell = newest - static_cast<std::int64_t>(i);
    const std::int64_t pair = cell >= 0 ? cell / 2 : (cell - 1) / 2;
    const auto numbers = stream_.normals(pair, axis_);
    if (cell != 2 * pair) noise[i++] = numbers[1];
    noise[i++] = numbers[0];
  }
  double left = 0.0;
  double right = 0.0;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    right += weights_[k] * noise[k];
    left += weights_[k] * noise[k + 1];
  }
  Step step{below, left, right};
  for (std::size_t k = 0; k < slope_weights_.size(); ++k) {
    step.right_slope += slope_weights_[k] * noise[k];
    step.left_slope += slope_weights_[k] * noise[k + 1];
  }
  return step;
}

}  // namespace sarsim::radar
