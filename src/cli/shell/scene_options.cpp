#include "cli/shell/scene_options.hpp"

#include "cli/shell/options.hpp"

namespace sarsim::cli {

void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides) {
  add_choice<scene::Profile>(app, "--profile", overrides.profile,
                             {{"physical", scene::Profile::physical}, {"classic", scene::Profile::classic}},
                             "conventions: today's physics, or those of the 1998 programs");
  add_choice<scene::PulseDefinition>(
      app, "--pulse", overrides.pulse,
      {{"ideal", scene::PulseDefinition::ideal}, {"band-limited", scene::PulseDefinition::band_limited}},
      "hard-edged pulses, or pulses confined to their band");
  add_real(app, "--tolerance", overrides.tolerance, "X", "relative error that fast engines may make");
  add_seed(app, "--seed", overrides.seed, "of the random numbers");
}

void add_settings(CLI::App& app, workflow::SceneOverrides& overrides) {
  app.add_option("--set", overrides.settings, "a field of the script and its value, as Radar1.bandwidth=10MHz; repeat")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
}

}  // namespace sarsim::cli
