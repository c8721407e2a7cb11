#pragma once

#include <span>
#include <vector>

#include "radar/orbit/kepler.hpp"
#include "radar/orbit/orbit_state.hpp"

namespace sarsim::radar {

/// Where a satellite is at some times, if it moves from a state under the Earth as point mass and J2 alone, with all of
/// its periodic terms. Left out are the higher terms of the field, drag, Sun and Moon, 4e-4 m/s^2 at most on a low
/// orbit: from a measured state of Sentinel-1 it is off by 7 mm after 10 s, 0.7 m after 100 s and 1.5 km after a turn.
/// Frame: z to the north pole, not turning.
///
/// The equation of motion is integrated in steps of at most 1 s by the fourth-order method of Runge and Kutta: 2e-6 m
/// after one turn of a low orbit. Costs 0.3 us for each second.
/// @param start    state at time 0; away from the centre of the Earth
/// @param times_s  ascending, before and behind time 0 as they like
[[nodiscard]] std::vector<OrbitState> states_under_j2(const OrbitState& start, std::span<const double> times_s,
                                                      const EarthGravity& gravity = {});

}  // namespace sarsim::radar
