#include "workflow/record/prepared_recording.hpp"

#include <utility>

#include "core/os/disk_room.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "raster/table/formats.hpp"
#include "scene/language/recorded_text.hpp"
#include "simulate/resolve/impossible_echo.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/known_machine.hpp"
#include "workflow/record/record_size.hpp"
#include "workflow/record/recording.hpp"

namespace sarsim::workflow {

namespace {

// The scene with this recording alone: problems of others are of no interest.
scene::Scene with_only(const scene::Scene& scene, std::size_t simulation) {
  scene::Scene one = scene;
  one.simulations = {scene.simulations.at(simulation)};
  one.geometries.clear();
  return one;
}

RecordingEstimate estimate_of(const simulate::Plan& plan, double bytes, bool counts, const core::StopFlag* stop) {
  const unsigned threads = core::thread_count(0);
  const simulate::Cost cost = simulate::estimated_cost(plan, threads, known_machine(stop));
  return {plan.acquisition.timing.rows, plan.acquisition.reception.columns, bytes,
          cost.seconds * passes_of(plan.acquisition.simulation, counts), cost.memory_bytes};
}

}  // namespace

PreparedRecording prepare_recording(const scene::Scene& scene, std::size_t simulation, std::filesystem::path file,
                                    raster::SinkOptions options, const core::StopFlag* stop) {
  const core::WorkControl control{core::thread_count(0), stop};
  SceneInput input = take_scene(with_only(scene, simulation), {}, {}, CheckLevel::echoes, control);
  expect_usable(input);
  resolve_once(input, control);
  PreparedRecording prepared{
      .plan = simulate::make_plan(scene, simulation, input.resolved, simulate::Engine::automatic, stop),
      .file = std::move(file),
      .options = options,
      .script = {},
      .estimate = {},
      .problems = std::move(input.problems)};
  const scene::FileFormat format = prepared.plan.acquisition.simulation.format;
  prepared.options.format = format;
  if (raster::format_of(format).carries_script) prepared.script = scene::recorded_text(scene);
  const raster::Product product = simulate::product_of(prepared.plan, prepared.script);
  prepared.estimate =
      estimate_of(prepared.plan, raster::expected_bytes(product, prepared.options), prepared.options.counts, stop);
  return prepared;
}

RecordingReport make_recording(const PreparedRecording& prepared, const core::Observer& observer) try {
  const std::filesystem::path folder = std::filesystem::absolute(prepared.file).parent_path();
  core::expect_room(folder, raster::min_bytes(prepared.options.format, prepared.estimate.bytes),
                    "or choose another folder");
  return make_recording({prepared.plan, prepared.file, prepared.options, prepared.script}, 0, observer);
} catch (const simulate::ImpossibleEcho& error) {
  throw core::InvalidRequest({error.problem});
}

}  // namespace sarsim::workflow
