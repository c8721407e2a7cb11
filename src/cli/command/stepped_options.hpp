#pragma once

#include <CLI/CLI.hpp>

#include "workflow/input/recording_input.hpp"

namespace sarsim::cli {

/// Adds the options of `add_recording_arguments` and those that stand in for the script's.
void add_stepped_input_arguments(CLI::App& app, workflow::RecordingArguments& arguments);

}  // namespace sarsim::cli
