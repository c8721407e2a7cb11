#pragma once

#include <optional>

#include "radar/orbit/kepler.hpp"
#include "radar/orbit/orbit_state.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Whether a platform's path is an orbit: Path::ephemeris, orbit or state. It is a path in the world, for which states
/// are computed or read (`Platform::read_path`).
[[nodiscard]] bool is_orbit(Platform::Path path);

/// The mean elements of Path::orbit, over the Earth as it lies at time 0; nothing where they are no ellipse.
[[nodiscard]] std::optional<radar::KeplerElements> elements_of(const Platform& platform);

/// The state of Path::state at time 0, as seen from axes that do not turn and agree with the Earth's then.
[[nodiscard]] radar::OrbitState inertial_state_of(const Platform& platform);

/// Gives a platform whose path became an orbit by a state, or one by elements, what the other had: at time 0 it is
/// where it was and moves as it did, to 1 mm and 1 um/s. Nothing happens where the other said no orbit.
void continue_orbit(const Platform& before, Platform& after);

}  // namespace sarsim::scene
