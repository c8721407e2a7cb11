#include "scene/ephemeris/sample_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/ephemeris/polynomial_weights.hpp"
#include "scene/ephemeris/state_consistency.hpp"

namespace sarsim::scene {

namespace {

using core::Vec3;

constexpr std::size_t highest_order = 16;
constexpr std::size_t reach = 8;  // differences on either side that are compared
constexpr std::size_t max_examined = 20'000;

}  // namespace

// Divided difference of some samples, in units of noise.
Vec3 SampleNoise::difference(std::size_t first, std::size_t order) const {
  const std::span<const double> time_s = time_s_.subspan(first, order + 1);
  const double unit_s = (time_s.back() - time_s.front()) / static_cast<double>(order);
  Vec3 sum;
  double squares = 0.0;
  for (std::size_t k = 0; k <= order; ++k) {
    double weight = 1.0;
    for (std::size_t j = 0; j <= order; ++j)
      if (j != k) weight *= unit_s / (time_s[k] - time_s[j]);
    sum = sum + weight * (values_[first + k] - values_[first]);
    squares += weight * weight;
  }
  return (1.0 / std::sqrt(squares)) * sum;
}

double SampleNoise::size(std::size_t sample, std::size_t order) const {
  const std::size_t half = order / 2;
  return core::norm(difference(std::min(sample > half ? sample - half : 0, time_s_.size() - order - 1), order));
}

// As many neighbouring differences as are compared, and are there: the first and the last of them.
std::pair<std::size_t, std::size_t> SampleNoise::neighbours(std::size_t sample, std::size_t order) const {
  const std::size_t max_first = time_s_.size() - order - 1;
  const std::size_t before = reach + order / 2;
  const std::size_t first =
      std::min(sample > before ? sample - before : 0, max_first > 2 * reach ? max_first - 2 * reach : 0);
  return {first, std::min(first + 2 * reach, max_first)};
}

bool SampleNoise::is_by_turns(std::size_t sample) const {
  constexpr std::size_t fewest = 3;
  constexpr double share = 0.1;
  if (time_s_.size() < 2 * fewest + fewest) return false;
  const std::size_t order = std::min(highest_order, time_s_.size() - fewest) / 2 * 2;
  const auto [first, last] = neighbours(sample, order);
  Vec3 before = difference(first, order);
  for (std::size_t i = first + 1; i <= last; ++i) {
    const Vec3 now = difference(i, order);
    if (!(core::norm(before + now) < share * core::norm(now))) return false;
    before = now;
  }
  return last >= first + fewest - 1;
}

// Root mean square.
double SampleNoise::mean_size(std::size_t sample, std::size_t order) const {
  const auto [first, last] = neighbours(sample, order);
  double squares = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const Vec3 one = difference(i, order);
    squares += core::dot(one, one);
  }
  return std::sqrt(squares / static_cast<double>(last - first + 1));
}

std::optional<std::size_t> SampleNoise::order_around(std::size_t sample) const {
  constexpr double falls = 0.8;
  double before = 0.0;
  for (std::size_t order = 2; order <= highest_order && order < time_s_.size(); order += 2) {
    const double size = mean_size(sample, order);
    if (order > 2 && size >= falls * before) return size < before ? order : order - 2;
    before = size;
  }
  return std::nullopt;
}

StateNoises::StateNoises(const radar::StateView& states) : states_(states) {
  const std::size_t count = states.time_s.size();
  is_odd_.assign(count, 0);
  odd_.resize(count);
  if (count <= max_examined)
    for (const ephemeris::OddState& odd : ephemeris::examine_states(states).odd) {
      is_odd_[odd.index] = 1;
      odd_[odd.index] = {odd.position_off_m, odd.velocity_off_mps};
    }
  sound_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    sound_[i] = std::min(time_s_.size(), count - 1);
    if (is_odd_[i] != 0) continue;
    time_s_.push_back(states.time_s[i]);
    position_m_.push_back(states.position_m[i]);
    if (!states.velocity_mps.empty()) velocity_mps_.push_back(states.velocity_mps[i]);
  }
}

