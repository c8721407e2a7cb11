#include "workflow/input/recording_hints.hpp"

#include <algorithm>
#include <exception>
#include <string>

#include "core/text/number_text.hpp"
#include "scene/check/check.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::workflow {

namespace {

namespace fs = std::filesystem;

// Scripts name files with either kind of slash.
std::string name_in(const std::string& script_path) {
  const std::size_t slash = script_path.find_last_of("/\\");
  return slash == std::string::npos ? script_path : script_path.substr(slash + 1);
}

// No file that can be looked at has longer rows.
constexpr double max_row_columns = 0x1p31;

struct Shape {
  std::size_t rows = 0;  // 0: not known
  std::size_t columns = 0;
};

// The simulation alone with its radar: targets have no say in the shape and may be very many. Nothing is planned, for
// a plan holds every column, and what a window under edit asks for may not fit into any memory.
std::optional<Shape> shape_of(const scene::Scene& scene, const scene::Simulation& simulation) {
  const std::size_t radar = scene::find_radar(scene, simulation.radar);
  if (radar == scene::not_found) return std::nullopt;
  scene::Scene alone;
  alone.options = scene.options;
  alone.world = scene.world;
  alone.platforms = scene.platforms;
  alone.radars = {scene.radars[radar]};
  alone.simulations = {simulation};
  const auto is_error = [](const core::Problem& problem) { return problem.severity == core::Severity::error; };
  if (std::ranges::any_of(scene::check(alone), is_error)) return std::nullopt;
  const simulate::ResolvedScene resolved = simulate::resolve(alone);
  const double count = simulate::sample_count(simulation, resolved.conventions.light_speed_mps);
  const simulate::Link seen_by = simulate::resolve_radar(alone, resolved, 0);
  const bool profiles = simulation.processing == scene::Processing::srp;
  const double columns = profiles ? count * seen_by.carrier.steps() : count;
  if (!(columns >= 1.0 && columns <= max_row_columns)) return std::nullopt;
  const auto pulses = seen_by.repetition.pulses_in(simulation.time_start_s, simulation.time_end_s).count();
  return Shape{profiles ? 0 : static_cast<std::size_t>(pulses), static_cast<std::size_t>(columns)};
}

}  // namespace

NamesAlike names_alike(const std::vector<std::string>& names, const fs::path& file) {
  const fs::path wanted = file.filename();
  NamesAlike alike;
  for (const bool whole : {true, false}) {
    alike.whole = whole;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool same = whole ? core::equal_ignoring_case(names[i], wanted.string())
                              : core::equal_ignoring_case(fs::path(names[i]).stem().string(), wanted.stem().string());
      if (same) alike.found.push_back(i);
    }
    if (!alike.found.empty()) break;
  }
  return alike;
}

std::optional<raster::RasterHints> hints_from_scene(const scene::Scene& scene, const fs::path& file) {
  std::vector<std::string> names;
  for (const scene::Simulation& simulation : scene.simulations) names.push_back(name_in(simulation.file));
  const NamesAlike alike = names_alike(names, file);
  // Of several outputs of one name the first has it; the others are given numbers.
  if (alike.found.empty() || (!alike.whole && alike.found.size() > 1)) return std::nullopt;
  const std::size_t index = alike.found.front();
  const scene::Simulation& simulation = scene.simulations[index];
  try {
    const auto shape = shape_of(scene, simulation);
    if (!shape) return std::nullopt;
    raster::RasterHints hints;
    hints.columns = shape->columns;
    hints.rows = shape->rows;
    hints.bits = simulation.bits;
    hints.lsb_v = simulation.lsb_v;
    if (alike.whole) hints.format = simulation.format;
    return hints;
  } catch (const std::exception&) {
    return std::nullopt;  // Hints are a help, never in the way.
  }
}

}  // namespace sarsim::workflow
