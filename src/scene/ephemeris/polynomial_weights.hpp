#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radar/orbit/state_polynomial.hpp"

namespace sarsim::scene {

/// How much the states count at one time in the polynomials of `radar::polynomial_sums`: the position of the polynomial
/// through the first k + 1 states is the sum of positions times `of_position` and velocities times `of_velocity`.
struct PolynomialWeights {
  std::size_t states = 0;
  std::vector<double> of_position;  ///< [k * states + j], of state j of `through`.
  std::vector<double> of_velocity;  ///< The same, s; empty without velocities.
};

/// The weights at a time.
/// @param states   the motion; only its times count, and whether it has velocities
/// @param through  as `radar::polynomial_sums` takes it
[[nodiscard]] PolynomialWeights polynomial_weights(const radar::StateView& states, std::span<const std::size_t> through,
                                                   double time_s);

/// Weights of one place within intervals, kept from interval to interval as long as the states are spaced alike.
class RepeatedWeights {
 public:
  /// The same as `polynomial_weights`, to 1e-6 of the weights. The result is good until the next call.
  const PolynomialWeights& at(const radar::StateView& states, std::span<const std::size_t> through, double time_s);

 private:
  std::vector<double> offset_s_;  // of the states from the time
  PolynomialWeights weights_;
};

}  // namespace sarsim::scene
