#include "workflow/search/pulse_input.hpp"

#include "core/report/invalid_request.hpp"

namespace sarsim::workflow {

namespace {

// Synthetic range profiles have to be refused before they are planned as pulses.
void expect_pulses(const scene::Simulation& simulation) {
  if (simulation.processing == scene::Processing::srp)
    throw core::InvalidRequest("synthetic range profiles hold no pulses",
                               "take a recording of processing \"raw\" or \"matched-filter\"");
}

PulseInput of_script(const RecordingArguments& arguments, const core::WorkControl& control) {
  auto [input, number] = open_script(arguments, records_pulses, control);
  expect_pulses(input.scene.simulations[number]);
  const auto acquisition = acquisition_of_pulses(input.scene, number, input.resolved, control.stop);
  return {pulse_rows_of_scene(acquisition), number, std::move(input.problems), std::move(input.sources)};
}

PulseInput of_file(const RecordingArguments& arguments, const core::WorkControl& control) {
  const auto problems_of = [](const simulate::Acquisition& acquisition) {
    expect_pulses(acquisition.simulation);
    return core::Problems();
  };
  StoredRecording stored = open_recording(arguments, records_pulses, problems_of, control);
  return {pulse_rows_of_recording(stored.acquisition, stored.rows), stored.simulation, std::move(stored.problems),
          std::move(stored.sources)};
}

}  // namespace

std::shared_ptr<const simulate::Acquisition> acquisition_of_pulses(
    scene::Scene& scene, std::size_t number, const std::shared_ptr<const simulate::ResolvedScene>& resolved,
    const core::StopFlag* stop) {
  scene.simulations[number] = compressed_simulation(scene.simulations[number]);
  return std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, number, resolved, stop));
}

PulseInput open_pulse_input(const RecordingArguments& arguments, const core::WorkControl& control) {
  PulseInput input = names_script(arguments) ? of_script(arguments, control) : of_file(arguments, control);
  input.problems = core::ranked(std::move(input.problems));
  return input;
}

}  // namespace sarsim::workflow