// Velocities tell a motion that is fast between two states from noise: polynomials through more and more states with
// theirs differ by less and less, as far as it is the motion that they differ by. Divided by the root of the sum of the
// squares of their weights, no difference is smaller than the noise of one state.
StateNoises::Limits StateNoises::limits(std::size_t sound) const {
  constexpr std::size_t most = 8, beside = 1;
  constexpr double tolerance = 2.0;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::size_t count = time_s_.size();
  if (velocity_mps_.empty() || count < 3) return {infinite, infinite};
  const radar::StateView view{time_s_, position_m_, velocity_mps_};
  const std::size_t first = std::min(sound > beside ? sound - beside : 0, count - 2);
  const std::size_t last = std::min(sound + beside, count - 2);
  std::array<double, most> squares{}, of_position{}, of_velocity{};  // by states of the polynomial with more of them
  RepeatedWeights repeated;
  for (std::size_t left = first; left <= last; ++left) {
    const std::vector<std::size_t> order = radar::neighbours_of(left, 0, count, most);
    const double time_s = 0.7 * time_s_[left] + 0.3 * time_s_[left + 1];
    std::array<radar::OrbitState, most> sums;
    radar::polynomial_sums(view, order, time_s, std::span(sums).first(order.size()));
    const PolynomialWeights& weights = repeated.at(view, order, time_s);
    for (std::size_t k = 1; k < order.size(); ++k) {
      squares[k] += std::pow(core::norm(sums[k].position_m - sums[k - 1].position_m), 2);
      for (std::size_t j = 0; j < order.size(); ++j) {
        const std::size_t with = k * order.size() + j, without = with - order.size();
        of_position[k] += std::pow(weights.of_position[with] - weights.of_position[without], 2);
        of_velocity[k] += std::pow(weights.of_velocity[with] - weights.of_velocity[without], 2);
      }
    }
  }
  Limits limit{infinite, infinite};
  for (std::size_t k = 1; k < most && squares[k] + of_position[k] > 0.0; ++k) {
    limit.position_m = std::min(limit.position_m, tolerance * std::sqrt(squares[k] / of_position[k]));
    limit.velocity_mps = std::min(limit.velocity_mps, tolerance * std::sqrt(squares[k] / of_velocity[k]));
  }
  return limit;
}

std::vector<StateNoise> StateNoises::around(std::size_t left, std::span<const std::size_t> states) const {
  const std::size_t middle = std::min(sound_[left], time_s_.empty() ? 0 : time_s_.size() - 1);
  const SampleNoise positions(time_s_, position_m_);
  const SampleNoise velocities(time_s_, velocity_mps_);
  const auto of_positions = positions.order_around(middle);
  const auto of_velocities = velocity_mps_.empty() ? std::nullopt : velocities.order_around(middle);
  Limits limit = of_positions || of_velocities ? limits(middle) : Limits{};
  // With velocities these would be a vibration of one turn for two states, which polynomials follow.
  if (of_positions && positions.is_by_turns(middle)) limit.position_m = std::numeric_limits<double>::infinity();
  std::vector<StateNoise> noises;
  for (const std::size_t i : states) {
    if (is_odd_[i] != 0) {
      noises.push_back(odd_[i]);
      continue;
    }
    StateNoise one;
    if (of_positions) one.position_m = positions.size(sound_[i], *of_positions);
    if (of_velocities) one.velocity_mps = velocities.size(sound_[i], *of_velocities);
    one.position_m = std::min(one.position_m, limit.position_m);
    one.velocity_mps = std::min(one.velocity_mps, limit.velocity_mps);
    noises.push_back(one);
  }
  return noises;
}

}  // namespace sarsim::scene
