#include "scene/ephemeris/sample_noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/ephemeris/state_consistency.hpp"

namespace sarsim::scene {

namespace {

using core::Vec3;

constexpr std::size_t highest_order = 16;
constexpr std::size_t reach = 8;  // differences on either side that are compared
constexpr std::size_t most_examined = 20'000;

}  // namespace

// Divided difference of some samples, in units of noise.
double SampleNoise::difference(std::size_t first, std::size_t order) const {
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
  return core::norm(sum) / std::sqrt(squares);
}

double SampleNoise::size(std::size_t sample, std::size_t order) const {
  const std::size_t half = order / 2;
  return difference(std::min(sample > half ? sample - half : 0, time_s_.size() - order - 1), order);
}

// Root mean square, of as many neighbouring differences as there are.
double SampleNoise::mean_size(std::size_t sample, std::size_t order) const {
  const std::size_t most_first = time_s_.size() - order - 1;
  const std::size_t before = reach + order / 2;
  const std::size_t first =
      std::min(sample > before ? sample - before : 0, most_first > 2 * reach ? most_first - 2 * reach : 0);
  const std::size_t last = std::min(first + 2 * reach, most_first);
  double squares = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double one = difference(i, order);
    squares += one * one;
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
  if (count <= most_examined)
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

// Velocities tell a motion that is fast between two states from noise: with them, predictions of a state by the four,
// six and eight around it get better from order to order. States that are off by turns look half like such a motion,
// and pass the limits.
StateNoises::Limits StateNoises::limits(std::size_t sound) const {
  constexpr std::size_t side = 4, beside = 2;
  constexpr double tolerance = 2.0, slow = 0.3;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (velocity_mps_.empty() || time_s_.size() <= 2 * side) return {infinite, 1.0};
  const radar::StateView view{time_s_, position_m_, velocity_mps_};
  const std::size_t most_first = time_s_.size() - side - 1;
  const std::size_t first = std::clamp(sound > beside ? sound - beside : 0, side, most_first);
  const std::size_t last = std::clamp(sound + beside + 1, first, most_first);
  std::array<double, side + 1> positions{}, velocities{};  // squares, by states on either side
  for (std::size_t i = first; i <= last; ++i) {
    const std::array<std::size_t, 2 * side> others{i - 1, i + 1, i - 2, i + 2, i - 3, i + 3, i - 4, i + 4};
    std::array<radar::OrbitState, 2 * side> sums;
    radar::polynomial_sums(view, others, time_s_[i], sums);
    for (std::size_t k = 2; k <= side; ++k) {
      positions[k] += std::pow(core::norm(position_m_[i] - sums[2 * k - 1].position_m), 2);
      velocities[k] += std::pow(core::norm(velocity_mps_[i] - sums[2 * k - 1].velocity_mps), 2);
    }
  }
  const auto share = [&](const std::array<double, side + 1>& squares) {
    const double falls = std::sqrt(std::max(squares[3] / squares[2], squares[4] / squares[3]));
    return falls < slow ? 0.0 : 1.0;
  };
  const double off_m = std::sqrt(positions[3] / static_cast<double>(last - first + 1));
  return {tolerance * off_m * share(positions), share(velocities)};
}

std::vector<StateNoise> StateNoises::around(std::size_t left, std::span<const std::size_t> states) const {
  const std::size_t middle = std::min(sound_[left], time_s_.empty() ? 0 : time_s_.size() - 1);
  const SampleNoise positions(time_s_, position_m_);
  const SampleNoise velocities(time_s_, velocity_mps_);
  const auto of_positions = positions.order_around(middle);
  const auto of_velocities = velocity_mps_.empty() ? std::nullopt : velocities.order_around(middle);
  const Limits limit = of_positions || of_velocities ? limits(middle) : Limits{};
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
    one.velocity_mps *= limit.velocity_share;
    noises.push_back(one);
  }
  return noises;
}

}  // namespace sarsim::scene
