#include "cli/shell/scene_options.hpp"

#include "cli/shell/request_options.hpp"
#include "workflow/input/recording_options.hpp"

namespace sarsim::cli {

namespace {

void add_options(CLI::App& app, const workflow::OptionTable<workflow::SceneOverrides>& table,
                 workflow::SceneOverrides& overrides) {
  for (const auto& option : table)
    add_worded_option(app, option,
                      [take = option.take, &overrides](const std::string& word) { take(overrides, word); });
}

}  // namespace

void add_run_choices(CLI::App& app, workflow::SceneOverrides& overrides) {
  add_options(app, workflow::run_choice_options(), overrides);
}

void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides) {
  add_options(app, workflow::scene_override_options(), overrides);
}

}  // namespace sarsim::cli
