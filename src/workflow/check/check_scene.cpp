#include "workflow/check/check_scene.hpp"

#include <utility>

#include "scene/script/reader.hpp"
#include "workflow/check/command_remarks.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

void add_remarks(SceneInput& input, const core::WorkControl& control) {
  core::Problems found = output_names(input.scene, {}).problems;
  if (input.resolved && !core::has_errors(input.problems))
    core::append(found, diagnose_commands(input.scene, simulate::thinned(input.resolved, max_cloud_looks), control));
  scene::locate(found, input.places);
  core::append(input.problems, std::move(found));
  input.problems = core::ranked(std::move(input.problems));
}

}  // namespace sarsim::workflow
