#include "scene/ephemeris/polynomial_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sarsim::scene {

namespace {

using core::Vec3;

double part_of(const Vec3& v, std::size_t part) { return part == 0 ? v.x : part == 1 ? v.y : v.z; }

Vec3 unit_vector(std::size_t part) { return {part == 0 ? 1.0 : 0.0, part == 1 ? 1.0 : 0.0, part == 2 ? 1.0 : 0.0}; }

// Motions of which one state in each direction is at 1 and all others are at rest at 0.
class UnitMotions {
 public:
  UnitMotions(const radar::StateView& states, std::span<const std::size_t> through)
      : has_velocities_(!states.velocity_mps.empty()), sorted_(through.begin(), through.end()) {
    std::ranges::sort(sorted_);
    for (const std::size_t i : sorted_) time_s_.push_back(states.time_s[i]);
    for (const std::size_t i : through)
      order_.push_back(static_cast<std::size_t>(std::ranges::lower_bound(sorted_, i) - sorted_.begin()));
    none_.resize(order_.size());
  }

  [[nodiscard]] std::vector<double> weights(bool of_velocities, double time_s) const {
    const std::size_t count = order_.size();
    std::vector<double> weights(count * count);
    std::array<radar::OrbitState, radar::max_polynomial_states> sums;
    for (std::size_t first = 0; first < count; first += 3) {
      std::vector<Vec3> units(count);
      const std::size_t some = std::min<std::size_t>(3, count - first);
      for (std::size_t part = 0; part < some; ++part) units[order_[first + part]] = unit_vector(part);
      const auto& position_m = of_velocities ? none_ : units;
      const auto& velocity_mps = of_velocities ? units : none_;
      radar::StateView view{time_s_, position_m, {}};
      if (has_velocities_) view.velocity_mps = velocity_mps;
      radar::polynomial_sums(view, order_, time_s, std::span(sums).first(count));
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t part = 0; part < some; ++part)
          weights[k * count + first + part] = part_of(sums[k].position_m, part);
    }
    return weights;
  }

 private:
  bool has_velocities_;
  std::vector<std::size_t> sorted_;
  std::vector<std::size_t> order_;
  std::vector<double> time_s_;
  std::vector<Vec3> none_;
};

}  // namespace

PolynomialWeights polynomial_weights(const radar::StateView& states, std::span<const std::size_t> through,
                                     double time_s) {
  const UnitMotions motions(states, through);
  PolynomialWeights weights{through.size(), motions.weights(false, time_s), {}};
  if (!states.velocity_mps.empty()) weights.of_velocity = motions.weights(true, time_s);
  return weights;
}

const PolynomialWeights& RepeatedWeights::at(const radar::StateView& states, std::span<const std::size_t> through,
                                             double time_s) {
  std::vector<double> offset_s;
  offset_s.reserve(through.size());
  double longest_s = 0.0;
  for (const std::size_t i : through) {
    offset_s.push_back(states.time_s[i] - time_s);
    longest_s = std::max(longest_s, std::abs(offset_s.back()));
  }
  const auto alike = [longest_s](double a, double b) { return std::abs(a - b) < 1e-8 * longest_s; };
  if (!std::ranges::equal(offset_s, offset_s_, alike)) weights_ = polynomial_weights(states, through, time_s);
  offset_s_ = std::move(offset_s);
  return weights_;
}

}  // namespace sarsim::scene
