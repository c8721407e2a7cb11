#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "simulate/resolve/resolved.hpp"
#include "simulate/survey/target_visibility.hpp"

namespace sarsim::scene {
struct Scene;
}

namespace sarsim::simulate {

/// What `survey` finds, and what every simulation will hold.
struct SurveyReport {
  core::Problems problems;
  std::vector<EchoSummary> summaries;  ///< One for each simulation whose echoes can be computed.
};

/// Warnings and errors that need the echoes of every simulation in the scene: all echoes outside the window (and where
/// they are), PRF below the Doppler band, LSB that clips or wastes more than half the range, targets whose echo is
/// impossible (at the radar's position, faster than light, too strong), echoes beyond the PRI, surfaces that show their
/// back or are filled too thinly for the wavelength, motion within a pulse that echoes leave out, a window function
/// without weight, no echo at all, targets behind the Earth, a beam that misses its targets, echoes below the noise,
/// echoes that the window cuts. The scene must have passed `check`.
/// @param resolved  what `resolve` gives for the scene; made where it is missing and needed
[[nodiscard]] core::Problems survey(const scene::Scene& scene, std::shared_ptr<const ResolvedScene> resolved = nullptr,
                                    const core::WorkControl& control = {});

/// Same, with what every simulation will hold.
[[nodiscard]] SurveyReport survey_report(const scene::Scene& scene,
                                         std::shared_ptr<const ResolvedScene> resolved = nullptr,
                                         const core::WorkControl& control = {});

}  // namespace sarsim::simulate
