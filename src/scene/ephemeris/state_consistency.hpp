#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radar/orbit/state_polynomial.hpp"

namespace sarsim::scene::ephemeris {

/// A state that does not fit its neighbours, which fit each other.
struct OddState {
  std::size_t index = 0;
  double position_off_m = 0.0;    ///< Distance from the position that its neighbours predict.
  double velocity_off_mps = 0.0;  ///< The same for the velocity; 0 without velocities.
};

/// Velocities that are not the derivatives of the positions, in most states.
struct VelocityMismatch {
  std::size_t worst = 0;   ///< Index of the state with the largest difference.
  double off_mps = 0.0;    ///< Its difference.
  double given_mps = 0.0;  ///< Its speed in the file.
  double moved_mps = 0.0;  ///< Its speed from the positions around it.
};

/// A step that is much longer than the others.
struct SampleGap {
  std::size_t before = 0;  ///< Index of the sample before it.
  double length_s = 0.0;
};

/// The steps from sample to sample.
struct SampleSteps {
  std::vector<SampleGap> gaps;
  double usual_s = 0.0;  ///< The median; 0 for fewer than 3 samples.
};

/// A gap is a step of more than 1.9 times the usual one if 8 of 10 steps are equal to 1 %, otherwise of more than 4
/// times the median and 3 times the ninth decile.
/// @param time_s  ascending
[[nodiscard]] SampleSteps steps_of(std::span<const double> time_s);

/// Contradictions within the states of one motion.
struct StateFindings {
  std::vector<OddState> odd;  ///< By index; at most 20.
  std::optional<VelocityMismatch> velocities;
  SampleSteps steps;
};

/// Compares each state with what its neighbours predict.
///
/// A state is odd if its distance from the polynomials through its neighbours (up to 6 with velocities, otherwise 8)
/// exceeds the sum of 5 times the difference of polynomials of successive orders, 8 times the median distance of all
/// states and 5 mm (the same for the displacement that a wrong velocity causes within a quarter of a step), and if
/// without it, or without up to three in a row, all states around fit again. So neither wide spacing, nor noise, nor a
/// turn that begins between two states makes a state odd. If no such run exists, as at a jump, the worst state is odd.
/// Velocities do not fit if they differ from the slope of polynomials through the positions alone in the same direction
/// from state to state, in most states by 1e-3 of the speed and on average by 5 mm within an eighth of a step.
///
/// Vehicles manoeuvre between two samples: below 3 km/s a state is odd only if that would need more than 10 m/s^2, and
/// one of the first or last three only if it is off by 5 times the distance between samples.
///
/// Time is linear; states beyond the first million are not compared.
[[nodiscard]] StateFindings examine_states(const radar::StateView& states);

}  // namespace sarsim::scene::ephemeris
