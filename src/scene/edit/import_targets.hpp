#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/table_text.hpp"

namespace sarsim::scene {

/// Targets read from a table, and what was wrong with its lines (Place::line counts from 1).
struct TargetImport {
  std::vector<Target> targets;
  core::Problems problems;
};

/// Where x, y, z and the cross-section stand in the lines of a table, and in which units.
struct TargetColumns {
  static constexpr std::size_t quantities = 4;
  std::array<std::optional<std::size_t>, quantities> at{0, 1, 2, 3};
  std::array<std::string, quantities> unit;
  std::size_t count = quantities;  ///< Beyond this, cells are a surprise.
  bool heading = false;            ///< The first line names the columns.
};

/// What the first line of a table says of its columns; what is wrong with it is added to `problems`.
[[nodiscard]] TargetColumns target_columns(const TableLine& line, core::Problems& problems);

/// One line of such a table: x, y, z [m] and cross-section [m2], or what is wrong with it.
struct TargetLine {
  std::array<double, TargetColumns::quantities> values{0.0, 0.0, 0.0, 1.0};
  std::string message;  ///< Empty where all is well.
  std::string found;
};
[[nodiscard]] TargetLine read_target_line(const TableLine& line, const TargetColumns& columns);

/// Reads targets from lines of x, y, z and, where there is one, the cross-section: what a spreadsheet puts on the
/// clipboard (tabs), CSV (commas or semicolons), or columns of blanks. A first line of names may give the columns in
/// another order (x, y, z, rcs or rcs_dbsm; units in brackets are taken: "x [km]"). Empty lines and those that begin
/// with '#' or
/// '!' are skipped. Metres and square metres otherwise. A bad line is a problem; the others are taken.
[[nodiscard]] TargetImport import_targets(std::string_view text, const std::string& platform);

/// The same table of targets, tab-separated with a line of names, for the clipboard.
[[nodiscard]] std::string targets_text(const std::vector<Target>& targets);

}  // namespace sarsim::scene
