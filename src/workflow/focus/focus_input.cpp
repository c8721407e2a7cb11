#include "workflow/focus/focus_input.hpp"

#include <algorithm>

#include "core/report/refused.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

namespace {

FocusInput of_script(const RecordingArguments& arguments, const core::WorkControl& control) {
  auto [input, simulation] = open_script(arguments, records_pulses, control);
  FocusInput focus = focus_input_of(input.scene, simulation, input.resolved);
  std::ranges::move(input.problems, std::back_inserter(focus.problems));
  if (core::has_errors(focus.problems)) throw core::Refused(core::ranked(std::move(focus.problems)));
  return focus;
}

FocusInput of_file(const RecordingArguments& arguments) {
  StoredRecording stored =
      open_recording(arguments, records_pulses, [](const simulate::Plan& plan) { return problems_of_sar(plan, true); });
  FocusInput focus{stored.plan, {}, stored.simulation, std::move(stored.problems)};
  focus.echoes = sar_rows_of_recording(focus.plan, stored.rows);
  return focus;
}

}  // namespace

FocusInput focus_input_of(scene::Scene& scene, std::size_t simulation,
                          const std::shared_ptr<const simulate::ResolvedScene>& resolved) {
  FocusInput focus;
  focus.simulation = simulation;
  const simulate::Plan window = simulate::make_plan(scene, simulation, resolved);
  focus.problems = problems_of_sar(window, false);
  if (core::has_errors(focus.problems)) return focus;
  scene::Simulation& recorded = scene.simulations[simulation];
  recorded = recorded_for_sar(recorded, window);
  focus.plan = std::make_shared<const simulate::Plan>(
      simulate::make_plan(scene, simulation, resolved, simulate::Engine::automatic));
  focus.echoes = sar_rows_of_scene(focus.plan, window.columns);
  return focus;
}

FocusInput open_focus_input(const RecordingArguments& arguments, const core::WorkControl& control) {
  FocusInput focus = names_script(arguments) ? of_script(arguments, control) : of_file(arguments);
  focus.problems = core::ranked(std::move(focus.problems));
  return focus;
}

}  // namespace sarsim::workflow
