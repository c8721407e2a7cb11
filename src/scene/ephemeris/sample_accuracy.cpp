#include "scene/ephemeris/sample_accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "radar/orbit/state_polynomial.hpp"
#include "scene/ephemeris/polynomial_weights.hpp"
#include "scene/ephemeris/sample_noise.hpp"

namespace sarsim::scene {

namespace {

using core::Vec3;
using radar::TimeSpan;

constexpr std::size_t max_intervals = 2000;
constexpr std::array<double, 3> shares{0.3, 0.5, 0.7};

// Intervals of samples that have a part of a time: those that begin at [first, last).
struct Intervals {
  std::size_t first = 0;
  std::size_t last = 0;
};

Intervals intervals_within(const std::vector<double>& time_s, const TimeSpan& within) {
  if (time_s.size() < 2 || !(within.first_s <= time_s.back() && within.last_s >= time_s.front())) return {};
  const auto after = std::ranges::upper_bound(time_s, within.first_s) - time_s.begin();
  const auto end = std::ranges::lower_bound(time_s, within.last_s) - time_s.begin();
  const auto most = static_cast<std::ptrdiff_t>(time_s.size()) - 1;
  const auto first = std::clamp<std::ptrdiff_t>(after - 1, 0, most);
  // A moment, too, lies in an interval.
  const auto last = std::clamp<std::ptrdiff_t>(std::max(end, after), first, most);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
}

// Calls `look` for evenly chosen intervals, the last of them in any case.
template <class Look>
void for_some(const Intervals& intervals, const Look& look) {
  if (intervals.first >= intervals.last) return;
  const std::size_t step = 1 + (intervals.last - intervals.first - 1) / max_intervals;
  for (std::size_t i = intervals.first; i < intervals.last; i += step) look(i);
  if (step > 1) look(intervals.last - 1);
}

// Differences of polynomials at one place: p through the states that are used, p2 and p4 through two and four more.
struct OrderDifferences {
  double p4_p = 0.0;
  double p4_p2 = 0.0;
  double p2_p = 0.0;
  double p_lower = 0.0;  ///< The larger one of p to those through one and two fewer.
};

double error_by_orders(const OrderDifferences& d) {
  constexpr double slowest = 0.75;
  if (!(d.p4_p2 < d.p2_p)) return std::max(d.p2_p, std::min(d.p4_p, d.p_lower));
  const double q = std::min(d.p4_p2 / d.p2_p, slowest);
  return d.p4_p + d.p4_p2 * q / (1.0 - q);
}

// The error of a polynomial where there are no more states, by its difference to the one before and the difference of
// that to the one before it.
// @param spread  by how much the product of the distances to the states grew with the last one more than before
double error_by_last_orders(double last, double before, double spread) {
  return last * spread < before ? last * last / before * spread : last;
}

// The polynomials through the first 1, 2, ... of some states at one time, and the noise that they have of these.
class PolynomialsAt {
 public:
  PolynomialsAt(const radar::StateView& view, std::span<const std::size_t> order, double time_s,
                RepeatedWeights& weights)
      : count_(order.size()), weights_(weights.at(view, order, time_s)) {
    radar::polynomial_sums(view, order, time_s, std::span(sums_).first(count_));
    for (std::size_t j = 0; j < count_; ++j) offset_s_[j] = view.time_s[order[j]] - time_s;
  }

  /// How much farther the last state of the polynomial through the first a states is than the one before it; of both,
  /// where positions and velocities count.
  [[nodiscard]] double spread(std::size_t a) const {
    const double farther = std::abs(offset_s_[a - 1] / offset_s_[a - 2]);
    return weights_.of_velocity.empty() ? farther : farther * farther;
  }

  /// Between those through the first a and the first b states.
  [[nodiscard]] double apart(std::size_t a, std::size_t b) const {
    return core::norm(sums_[a - 1].position_m - sums_[b - 1].position_m);
  }

