#pragma once

#include "workflow/input/output_names.hpp"

/// The names of the workflows, as the commands use them.
namespace sarsim::cli {

using workflow::base_name;
using workflow::expect_free_outputs;
using workflow::output_names;
using workflow::OutputCare;
using workflow::OutputNames;
using workflow::OutputRules;
using workflow::problems_of_output;
using workflow::simulation_that_writes;

}  // namespace sarsim::cli
