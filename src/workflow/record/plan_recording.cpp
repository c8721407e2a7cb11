#include "workflow/record/plan_recording.hpp"

#include <utility>

#include "scene/check/check.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::workflow {

PlannedRecording plan_recording(const scene::Scene& scene, const scene::Simulation& simulation,
                                const core::StopFlag* stop) {
  scene::Scene one = scene;
  one.simulations = {simulation};
  one.geometries.clear();
  PlannedRecording planned;
  planned.problems = scene::check(one);
  std::erase_if(planned.problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
  if (!planned.problems.empty()) return planned;
  simulate::Plan plan = simulate::make_plan(one, 0, nullptr, simulate::Engine::automatic, stop);
  if (plan.acquisition.timing.rows == 0) {
    planned.problems.push_back(core::error("no complete burst is sent within the azimuth window"));
    return planned;
  }
  planned.plan = std::make_shared<const simulate::Plan>(std::move(plan));
  return planned;
}

}  // namespace sarsim::workflow
