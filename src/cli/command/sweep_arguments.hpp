#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "simulate/plan/engine.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/sweep/sweep_options.hpp"
#include "workflow/sweep/sweep_request.hpp"

namespace sarsim::cli {

/// What `sweep` is asked.
struct SweepArguments {
  std::string scene;
  std::vector<std::string> let;  ///< "NAME=VALUES".
  std::vector<std::string> products;
  workflow::SweepValues values;  ///< Without what follows.
  std::string table_of_values;
  std::optional<std::int64_t> draws;
  std::string folder = ".";
  std::string table;  ///< Stem of the names of table and journal, in the folder.
  workflow::SceneOverrides overrides;
  std::optional<simulate::Engine> engine;
  std::string simd;
  std::optional<std::int64_t> threads;
  std::optional<std::int64_t> jobs;
  std::string part;  ///< "K/N"
  bool counts = false;
  bool header = false;
  bool discard = false;
  bool force = false;
  bool resume = false;
  bool dry_run = false;
  bool commands = false;
  workflow::FollowUpWords follow_up;
  bool fields = false;
  bool json = false;
  bool strict = false;
  bool quiet = false;
};

/// Adds all options of `sweep` to the command.
void add_sweep_arguments(CLI::App& app, SweepArguments& arguments);

}  // namespace sarsim::cli
