#include "cli/shell/scene_options.hpp"

#include "cli/shell/request_options.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::cli {

void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides) {
  for (const auto& option : workflow::scene_override_options())
    add_worded_option(app, option,
                      [take = option.take, &overrides](const std::string& word) { take(overrides, word); });
}

void add_settings(CLI::App& app, workflow::SceneOverrides& overrides) {
  app.add_option("--set", overrides.settings, "a field of the script and its value, as Radar1.bandwidth=10MHz; repeat")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
}

}  // namespace sarsim::cli
