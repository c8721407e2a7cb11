#pragma once

#include "core/task/parallel.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::workflow {

/// Adds what is worth knowing of a scene that was looked at with its echoes and is not seen before its products are
/// named and commands are asked: `output_names`, `diagnose_commands`. The problems are ranked again.
/// @throws core::Interrupted
void add_remarks(SceneInput& input, const core::WorkControl& control);

}  // namespace sarsim::workflow
