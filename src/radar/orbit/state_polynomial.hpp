#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/orbit/orbit_state.hpp"

namespace sarsim::radar {

/// View of the states of a motion in any frame that is the same for all; nothing is copied.
struct StateView {
  std::span<const double> time_s;  ///< Ascending.
  std::span<const core::Vec3> position_m;
  std::span<const core::Vec3> velocity_mps;  ///< Empty: positions alone.
};

/// Most states that a polynomial goes through.
inline constexpr std::size_t max_polynomial_states = 20;

/// Values at one time of the polynomials through the first, the first two, ... of some states: Newton's form gives all
/// of them in one pass. With velocities each polynomial matches positions and velocities of its states (Hermite),
/// otherwise positions (Lagrange). Positions are taken relative to the first of the states, so that rounding is that of
/// their differences.
/// @param through  indices of states, all different, 1 to `max_polynomial_states`, in the order of adding
/// @param time_s   in the time of `states`
/// @param sums     as many as `through`; sums[k] becomes position [m] and velocity [m/s] at `time_s` of the polynomial
///                 through the first k + 1
void polynomial_sums(const StateView& states, std::span<const std::size_t> through, double time_s,
                     std::span<OrbitState> sums);

/// Indices within [begin, end), from near to far of the interval that begins at `left`: left, left + 1, left - 1,
/// left + 2, ...; if one side is used up, those of the other. At most `count`.
[[nodiscard]] std::vector<std::size_t> neighbours_of(std::size_t left, std::size_t begin, std::size_t end,
                                                     std::size_t count);

}  // namespace sarsim::radar
