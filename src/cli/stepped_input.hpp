#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/context.hpp"
#include "cli/scene_input.hpp"
#include "simulate/stepped_rows.hpp"

namespace sarsim::cli {

/// What profiles or images of turning targets are to be made of: a script, or a file of samples and the script that
/// wrote it.
struct SteppedInputArguments {
  std::string path;
  std::string script;  ///< For a file that does not carry its script.
  std::optional<std::int64_t> simulation;
  SceneOverrides overrides;  ///< Of a script.
};

/// Adds --script, --simulation and the options that stand in for the script's.
void add_stepped_input_arguments(CLI::App& app, SteppedInputArguments& arguments);

/// Bursts, read or computed when they are asked for.
struct SteppedInput {
  SteppedRows rows;
  std::size_t simulation = 0;  ///< Position in the script's list.
  Problems problems;           ///< Warnings about script and file.
};

/// Opens what the arguments name; throws BadInput with all problems where it cannot be used.
[[nodiscard]] SteppedInput open_stepped_input(const SteppedInputArguments& arguments, SteppedUse use,
                                              const WorkControl& control);

}  // namespace sarsim::cli
