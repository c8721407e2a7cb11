#pragma once

#include <memory>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::workflow {

/// A recording that may not be stored in the scene, planned as a run would plan it, or why it cannot be run.
struct PlannedRecording {
  core::Problems problems;  ///< Errors only; with any of them there is no plan.
  std::shared_ptr<const simulate::Plan> plan;
};

/// Checks and plans a recording of a scene; the simulations and geometry tables that the scene stores do not matter.
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] PlannedRecording plan_recording(const scene::Scene& scene, const scene::Simulation& simulation,
                                              const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow
