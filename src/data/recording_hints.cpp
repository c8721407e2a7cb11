#include "data/recording_hints.hpp"

#include <stdexcept>

#include "base/number_text.hpp"
#include "simulate/plan.hpp"

namespace sarsim {

namespace {

namespace fs = std::filesystem;

// Scripts name files with either kind of slash.
std::string name_in(const std::string& script_path) {
  const std::size_t slash = script_path.find_last_of("/\\");
  return slash == std::string::npos ? script_path : script_path.substr(slash + 1);
}

}  // namespace

NamesAlike names_alike(const std::vector<std::string>& names, const fs::path& file) {
  const fs::path wanted = file.filename();
  NamesAlike alike;
  for (const bool whole : {true, false}) {
    alike.whole = whole;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool same = whole ? equal_ignoring_case(names[i], wanted.string())
                              : equal_ignoring_case(fs::path(names[i]).stem().string(), wanted.stem().string());
      if (same) alike.found.push_back(i);
    }
    if (!alike.found.empty()) break;
  }
  return alike;
}

std::optional<SampleFileHints> hints_from_scene(const Scene& scene, const fs::path& file) {
  std::vector<std::string> names;
  for (const Simulation& simulation : scene.simulations) names.push_back(name_in(simulation.file));
  const NamesAlike alike = names_alike(names, file);
  // Of several outputs of one name the first has it; the others are given numbers.
  if (alike.found.empty() || (!alike.whole && alike.found.size() > 1)) return std::nullopt;
  const std::size_t index = alike.found.front();
  const Simulation& simulation = scene.simulations[index];
  try {
    const Plan plan = make_plan(scene, index);
    SampleFileHints hints;
    hints.columns = plan.columns;
    hints.rows = plan.rows;
    hints.bits = simulation.bits;
    hints.lsb_v = simulation.lsb_v;
    if (alike.whole) hints.format = simulation.format;
    return hints;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace sarsim
