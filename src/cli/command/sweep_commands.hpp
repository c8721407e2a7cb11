#pragma once

#include <string>

#include "cli/command/sweep_arguments.hpp"
#include "workflow/sweep/sweep_plan.hpp"

namespace sarsim::cli {

/// A line "sarsim run ..." for each variation of a plan that is not done, ready for a shell: it makes the same files
/// with the same samples as the sweep.
[[nodiscard]] std::string run_commands(const SweepArguments& arguments, const workflow::SweepPlan& plan);

}  // namespace sarsim::cli
