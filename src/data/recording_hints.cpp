#include "data/recording_hints.hpp"

#include <algorithm>
#include <exception>
#include <string>

#include "base/number_text.hpp"
#include "scene/check.hpp"
#include "simulate/plan.hpp"
#include "simulate/resolved.hpp"

namespace sarsim {

namespace {

namespace fs = std::filesystem;

// Scripts name files with either kind of slash.
fs::path name_in(const std::string& script_path) {
  const std::size_t slash = script_path.find_last_of("/\\");
  return slash == std::string::npos ? script_path : script_path.substr(slash + 1);
}

// No file that can be looked at has longer rows.
constexpr double most_columns = 0x1p31;

struct Shape {
  std::size_t rows = 0;  // 0: not known
  std::size_t columns = 0;
};

// The simulation alone with its radar: targets have no say in the shape and may be very many. Nothing is planned, for
// a plan holds every column, and what a window under edit asks for may not fit into any memory.
std::optional<Shape> shape_of(const Scene& scene, const Simulation& simulation) {
  const std::size_t radar = find_radar(scene, simulation.radar);
  if (radar == not_found) return std::nullopt;
  Scene alone;
  alone.options = scene.options;
  alone.platforms = scene.platforms;
  alone.radars = {scene.radars[radar]};
  alone.simulations = {simulation};
  const auto is_error = [](const Problem& problem) { return problem.severity == Severity::error; };
  if (std::ranges::any_of(check(alone), is_error)) return std::nullopt;
  const ResolvedScene resolved = resolve(alone);
  const double count = sample_count(simulation, resolved.conventions.light_speed_mps);
  const ResolvedRadar seen_by = resolve_radar(alone, resolved, 0);
  const bool profiles = simulation.processing == Processing::srp;
  const double columns = profiles ? count * seen_by.carrier.steps() : count;
  if (!(columns >= 1.0 && columns <= most_columns)) return std::nullopt;
  const auto pulses = seen_by.repetition.pulses_in(simulation.time_start_s, simulation.time_end_s).count();
  return Shape{profiles ? 0 : static_cast<std::size_t>(pulses), static_cast<std::size_t>(columns)};
}

}  // namespace

std::optional<SampleFileHints> hints_from_scene(const Scene& scene, const fs::path& file) {
  const fs::path name = file.filename();
  const auto named = [&](const Simulation& simulation) {
    return equal_ignoring_case(name_in(simulation.file).string(), name.string());
  };
  const auto alike = [&](const Simulation& simulation) {
    return equal_ignoring_case(name_in(simulation.file).stem().string(), name.stem().string());
  };
  auto found = std::ranges::find_if(scene.simulations, named);
  const bool exact = found != scene.simulations.end();
  if (!exact) found = std::ranges::find_if(scene.simulations, alike);
  if (found == scene.simulations.end()) return std::nullopt;
  try {
    const auto shape = shape_of(scene, *found);
    if (!shape) return std::nullopt;
    SampleFileHints hints;
    hints.columns = shape->columns;
    hints.rows = shape->rows;
    hints.bits = found->bits;
    hints.lsb_v = found->lsb_v;
    if (exact) hints.format = found->format;
    return hints;
  } catch (const std::exception&) {
    return std::nullopt;  // Hints are a help, never in the way.
  }
}

}  // namespace sarsim
