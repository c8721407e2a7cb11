#include "picture/live/live_workflows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/task/observer.hpp"
#include "picture/live/live_product_file.hpp"
#include "workflow/focus/focus.hpp"

namespace sarsim::picture {

namespace {

constexpr double max_doppler_pulses = 256.0;
constexpr const char* scene_name = "the scene";  // in messages

workflow::RecordingArguments held_arguments(scene::Scene scene, std::size_t simulation) {
  workflow::RecordingArguments arguments;
  arguments.path = scene_name;
  arguments.simulation = static_cast<std::int64_t>(simulation) + 1;
  auto held = std::make_shared<workflow::HeldScene>();
  held->input.scene = std::move(scene);
  arguments.held = std::move(held);
  return arguments;
}

}  // namespace

workflow::FocusRequest focus_request_of(const LiveOptions& options, unsigned threads) {
  workflow::FocusRequest request;
  request.input.path = scene_name;
  request.algorithm = options.algorithm;
  request.range_window = options.window;
  request.azimuth_window = options.window;
  if (!options.compensation && options.algorithm != workflow::FocusAlgorithm::back_projection)
    request.motion = workflow::MotionOrder::none;
  request.autofocus = options.autofocus;
  request.memory_bytes = 0;
  request.threads = threads;
  return request;
}

workflow::RecordingArguments arguments_of(const LiveRequest& request) {
  return held_arguments(*request.scene, request.simulation);
}

workflow::ProfilesRequest profiles_request_of(const LiveRequest& request) {
  workflow::ProfilesRequest profiles;
  profiles.input = arguments_of(request);
  if (request.options.window != signal::SarWindow{}) profiles.window = request.options.window;
  return profiles;
}

workflow::IsarRequest isar_request_of(const LiveRequest& request) {
  workflow::IsarRequest isar;
  isar.input = arguments_of(request);
  isar.options.range_window = request.options.window;
  isar.options.azimuth_window = request.options.window;
  return isar;
}

workflow::DopplerRequest doppler_request_of(const LiveRequest& request) {
  workflow::DopplerRequest doppler;
  doppler.detect = false;
  doppler.window = request.options.window;
  scene::Scene scene = *request.scene;
  scene::Simulation& recording = scene.simulations.at(request.simulation);
  const std::size_t number = scene::find_radar(scene, recording.radar);
  if (number != scene::not_found && scene.radars[number].repetition == scene::Radar::Repetition::constant &&
      scene.radars[number].prf_hz > 0.0) {
    const double prf_hz = scene.radars[number].prf_hz;
    // Pulses leave at whole intervals.
    const double first = std::ceil(recording.time_start_s * prf_hz - 1e-6);
    const double last = std::floor(recording.time_end_s * prf_hz + 1e-6);
    const double pulses = std::min(max_doppler_pulses, last - first + 1.0);
    if (pulses >= 1.0) {
      const double from = first + std::floor(0.5 * (last - first + 1.0 - pulses));
      recording.time_start_s = (from - 0.25) / prf_hz;
      recording.time_end_s = (from + pulses - 0.75) / prf_hz;
      doppler.pulses = static_cast<std::size_t>(pulses);
    }
  }
  doppler.input = held_arguments(std::move(scene), request.simulation);
  return doppler;
}

workflow::SearchRequest search_request_of(const LiveRequest& request) {
  workflow::SearchRequest search;
  search.input = arguments_of(request);
  search.detect = false;
  search.window = request.options.window;
  return search;
}

void write_live_product(const LiveRequest& request, const std::filesystem::path& file, const core::StopFlag* stop) {
  core::Observer observer;
  observer.stop = stop;
  const auto made = [&](auto wanted, const auto& make) {
    wanted.output = file;
    wanted.replace = true;
    static_cast<void>(make(wanted, observer));
  };
  LiveProduct product = request.options.product;
  if (product == LiveProduct::automatic) product = suitable_product(*request.scene, request.simulation);
  if (product == LiveProduct::profiles) return made(profiles_request_of(request), workflow::profiles);
  if (product == LiveProduct::isar) return made(isar_request_of(request), workflow::isar);
  if (product == LiveProduct::doppler) return made(doppler_request_of(request), workflow::doppler);
  if (product == LiveProduct::ppi) return made(search_request_of(request), workflow::search);
  workflow::FocusRequest focus = focus_request_of(request.options, 0);
  focus.memory_bytes.reset();
  focus.input = arguments_of(request);
  focus.output = file;
  focus.force = true;
  static_cast<void>(workflow::focus(focus, observer));
}

std::string live_command(const LiveRequest& request, const std::string& script) {
  const LiveOptions& options = request.options;
  const LiveProduct product = options.product == LiveProduct::automatic
                                  ? suitable_product(*request.scene, request.simulation)
                                  : options.product;
  std::string words = std::string(command_of(product)) + " " + script;
  if (request.scene->simulations.size() > 1) words += fmt::format(" --simulation {}", request.simulation + 1);
  if (options.window.kind != signal::SarWindow::Kind::rectangular)
    words += " --window " + signal::to_string(options.window);
  if (product == LiveProduct::doppler)
    if (const auto pulses = doppler_request_of(request).pulses) words += fmt::format(" --pulses {}", *pulses);
  if (product != LiveProduct::focused) return words;
  if (options.algorithm != workflow::FocusAlgorithm::automatic)
    words += fmt::format(" --algorithm {}", workflow::word_of(options.algorithm));
  if (!options.compensation) words += " --motion-compensation none";
  if (options.autofocus) words += " --autofocus";
  return words;
}

}  // namespace sarsim::picture
