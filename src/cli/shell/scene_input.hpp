#pragma once

#include "cli/shell/context.hpp"
#include "cli/shell/scene_options.hpp"
#include "workflow/input/scene_input.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::ChooseProducts;
using workflow::data_files_of;
using workflow::expect_usable;
using workflow::radar_named;
using workflow::read_scene;
using workflow::resolve_once;
using workflow::SceneInput;
using workflow::SceneOverrides;
using workflow::Scrutiny;
using workflow::sources_of_script;
using workflow::WantedProducts;

}  // namespace sarsim::cli
