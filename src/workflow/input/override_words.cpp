#include "workflow/input/override_words.hpp"

#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "core/text/shell_word.hpp"
#include "workflow/input/recording_options.hpp"
#include "workflow/options/option_words.hpp"

namespace sarsim::workflow {

std::string words_of_overrides(const SceneOverrides& overrides) {
  std::string line;
  const auto add = [&line](const char* option, const std::string& word) {
    line += (line.empty() ? "" : " ") + std::string(option) + " " + core::shell_word(word);
  };
  if (overrides.profile) add("--profile", *overrides.profile == scene::Profile::classic ? "classic" : "physical");
  if (overrides.pulse)
    add("--pulse", *overrides.pulse == scene::PulseDefinition::band_limited ? "band-limited" : "ideal");
  if (overrides.tolerance) add("--tolerance", core::format_number(*overrides.tolerance));
  if (overrides.seed) add("--seed", std::to_string(*overrides.seed));
  for (const std::string& table : overrides.targets) add("--targets", table);
  for (const std::string& setting : overrides.settings) add("--set", setting);
  for (const std::string& name : overrides.let) add("--let", name);
  return line;
}

SceneOverrides overrides_from_words(const std::string& line) {
  const OptionTable<SceneOverrides> table = scene_override_options();
  SceneOverrides overrides;
  const TakenProblems problems = table.take_words(given_words(table.options(), words_of_line(line)), overrides);
  if (!problems.empty()) throw core::InvalidRequest(problems.early);
  return overrides;
}

}  // namespace sarsim::workflow
