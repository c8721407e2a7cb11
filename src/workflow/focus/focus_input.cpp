#include "workflow/focus/focus_input.hpp"

#include <algorithm>

#include "core/report/refused.hpp"
#include "workflow/focus/sar_rows.hpp"

namespace sarsim::workflow {

namespace {

FocusInput of_script(const RecordingArguments& arguments, const core::WorkControl& control) {
  auto [input, simulation] = open_script(arguments, records_pulses, control);
  FocusInput focus;
  focus.simulation = simulation;
  const simulate::Plan window = simulate::make_plan(input.scene, simulation, input.resolved);
  focus.problems = std::move(input.problems);
  std::ranges::move(problems_of_sar(window, false), std::back_inserter(focus.problems));
  if (core::has_errors(focus.problems)) throw core::Refused(core::ranked(std::move(focus.problems)));
  scene::Simulation& recorded = input.scene.simulations[simulation];
  recorded = recorded_for_sar(recorded, window);
  focus.plan = std::make_shared<const simulate::Plan>(
      simulate::make_plan(input.scene, simulation, input.resolved, simulate::Engine::automatic));
  focus.echoes = sar_rows_of_scene(focus.plan, window.columns);
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

FocusInput open_focus_input(const RecordingArguments& arguments, const core::WorkControl& control) {
  FocusInput focus = names_script(arguments) ? of_script(arguments, control) : of_file(arguments);
  focus.problems = core::ranked(std::move(focus.problems));
  return focus;
}

}  // namespace sarsim::workflow
