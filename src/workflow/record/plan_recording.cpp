#include "workflow/record/plan_recording.hpp"

#include <utility>

#include "scene/check/check.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim {

PlannedRecording plan_recording(const Scene& scene, const Simulation& simulation, const StopFlag* stop) {
  Scene one = scene;
  one.simulations = {simulation};
  one.geometries.clear();
  PlannedRecording planned;
  planned.problems = check(one);
  std::erase_if(planned.problems, [](const Problem& p) { return p.severity != Severity::error; });
  if (!planned.problems.empty()) return planned;
  Plan plan = make_plan(one, 0, nullptr, Engine::automatic, stop);
  if (plan.rows == 0) {
    Problem none;
    none.message = "no complete burst leaves within the azimuth window";
    planned.problems.push_back(std::move(none));
    return planned;
  }
  planned.plan = std::make_shared<const Plan>(std::move(plan));
  return planned;
}

}  // namespace sarsim