  /// Of the polynomial through the first a states, less that through the first b; b is 0 for none.
  /// @param noises  of the states
  [[nodiscard]] double noise(std::size_t a, std::size_t b, std::span<const StateNoise> noises) const {
    double squares = 0.0;
    for (std::size_t j = 0; j < count_; ++j) {
      const double of_position = (weight(weights_.of_position, a, j) - weight(weights_.of_position, b, j));
      const double of_velocity = (weight(weights_.of_velocity, a, j) - weight(weights_.of_velocity, b, j));
      squares += std::pow(of_position * noises[j].position_m, 2) + std::pow(of_velocity * noises[j].velocity_mps, 2);
    }
    return std::sqrt(squares);
  }

 private:
  [[nodiscard]] double weight(const std::vector<double>& weights, std::size_t through, std::size_t j) const {
    return through == 0 || weights.empty() ? 0.0 : weights[(through - 1) * count_ + j];
  }

  std::size_t count_;
  const PolynomialWeights& weights_;
  std::array<radar::OrbitState, radar::max_polynomial_states> sums_;
  std::array<double, radar::max_polynomial_states> offset_s_{};  // of the states from the time
};

// What the polynomial through the first `used` states loses of a smooth motion. Differences that noise explains say
// nothing.
double smooth_error(const PolynomialsAt& polynomials, std::size_t more, std::size_t used,
                    std::span<const StateNoise> noises) {
  constexpr double explained = 3.0;
  const auto off = [&](std::size_t a, std::size_t b) {
    const double apart = polynomials.apart(a, b);
    return apart > explained * polynomials.noise(a, b, noises) ? apart : 0.0;
  };
  const std::size_t fewer = used > 2 ? used - 2 : 1;
  const double lower = std::max(off(used, fewer), off(used, used - 1));
  const std::size_t between = used + (more - used) / 2;
  if (more > used + 1) return error_by_orders({off(more, used), off(more, between), off(between, used), lower});
  const double by_last =
      used > 2 ? error_by_last_orders(off(used, used - 1), off(used - 1, used - 2), polynomials.spread(used))
               : off(used, 1);
  if (more == used) return by_last;
  return std::max(by_last, error_by_orders({off(more, used), off(more, used), lower, lower}));
}

// The states of the polynomial in one interval, near to far, and behind them up to two on other sides.
std::vector<std::size_t> order_in(const radar::StateInterpolation& interpolation, std::size_t count, std::size_t left) {
  const std::size_t states = std::min(interpolation.states, count);
  const std::size_t before = (states - 1) / 2;
  const std::size_t first = std::min(left > before ? left - before : 0, count - states);
  std::vector<std::size_t> order = radar::neighbours_of(left, first, first + states, states);
  std::size_t below = first;
  std::size_t above = first + states;
  for (std::size_t k = 0; k < 4 && (below > 0 || above < count); ++k)
    order.push_back(above >= count || (below > 0 && k % 2 == 0) ? --below : above++);
  return order;
}

// Of the table through states, in intervals of them.
class StateAccuracy {
 public:
  StateAccuracy(const radar::StateView& view, const radar::StateInterpolation& interpolation)
      : view_(view),
        interpolation_(interpolation),
        used_(std::min(interpolation.states, view.time_s.size())),
        noises_(view) {}

  std::optional<SampleAccuracy> worst_of(const Intervals& intervals) {
    std::optional<SampleAccuracy> worst;
    for_some(intervals, [&](std::size_t left) { take_interval(left, worst); });
    return worst;
  }

 private:
  [[nodiscard]] double length_s(std::size_t left) const { return view_.time_s[left + 1] - view_.time_s[left]; }
  [[nodiscard]] std::vector<std::size_t> order(std::size_t left) const {
    return order_in(interpolation_, view_.time_s.size(), left);
  }
  [[nodiscard]] PolynomialsAt polynomials(std::span<const std::size_t> order, std::size_t left, std::size_t share) {
    return {view_, order, view_.time_s[left] + shares[share] * length_s(left), weights_[share]};
  }

