#pragma once

#include <CLI/CLI.hpp>

#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

/// Adds --profile, --pulse, --tolerance and --seed.
void add_scene_overrides(CLI::App& app, workflow::SceneOverrides& overrides);

/// Adds --set, which takes one value for a field.
void add_settings(CLI::App& app, workflow::SceneOverrides& overrides);

}  // namespace sarsim::cli
