#pragma once

#include <variant>

#include "radar/orbit/orbit_state.hpp"
#include "radar/orbit/sgp4_elements.hpp"

namespace sarsim::radar {

/// The state of an orbit in TEME: adds the periodic terms of the Earth's harmonics J2 and J3 to mean elements and
/// solves Kepler's equation. Otherwise says why there is none.
/// @param mean  elements at the time, with the terms of drag, Sun, Moon and resonance
[[nodiscard]] std::variant<OrbitState, const char*> sgp4_state(const Sgp4Elements& mean);

}  // namespace sarsim::radar
