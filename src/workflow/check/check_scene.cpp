#include "workflow/check/check_scene.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/script/reader.hpp"
#include "workflow/check/command_remarks.hpp"
#include "workflow/input/cloud_input.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::workflow {

void add_remarks(SceneInput& input, const core::WorkControl& control) {
  core::Problems found = output_names(input.scene, {}).problems;
  if (input.resolved && !core::has_errors(input.problems))
    std::ranges::move(diagnose_commands(input.scene, simulate::thinned(input.resolved, max_cloud_looks), control),
                      std::back_inserter(found));
  scene::locate(found, input.places);
  std::ranges::move(found, std::back_inserter(input.problems));
  input.problems = core::ranked(std::move(input.problems));
}

}  // namespace sarsim::workflow
