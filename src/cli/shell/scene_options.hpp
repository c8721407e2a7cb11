#pragma once

#include <CLI/CLI.hpp>

#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

/// Adds --profile, --pulse, --tolerance, --seed and --targets.
void add_run_choices(CLI::App& app, workflow::SceneOverrides& overrides);

/// The same and --set, which takes one value for a field.
void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides);

}  // namespace sarsim::cli
