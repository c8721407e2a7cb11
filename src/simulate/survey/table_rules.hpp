#pragma once

#include <span>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"
#include "simulate/survey/survey_echoes.hpp"
#include "simulate/survey/visibility_rules.hpp"

namespace sarsim::simulate {

/// Adds which targets, points of clouds and surfaces are seen at angles beyond the points of an antenna's cuts, or of
/// their own reflectivity, while the beam is on them: how many, at which angle, of which table, and what is taken
/// there. Besides the sights those count that reach farthest of all others (`reach_beyond_tables`).
void check_tables(const VisibilityCase& sighted, const EchoSurvey& survey, core::Problems& problems);

/// Differences of more than 0.1 dB between the profiles `classic` and `physical` in reading the functions of a scene:
/// cuts of antennas, reflectivities and gains of the receiver, for the targets in the survey. Notes, or warnings if
/// `classic` ignores half of a cut.
/// @param summaries  of the scene's simulations
[[nodiscard]] core::Problems differences_of_profiles(const scene::Scene& scene, std::span<const EchoSummary> summaries);

}  // namespace sarsim::simulate
