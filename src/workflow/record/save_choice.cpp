#include "workflow/record/save_choice.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "scene/script/writer.hpp"
#include "workflow/record/plan_recording.hpp"

namespace sarsim {

namespace fs = std::filesystem;

Simulation chosen_simulation(const SaveChoice& choice, double largest_v) {
  Simulation simulation = choice.recording;
  simulation.file = choice.file.filename().string();
  if (choice.lsb == LsbChoice::measured) simulation.lsb_v = 0.0;
  if (choice.lsb == LsbChoice::estimated) simulation.lsb_v = estimated_lsb_v(largest_v, simulation.bits);
  return simulation;
}

Scene with_simulation(Scene scene, const Simulation& simulation) {
  scene.simulations.push_back(simulation);
  return scene;
}

fs::path following_format(fs::path file, FileFormat format) {
  if (file.filename().empty()) return file;
  const bool known = format_from_path(file).has_value();
  if ((known && format_from_path(file) != format) || file.extension().empty())
    file.replace_extension(extension_of(format));
  return file;
}

fs::path free_file(const Scene& scene, const fs::path& folder, FileFormat format) {
  for (int number = 1;; ++number) {
    const std::string name = "sim" + std::to_string(number) + std::string(extension_of(format));
    std::error_code unreadable;
    if (std::ranges::none_of(scene.simulations, [&](const Simulation& s) { return s.file == name; }) &&
        !fs::exists(folder / name, unreadable))
      return folder / name;
  }
}

SaveForecast forecast(const Scene& scene, const SaveChoice& choice, double largest_v, unsigned threads,
                      const StopFlag* stop) {
  const Simulation simulation = chosen_simulation(choice, largest_v);
  PlannedRecording planned = plan_recording(scene, simulation, stop);
  SaveForecast forecast{std::move(planned.problems), std::nullopt};
  if (!planned.plan) return forecast;
  const bool with_script = simulation.format == FileFormat::hdf5;
  const Product product =
      product_of(*planned.plan, with_script ? write_script(with_simulation(scene, simulation)) : std::string());
  const double bytes = expected_bytes(product, {simulation.format, false, false, false});
  SaveEstimate estimate = save_estimate(*planned.plan, bytes, largest_v, threads);
  if (!(simulation.lsb_v > 0.0) && holds_counts(simulation.format)) estimate.seconds *= 2.0;
  estimate.lsb_estimated = choice.lsb != LsbChoice::given;
  if (choice.lsb == LsbChoice::measured) estimate.lsb_v = 0.0;
  forecast.estimate = estimate;
  return forecast;
}

}  // namespace sarsim
