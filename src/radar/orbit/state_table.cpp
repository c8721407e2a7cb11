#include "radar/orbit/state_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using core::Problem;
using core::Vec3;

constexpr std::size_t max_coefficients = 16;
constexpr std::size_t no_coefficients = static_cast<std::size_t>(-1);

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::optional<Problem> fault_of_lists(const StateSamples& samples, bool use_velocities) {
  const std::size_t count = samples.time_s.size();
  if (samples.position_m.size() != count)
    return core::error("positions and times differ in number")
        .found(fmt::format("{}", samples.position_m.size()))
        .expected(fmt::format("{}", count));
  if (use_velocities && samples.velocity_mps.empty() && count > 0)
    return core::error("the states have no velocities")
        .found("positions alone")
        .expected("interpolation of positions alone");
  if (use_velocities && samples.velocity_mps.size() != count)
    return core::error("velocities and times differ in number")
        .found(fmt::format("{}", samples.velocity_mps.size()))
        .expected(fmt::format("{}", count));
  return std::nullopt;
}

std::optional<Problem> fault_of_states(const StateSamples& samples, bool use_velocities) {
  for (std::size_t i = 0; i < samples.time_s.size(); ++i) {
    const double time_s = samples.time_s[i];
    if (!std::isfinite(time_s) || !finite(samples.position_m[i]) ||
        (use_velocities && !finite(samples.velocity_mps[i])))
      return core::error(fmt::format("state {} is not finite", i + 1)).expected("finite numbers");
    if (i > 0 && !(time_s > samples.time_s[i - 1]))
      return core::error(fmt::format("the time of state {} does not ascend", i + 1))
          .found(fmt::format("{} s", time_s))
          .expected(fmt::format("above {} s", samples.time_s[i - 1]));
  }
  return std::nullopt;
}

// Divided differences in place, Newton's form. Two neighbours at one place stand for a value and its slope, which
// `values` holds in the second of the two.
void divide_differences(const std::array<double, max_coefficients>& places, std::size_t count, bool pairs,
                        std::array<Vec3, max_coefficients>& values) {
  for (std::size_t level = 1; level < count; ++level)
    for (std::size_t k = count - 1; k >= level; --k) {
      const bool slope = pairs && level == 1 && k % 2 == 1;
      if (slope) continue;
      // On the first level the left neighbour of a pair is the value of the pair before.
      const Vec3& left = pairs && level == 1 ? values[k - 2] : values[k - 1];
      values[k] = (1.0 / (places[k] - places[k - level])) * (values[k] - left);
    }
}

// From Newton's form to powers.
void expand(const std::array<double, max_coefficients>& places, std::size_t count,
            std::array<Vec3, max_coefficients>& c) {
  for (std::size_t k = count - 1; k-- > 0;)
    for (std::size_t i = k; i + 1 < count; ++i) c[i] = c[i] - places[k] * c[i + 1];
}

// Neighbours of `left` from near to far within [first, first + count): left, left + 1, left - 1, left + 2, ...
std::array<std::size_t, max_coefficients> from_near_to_far(std::size_t left, std::size_t first, std::size_t count) {
  std::array<std::size_t, max_coefficients> order{};
  std::size_t below = left;
  std::size_t above = left + 1;
  order[0] = left;
  for (std::size_t k = 1; k < count; ++k) {
    const bool take_above = above < first + count && (below == first || above - left <= left - below + 1);
    order[k] = take_above ? above++ : --below;
  }
  return order;
}

}  // namespace

std::variant<StateTable, core::Problem> StateTable::from(const StateSamples& samples, StateInterpolation interpolation,
                                                         double largest_gap_s) {
  CORE_EXPECT(interpolation.states >= 2 && interpolation.coefficients() <= max_coefficients);
  CORE_EXPECT(largest_gap_s > 0.0);
  const bool use_velocities = interpolation.use_velocities;
  if (std::optional<Problem> fault = fault_of_lists(samples, use_velocities)) return *std::move(fault);
  if (std::optional<Problem> fault = fault_of_states(samples, use_velocities)) return *std::move(fault);

  StateTable table;
  const std::size_t count = samples.time_s.size();
  table.interpolation_ = interpolation;
  table.times_ = samples.time_s;
  table.coefficients_from_.assign(count, no_coefficients);
  table.coefficients_.reserve(count * interpolation.coefficients());
  for (std::size_t begin = 0, end = 1; begin < count; begin = end++) {
    while (end < count && samples.time_s[end] - samples.time_s[end - 1] <= largest_gap_s) ++end;
    if (end - begin >= interpolation.states) table.add_span(samples, begin, end);
  }
  if (table.spans_.empty())
    return core::error("there are too few states to interpolate")
        .found(fmt::format("{} states", count))
        .expected(fmt::format("{} or more without a gap", interpolation.states));
  table.intervals_per_s_ = static_cast<double>(count - 1) / (samples.time_s.back() - samples.time_s.front());
  return table;
}

