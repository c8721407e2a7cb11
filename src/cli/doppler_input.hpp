#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/context.hpp"
#include "cli/scene_input.hpp"
#include "simulate/pulse_rows.hpp"

namespace sarsim::cli {

/// Whose pulses are worked on: a script's, or those of a file of samples and of the script that wrote it.
struct PulseInputArguments {
  std::string path;
  std::string script;  ///< For a file that does not carry its script.
  std::optional<std::int64_t> simulation;
};

/// Adds --script and --simulation.
void add_pulse_input_arguments(CLI::App& app, PulseInputArguments& arguments);

/// Pulses and what there is to say about their source.
struct PulseInput {
  PulseRows rows;
  std::size_t simulation = 0;  ///< Position in the script's list.
  Problems problems;
};

/// Opens what the arguments name; throws BadInput with all problems where it has no pulses.
[[nodiscard]] PulseInput open_pulse_input(const PulseInputArguments& arguments, const WorkControl& control);

}  // namespace sarsim::cli
