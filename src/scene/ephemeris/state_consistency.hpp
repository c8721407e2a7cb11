#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "radar/orbit/state_polynomial.hpp"

namespace sarsim::scene::ephemeris {

/// A state that does not fit those around it, which fit each other.
struct OddState {
  std::size_t index = 0;
  double position_off_m = 0.0;    ///< From where those around it lead.
  double velocity_off_mps = 0.0;  ///< The same; 0 without velocities.
};

/// Velocities that are not those of the positions, in most states.
struct VelocityMismatch {
  std::size_t worst = 0;
  double off_mps = 0.0;    ///< Of that state.
  double given_mps = 0.0;  ///< Its speed,
  double moved_mps = 0.0;  ///< and that of the positions around it.
};

/// A step that is much longer than the others.
struct SampleGap {
  std::size_t before = 0;  ///< State in front of it.
  double length_s = 0.0;
};

/// The steps from sample to sample.
struct SampleSteps {
  std::vector<SampleGap> gaps;
  double usual_s = 0.0;  ///< The median; 0 for fewer than 3 samples.
};

/// A gap is a step of 1.9 times the usual one where 8 of 10 steps are equal, else of 4 times the median and 3 times
/// what nine of ten do not exceed.
/// @param time_s  ascending
[[nodiscard]] SampleSteps steps_of(std::span<const double> time_s);

/// What contradicts itself in states of one motion.
struct StateFindings {
  std::vector<OddState> odd;  ///< By index; at most 20.
  std::optional<VelocityMismatch> velocities;
  SampleSteps steps;
};

/// Compares each state with what its neighbours predict.
///
/// A state is odd where it is off the polynomials through the states around it (up to 6 with velocities, else 8) by
/// more than 5 times what polynomials of different orders differ, 8 times the median of all states and 5 mm, or by as
/// much as a wrong velocity moves the path within a step, and where without it, or without up to three in a row, all
/// states around fit again. So neither wide spacing, noise, nor a turn that begins between two states makes a state
/// odd. Where no such run is found, as at a jump, the worst of them is. Velocities do not fit where they
/// differ from the slope of polynomials through the positions alone in one direction from state to state, by 1e-3 of
/// the speed and 5 mm within an eighth of a step on the average.
///
/// Vehicles bend their paths between two samples; below 3 km/s a state is odd only where that would take more than 1 g,
/// and one of the first or last three where it is off by 5 steps of the way.
///
/// Time is linear; states beyond the first million are not compared.
[[nodiscard]] StateFindings examine_states(const radar::StateView& states);

}  // namespace sarsim::scene::ephemeris