void StateTable::add_span(const StateSamples& samples, std::size_t begin, std::size_t end) {
  const std::size_t states = interpolation_.states;
  const std::size_t before = (states - 1) / 2;
  for (std::size_t left = begin; left + 1 < end; ++left) {
    const std::size_t centred = left > begin + before ? left - before : begin;
    add_interval(samples, left, std::min(centred, end - states));
  }
  spans_.push_back({samples.time_s[begin], samples.time_s[end - 1]});
}

// The polynomial from state `left` to the next one, through the states from `first` on. Places are differences to the
// left state, times are in intervals from it: rounding is that of differences.
void StateTable::add_interval(const StateSamples& samples, std::size_t left, std::size_t first) {
  const bool pairs = interpolation_.use_velocities;
  const std::size_t count = interpolation_.coefficients();
  const double length_s = samples.time_s[left + 1] - samples.time_s[left];
  const Vec3 origin = samples.position_m[left];
  const auto order = from_near_to_far(left, first, interpolation_.states);
  std::array<double, max_coefficients> places{};
  std::array<Vec3, max_coefficients> c{};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t state = order[pairs ? k / 2 : k];
    places[k] = (samples.time_s[state] - samples.time_s[left]) / length_s;
    c[k] = pairs && k % 2 == 1 ? length_s * samples.velocity_mps[state] : samples.position_m[state] - origin;
  }
  divide_differences(places, count, pairs, c);
  expand(places, count, c);
  c[0] = c[0] + origin;
  coefficients_from_[left] = coefficients_.size();
  coefficients_.insert(coefficients_.end(), c.begin(), c.begin() + static_cast<std::ptrdiff_t>(count));
  double bound = 0.0;
  for (std::size_t k = 2; k < count; ++k) bound += static_cast<double>(k * (k - 1)) * core::norm(c[k]);
  acceleration_bound_mps2_ = std::max(acceleration_bound_mps2_, bound / (length_s * length_s));
}

// The interval with its left state at or before a time within the table. The last state belongs to the last interval.
std::size_t StateTable::interval_of(double time_s) const {
  const std::size_t last = times_.size() - 2;
  const auto guess = static_cast<std::size_t>((time_s - times_.front()) * intervals_per_s_);
  for (std::size_t i = guess > 0 ? std::min(guess - 1, last) : 0; i <= std::min(guess + 1, last); ++i)
    if (times_[i] <= time_s && time_s < times_[i + 1]) return i;
  const auto above = std::upper_bound(times_.begin(), times_.end() - 1, time_s);
  return static_cast<std::size_t>(above - times_.begin()) - 1;
}

std::optional<OrbitMotion> StateTable::at(double time_s) const {
  if (!(time_s >= times_.front() && time_s <= times_.back())) return std::nullopt;
  std::size_t left = interval_of(time_s);
  // The last state before a gap belongs to the interval on its left.
  if (coefficients_from_[left] == no_coefficients && left > 0 && time_s == times_[left]) --left;
  if (coefficients_from_[left] == no_coefficients) return std::nullopt;
  const Vec3* c = &coefficients_[coefficients_from_[left]];
  const double length_s = times_[left + 1] - times_[left];
  const double x = (time_s - times_[left]) / length_s;
  Vec3 value = c[interpolation_.coefficients() - 1];
  Vec3 slope{};
  Vec3 half_curvature{};
  for (std::size_t k = interpolation_.coefficients() - 1; k-- > 0;) {
    half_curvature = x * half_curvature + slope;
    slope = x * slope + value;
    value = x * value + c[k];
  }
  return OrbitMotion{value, (1.0 / length_s) * slope, (2.0 / (length_s * length_s)) * half_curvature};
}

bool StateTable::covers(double first_s, double last_s) const {
  return std::ranges::any_of(spans_,
                             [&](const TimeSpan& span) { return first_s >= span.first_s && last_s <= span.last_s; });
}

}  // namespace sarsim::radar
