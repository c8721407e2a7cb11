#pragma once

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/context.hpp"
#include "cli/scene_input.hpp"
#include "process/focusing.hpp"
#include "simulate/plan.hpp"

namespace sarsim::cli {

/// What is to be focused: a script, or a file of samples and the script that wrote it.
struct FocusInputArguments {
  std::string path;
  std::string script;  ///< For a file that does not carry its script.
  std::optional<std::int64_t> simulation;
};

/// Adds --script and --simulation.
void add_focus_input_arguments(CLI::App& app, FocusInputArguments& arguments);

/// Compressed echoes, read or computed when they are asked for, and the plan that they follow.
struct FocusInput {
  std::shared_ptr<const Plan> plan;
  EchoRows echoes;
  std::size_t simulation = 0;  ///< Position in the script's list.
  Problems problems;           ///< Warnings about script and file.
};

/// Opens what the arguments name; throws BadInput with all problems where it cannot be focused.
[[nodiscard]] FocusInput open_focus_input(const FocusInputArguments& arguments, const WorkControl& control);

}  // namespace sarsim::cli
