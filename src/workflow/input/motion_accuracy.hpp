#pragma once

#include <cstddef>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// A warning where what is lost between the states of a platform's file exceeds a sixteenth of the wavelength of a
/// radar that it matters to (`scene::looks_of`): what `read_motions` found, by the times of the recordings.
[[nodiscard]] core::Problems problems_between_states(const scene::Scene& scene, std::size_t platform);

/// The same of attitudes, which point the beam and move what is away from the origin of the platform: a sixteenth of
/// the beam's width, or of a wavelength there.
[[nodiscard]] core::Problems problems_between_attitudes(const scene::Scene& scene, std::size_t platform);

}  // namespace sarsim::workflow
