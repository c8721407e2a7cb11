#pragma once

#include <CLI/CLI.hpp>

#include "workflow/input/sample_input.hpp"

namespace sarsim::cli {

/// Adds --from, --columns, --bits, --lsb and --script.
void add_sample_arguments(CLI::App& app, workflow::SampleArguments& arguments);

}  // namespace sarsim::cli
