#include "workflow/stepped/stepped_input.hpp"

#include <algorithm>

#include "core/report/invalid_request.hpp"
#include "scene/check/check.hpp"

namespace sarsim::workflow {

namespace {

SteppedInput of_script(const RecordingArguments& arguments, SteppedUse use, const core::WorkControl& control) {
  auto [input, number] = open_script(arguments, suits_use(use), control);
  SteppedInput stepped = stepped_input_of(input.scene, number, input.resolved, use);
  // What `check` says of SRP does not concern bursts that are cut here.
  std::erase_if(input.problems, [](const core::Problem& p) { return p.subject.field == "processing"; });
  core::append(stepped.problems, std::move(input.problems));
  stepped.sources = std::move(input.sources);
  if (core::has_errors(stepped.problems)) throw core::InvalidRequest(core::ranked(std::move(stepped.problems)));
  return stepped;
}

SteppedInput of_file(const RecordingArguments& arguments, SteppedUse use, const core::WorkControl& control) {
  StoredRecording stored = open_recording(
      arguments, suits_use(use),
      [use](const simulate::Acquisition& acquisition) { return problems_of_stepped(acquisition, use, true); }, control);
  return {stepped_rows_of_recording(stored.acquisition, stored.rows), stored.simulation, std::move(stored.problems),
          std::move(stored.sources), std::move(stored.file)};
}

// @param window  the plan of the simulation, raw
SteppedInput input_in(scene::Scene& scene, std::size_t number, const simulate::Acquisition& window, SteppedUse use) {
  SteppedInput stepped;
  stepped.simulation = number;
  scene::Simulation& simulation = scene.simulations[number];
  stepped.problems = problems_of_stepped(window, use, false);
  if (core::has_errors(stepped.problems)) return stepped;
  simulation = recorded_for_stepped(simulation, window);
  const auto acquisition =
      std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, number, window.scene));
  stepped.rows = stepped_rows_of_scene(acquisition, window);
  return stepped;
}

}  // namespace

Suits suits_use(SteppedUse use) {
  return [use](const scene::Scene& scene, const scene::Simulation& simulation) {
    const std::size_t index = scene::find_radar(scene, simulation.radar);
    if (index == scene::not_found) return false;
    const scene::Radar& radar = scene.radars[index];
    if (radar.carrier == scene::Radar::Carrier::stepped && radar.carrier_steps > 1) return true;
    return use == SteppedUse::isar && radar.pulse != scene::Radar::Pulse::mono &&
           radar.carrier == scene::Radar::Carrier::single;
  };
}

SteppedInput stepped_input_of(scene::Scene& scene, std::size_t number,
                              const std::shared_ptr<const simulate::ResolvedScene>& resolved, SteppedUse use) {
  scene.simulations[number].processing = scene::Processing::raw;
  return input_in(scene, number, simulate::acquisition_of(scene, number, resolved), use);
}

SteppedInput stepped_input_of(scene::Scene& scene, std::size_t number, const simulate::Acquisition& planned,
                              SteppedUse use) {
  if (!planned.reception.is_raw()) return stepped_input_of(scene, number, planned.scene, use);
  return input_in(scene, number, planned, use);
}

SteppedInput open_stepped_input(const RecordingArguments& arguments, SteppedUse use, const core::WorkControl& control) {
  SteppedInput stepped =
      names_script(arguments) ? of_script(arguments, use, control) : of_file(arguments, use, control);
  stepped.problems = core::ranked(std::move(stepped.problems));
  return stepped;
}

}  // namespace sarsim::workflow
