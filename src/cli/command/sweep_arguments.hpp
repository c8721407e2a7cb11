#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "simulate/plan/engine.hpp"
#include "workflow/sweep/sweep_options.hpp"

namespace sarsim::cli {

/// What `sweep` is asked.
struct SweepArguments {
  std::string scene;
  std::vector<std::string> let;  ///< "NAME=VALUES".
  workflow::SweepWords words;    ///< Without the scene and those names.
  std::optional<simulate::Engine> engine;
  std::string simd;
  bool dry_run = false;
  bool commands = false;
  bool fields = false;
  bool json = false;
  bool quiet = false;
};

/// Adds all options of `sweep` to the command.
void add_sweep_arguments(CLI::App& app, SweepArguments& arguments);

}  // namespace sarsim::cli
