#pragma once

#include <cstddef>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// A warning if the interpolation error between the states of a platform's file, as `read_motions` found it for the
/// times of the recordings, exceeds a sixteenth of the wavelength of a radar that depends on it (`scene::looks_of`).
[[nodiscard]] core::Problems problems_between_states(const scene::Scene& scene, std::size_t platform);

/// The same for attitudes, which point the beam and move what is away from the origin of the platform: a sixteenth of
/// the beamwidth, or a displacement of a sixteenth of a wavelength.
[[nodiscard]] core::Problems problems_between_attitudes(const scene::Scene& scene, std::size_t platform);

}  // namespace sarsim::workflow