  void take_interval(std::size_t left, std::optional<SampleAccuracy>& worst) {
    const std::vector<std::size_t> through = order(left);
    const std::vector<StateNoise> noises = noises_.around(left, through);
    const auto take = [&](double noise_m, double smooth_m, double share) {
      const double error_m = std::hypot(noise_m, smooth_m);
      if (worst && !(error_m > worst->error)) return;
      worst = {error_m, view_.time_s[left] + share * length_s(left), length_s(left),
               core::norm(view_.position_m[left + 1] - view_.position_m[left])};
    };
    for (std::size_t j = 0; j < through.size(); ++j)
      if (through[j] == left || through[j] == left + 1)
        take(noises[j].position_m, 0.0, static_cast<double>(through[j] - left));
    for (std::size_t share = 0; share < shares.size(); ++share) {
      const PolynomialsAt at = polynomials(through, left, share);
      take(at.noise(used_, 0, noises), smooth_error(at, through.size(), used_, noises), shares[share]);
    }
  }

  radar::StateView view_;
  radar::StateInterpolation interpolation_;
  std::size_t used_;
  StateNoises noises_;
  std::array<RepeatedWeights, shares.size()> weights_;
};

using Parts = std::array<double, 4>;  // of a quaternion

double dot_of(const Parts& a, const Parts& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

// Of length 1, each on the side of the one before it.
std::vector<Parts> parts_of(const std::vector<radar::Quaternion>& attitudes) {
  std::vector<Parts> all;
  all.reserve(attitudes.size());
  for (const radar::Quaternion& q : attitudes) {
    Parts parts{q.w, q.x, q.y, q.z};
    const double side = !all.empty() && dot_of(parts, all.back()) < 0.0 ? -1.0 : 1.0;
    const double scale = side / std::sqrt(dot_of(parts, parts));
    for (double& part : parts) part *= scale;
    all.push_back(parts);
  }
  return all;
}

// Of the rotation that leads from one attitude to the other.
double turn_rad(const Parts& a, const Parts& b) {
  Parts less{}, more{};
  for (std::size_t i = 0; i < 4; ++i) {
    less[i] = a[i] - b[i];
    more[i] = a[i] + b[i];
  }
  const double near = std::sqrt(std::min(dot_of(less, less), dot_of(more, more)));
  return 4.0 * std::asin(std::min(0.5 * near, 1.0));
}

Parts parts_of(const core::Mat3& matrix) {
  const radar::Quaternion q = radar::quaternion_of(matrix);
  return {q.w, q.x, q.y, q.z};
}

// The polynomial through the attitudes around an interval, taken to length 1.
class AttitudePolynomial {
 public:
  AttitudePolynomial(const std::vector<double>& time_s, const std::vector<Parts>& parts) : time_s_(time_s) {
    for (const Parts& one : parts) {
      vector_.push_back({one[1], one[2], one[3]});
      scalar_.push_back({one[0], 0.0, 0.0});
    }
  }

  [[nodiscard]] Parts at(std::size_t left, double time_s) const {
    constexpr std::size_t most = 8;
    const std::vector<std::size_t> order = radar::neighbours_of(left, 0, time_s_.size(), most);
    const Vec3 v = value(vector_, order, time_s);
    const Vec3 s = value(scalar_, order, time_s);
    Parts parts{s.x, v.x, v.y, v.z};
    const double length = std::sqrt(dot_of(parts, parts));
    for (double& part : parts) part /= length;
    return parts;
  }

  // Of each of the two attitudes at the ends of an interval, as angles.
  [[nodiscard]] std::array<double, 2> noise_rad(std::size_t left) const {
    const SampleNoise of_vector(time_s_, vector_), of_scalar(time_s_, scalar_);
    const auto vector_order = of_vector.order_around(left), scalar_order = of_scalar.order_around(left);
    std::array<double, 2> noise{};
    if (!vector_order) return noise;
    for (std::size_t end = 0; end < 2; ++end)
      noise[end] = 2.0 * std::hypot(of_vector.size(left + end, *vector_order),
                                    scalar_order ? of_scalar.size(left + end, *scalar_order) : 0.0);
    return noise;
  }

 private:
  [[nodiscard]] Vec3 value(const std::vector<Vec3>& of, const std::vector<std::size_t>& order, double time_s) const {
    std::array<radar::OrbitState, radar::max_polynomial_states> sums;
    radar::polynomial_sums({time_s_, of, {}}, order, time_s, std::span(sums).first(order.size()));
    return sums[order.size() - 1].position_m;
  }

  const std::vector<double>& time_s_;
  std::vector<Vec3> vector_, scalar_;
};

}  // namespace

std::optional<SampleAccuracy> accuracy_between(const radar::StateSamples& samples,
                                               const radar::StateInterpolation& interpolation, const TimeSpan& within) {
  const Intervals intervals = intervals_within(samples.time_s, within);
  if (intervals.first >= intervals.last) return std::nullopt;
  constexpr std::size_t around = 40;  // states that have a part in what is estimated
  const std::size_t begin = intervals.first > around ? intervals.first - around : 0;
  const std::size_t count = std::min(samples.time_s.size(), intervals.last + around) - begin;
  radar::StateView view{
      std::span(samples.time_s).subspan(begin, count), std::span(samples.position_m).subspan(begin, count), {}};
  if (interpolation.use_velocities) view.velocity_mps = std::span(samples.velocity_mps).subspan(begin, count);
  return StateAccuracy(view, interpolation).worst_of({intervals.first - begin, intervals.last - begin});
}

std::optional<SampleAccuracy> accuracy_between(const radar::AttitudeSamples& samples, const TimeSpan& within) {
  const auto made = radar::AttitudeTable::from(samples);
  const auto* const table = std::get_if<radar::AttitudeTable>(&made);
  if (table == nullptr) return std::nullopt;
  const std::vector<Parts> parts = parts_of(samples.world_from_platform);
  const AttitudePolynomial polynomial(samples.time_s, parts);
  std::optional<SampleAccuracy> worst;
  for_some(intervals_within(samples.time_s, within), [&](std::size_t left) {
    const double length_s = samples.time_s[left + 1] - samples.time_s[left];
    const auto take = [&](double error, double share) {
      if (worst && !(error > worst->error)) return;
      worst = {error, samples.time_s[left] + share * length_s, length_s, turn_rad(parts[left], parts[left + 1])};
    };
    const std::array<double, 2> noise = polynomial.noise_rad(left);
    const double least = std::max(noise[0], noise[1]);  // Of noise splines and polynomials make different paths, too.
    take(noise[0], 0.0);
    take(noise[1], 1.0);
    for (const double share : shares) {
      const double time_s = samples.time_s[left] + share * length_s;
      const double apart = turn_rad(parts_of(table->turning_at(time_s).matrix), polynomial.at(left, time_s));
      if (apart > least) take(std::hypot(apart, least), share);
    }
  });
  return worst;
}

std::optional<SampleAccuracy> largest_turn(const radar::AttitudeSamples& samples, const TimeSpan& within) {
  const std::vector<Parts> parts = parts_of(samples.world_from_platform);
  const Intervals intervals = intervals_within(samples.time_s, within);
  std::optional<SampleAccuracy> worst;
  for (std::size_t i = intervals.first; i < intervals.last; ++i) {
    const double turn = turn_rad(parts[i], parts[i + 1]);
    if (!worst || turn > worst->step) worst = {0.0, samples.time_s[i], samples.time_s[i + 1] - samples.time_s[i], turn};
  }
  return worst;
}

}  // namespace sarsim::scene
