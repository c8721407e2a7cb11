#pragma once

#include <string>

#include "cli/shell/context.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

/// What `info` is asked about a script.
struct SceneInfoArguments {
  std::string path;
  workflow::SceneOverrides overrides;
  bool json = false;
  bool all = false;  ///< Every target and object, not the first 20.
};

/// Prints what a script holds and the figures that follow from it.
ExitStatus print_scene_info(const SceneInfoArguments& arguments, Streams& streams);

}  // namespace sarsim::cli
