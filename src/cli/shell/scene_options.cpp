#include "cli/shell/scene_options.hpp"

#include "cli/shell/request_options.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::cli {

void add_run_choices(CLI::App& app, workflow::SceneOverrides& overrides) {
  add_table_options(app, workflow::run_choice_options(), overrides);
}

void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides) {
  add_table_options(app, workflow::scene_override_options(), overrides);
}

}  // namespace sarsim::cli
