#include "cli/command/stepped_input.hpp"

#include <algorithm>

#include "scene/check/check.hpp"

namespace sarsim::cli {

namespace {

// Whether the radar of a simulation steps its carrier, or at least modulates its pulse.
Suits suits_use(SteppedUse use) {
  return [use](const Scene& scene, const Simulation& simulation) {
    const std::size_t index = find_radar(scene, simulation.radar);
    if (index == not_found) return false;
    const Radar& radar = scene.radars[index];
    if (radar.carrier == Radar::Carrier::stepped && radar.carrier_steps > 1) return true;
    return use == SteppedUse::isar && radar.pulse != Radar::Pulse::mono && radar.carrier == Radar::Carrier::single;
  };
}

SteppedInput of_script(const RecordingArguments& arguments, SteppedUse use, const WorkControl& control) {
  auto [input, number] = open_script(arguments, suits_use(use), control);
  SteppedInput stepped;
  stepped.simulation = number;
  Simulation& simulation = input.scene.simulations[number];
  // Bursts are cut here, and profiles made of sub-bands too: what `check` says of SRP does not concern them.
  simulation.processing = Processing::raw;
  const Plan window = make_plan(input.scene, number, input.resolved);
  stepped.problems = std::move(input.problems);
  stepped.sources = std::move(input.sources);
  std::erase_if(stepped.problems, [](const Problem& p) { return p.subject.field == "processing"; });
  std::ranges::move(problems_of_stepped(window, use, false), std::back_inserter(stepped.problems));
  if (has_errors(stepped.problems)) throw BadInput(ranked(std::move(stepped.problems)));
  simulation = recorded_for_stepped(simulation, window);
  const auto plan = std::make_shared<const Plan>(make_plan(input.scene, number, input.resolved, Engine::automatic));
  stepped.rows = stepped_rows_of_scene(plan, window);
  return stepped;
}

SteppedInput of_file(const RecordingArguments& arguments, SteppedUse use) {
  StoredRecording stored = open_recording(arguments, suits_use(use),
                                          [use](const Plan& plan) { return problems_of_stepped(plan, use, true); });
  return {stepped_rows_of_recording(stored.plan, stored.read), stored.simulation, std::move(stored.problems),
          std::move(stored.sources)};
}

}  // namespace

void add_stepped_input_arguments(CLI::App& app, RecordingArguments& arguments) {
  add_recording_arguments(app, arguments, "the first that suits");
  add_scene_overrides(app, arguments.overrides);
}

SteppedInput open_stepped_input(const RecordingArguments& arguments, SteppedUse use, const WorkControl& control) {
  SteppedInput stepped = names_script(arguments) ? of_script(arguments, use, control) : of_file(arguments, use);
  stepped.problems = ranked(std::move(stepped.problems));
  return stepped;
}

}  // namespace sarsim::cli
