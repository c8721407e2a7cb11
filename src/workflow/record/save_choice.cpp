#include "workflow/record/save_choice.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "raster/table/formats.hpp"
#include "scene/language/recorded_text.hpp"
#include "workflow/record/plan_recording.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

scene::Simulation chosen_simulation(const SaveChoice& choice, double largest_v) {
  scene::Simulation simulation = choice.recording;
  simulation.file = choice.file.filename().string();
  if (choice.lsb == LsbChoice::measured) simulation.lsb_v = 0.0;
  if (choice.lsb == LsbChoice::estimated) simulation.lsb_v = estimated_lsb_v(largest_v, simulation.bits);
  return simulation;
}

SampleChoice chosen_samples(const SaveChoice& choice) {
  return raster::holds_counts(choice.recording.format) ? SampleChoice::counts : choice.samples;
}

raster::SinkOptions sink_options_of(const SaveChoice& choice, bool replace) {
  const SampleChoice samples = chosen_samples(choice);
  return {.format = choice.recording.format,
          .replace = replace,
          .counts = samples == SampleChoice::counts,
          .doubles = samples == SampleChoice::doubles};
}

scene::Scene with_simulation(scene::Scene scene, const scene::Simulation& simulation) {
  scene.simulations.push_back(simulation);
  return scene;
}

fs::path following_format(fs::path file, scene::FileFormat format) {
  if (file.filename().empty()) return file;
  const bool known = raster::format_from_path(file).has_value();
  if ((known && raster::format_from_path(file) != format) || file.extension().empty())
    file.replace_extension(raster::extension_of(format));
  return file;
}

fs::path free_file(const scene::Scene& scene, const fs::path& folder, scene::FileFormat format) {
  for (int number = 1;; ++number) {
    const std::string name = "sim" + std::to_string(number) + std::string(raster::extension_of(format));
    std::error_code unreadable;
    if (std::ranges::none_of(scene.simulations, [&](const scene::Simulation& s) { return s.file == name; }) &&
        !fs::exists(folder / name, unreadable))
      return folder / name;
  }
}

SaveForecast forecast(const scene::Scene& scene, const SaveChoice& choice, double largest_v, unsigned threads,
                      const core::StopFlag* stop) {
  const scene::Simulation simulation = chosen_simulation(choice, largest_v);
  PlannedRecording planned = plan_recording(scene, simulation, stop);
  SaveForecast forecast{std::move(planned.problems), std::nullopt};
  if (!planned.plan) return forecast;
  const bool with_script = raster::format_of(simulation.format).carries_script;
  const raster::Product product = simulate::product_of(
      *planned.plan, with_script ? scene::recorded_text(with_simulation(scene, simulation)) : std::string());
  const double bytes = raster::expected_bytes(product, sink_options_of(choice, false));
  const bool counts = chosen_samples(choice) == SampleChoice::counts;
  SaveEstimate estimate = save_estimate(*planned.plan, bytes, largest_v, threads, counts);
  estimate.lsb_estimated = choice.lsb != LsbChoice::given;
  if (choice.lsb == LsbChoice::measured) estimate.lsb_v = 0.0;
  forecast.estimate = estimate;
  return forecast;
}

}  // namespace sarsim::workflow
