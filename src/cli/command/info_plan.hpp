#pragma once

#include <string>

#include "cli/shell/context.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

/// What `info --plan` is asked.
struct PlanArguments {
  std::string path;
  workflow::SceneOverrides overrides;
  bool json = false;
  unsigned workers = 1;  ///< Machines like this one, or processes with threads of their own.
  unsigned threads = 0;  ///< Of each worker; 0: one per core.
};

/// Prints what each recording of a script will take, of samples, bytes, memory and time. Times come from a trial of
/// some pulses of each recording on this machine.
ExitStatus print_plan(const PlanArguments& arguments, Streams& streams);

}  // namespace sarsim::cli
