#include "data/recording_hints.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "base/number_text.hpp"
#include "simulate/plan.hpp"

namespace sarsim {

namespace {

namespace fs = std::filesystem;

// Scripts name files with either kind of slash.
fs::path name_in(const std::string& script_path) {
  const std::size_t slash = script_path.find_last_of("/\\");
  return slash == std::string::npos ? script_path : script_path.substr(slash + 1);
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
    const Plan plan = make_plan(scene, static_cast<std::size_t>(found - scene.simulations.begin()));
    SampleFileHints hints;
    hints.columns = plan.columns;
    hints.rows = plan.rows;
    hints.bits = found->bits;
    hints.lsb_v = found->lsb_v;
    if (exact) hints.format = found->format;
    return hints;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace sarsim
