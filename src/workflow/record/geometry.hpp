#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/input/recording_input.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// Which geometry tables are wanted: those of a scene, of a recording's pulses, or one that is described.
struct GeometryRequest {
  RecordingArguments input;
  std::vector<std::string> numbers;  ///< Of the scene's tables, from 1; none: all.
  std::string radar;                 ///< Of a table that is described; empty: none is.
  std::optional<double> start_s;     ///< Of it: send time of its first pulse,
  std::optional<double> end_s;       ///< and of its last.
  std::optional<int> columns;        ///< Sum of column bits, docs/formats/geometry-table.md; nothing: the scene's.
  bool no_targets = false;           ///< Platforms alone.
};

/// --radar, --start, --end and --no-targets.
[[nodiscard]] OptionTable<GeometryRequest> geometry_choice_options();

/// The options of a request, for faces other than the command, where tables are numbered without an option.
[[nodiscard]] OptionTable<GeometryRequest> geometry_option_table();

/// Tables and the scene that they are of.
struct GeometryTables {
  scene::Scene scene;
  std::vector<scene::GeometryTable> tables;
  std::vector<std::filesystem::path> sources;  ///< Files that they are made from.
  core::Problems remarks;                      ///< Warnings about these files.
};

/// Finds the tables of a request; throws core::InvalidRequest where it cannot be met.
[[nodiscard]] GeometryTables geometry_tables(const GeometryRequest& request, const core::WorkControl& control = {});

}  // namespace sarsim::workflow
