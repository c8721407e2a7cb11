#pragma once

#include <CLI/CLI.hpp>

#include "workflow/input/recording_input.hpp"

namespace sarsim::cli {

/// Adds --script and --simulation.
/// @param otherwise  the simulation of a script that is taken where none is named, in words
void add_recording_arguments(CLI::App& app, workflow::RecordingArguments& arguments,
                             const std::string& otherwise = "the first");

}  // namespace sarsim::cli
