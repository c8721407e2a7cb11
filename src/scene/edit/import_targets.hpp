#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/progress.hpp"
#include "core/task/stop.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/table_text.hpp"

namespace sarsim::scene {

/// Targets read from a table, and what was wrong with its lines (Place::line counts from 1).
struct TargetImport {
  std::vector<Target> targets;
  core::Problems problems;
};

/// Where x, y, z, or in their place latitude, longitude and height, and the cross-section stand in the lines of a
/// table, and in which units.
struct TargetColumns {
  static constexpr std::size_t quantities = 4;
  std::array<std::optional<std::size_t>, quantities> at{0, 1, 2, 3};
  std::array<std::string, quantities> unit;
  std::size_t count = quantities;  ///< Beyond this, cells are a surprise.
  bool heading = false;            ///< The first line names the columns.
  bool geodetic = false;           ///< Latitude, longitude and height above the ellipsoid of WGS 84.

  /// "x, y, z", or what stands in their place, "and, where there is one, the cross-section".
  [[nodiscard]] std::string words() const;
};

/// What the first line of a table says of its columns; what is wrong with it is added to `problems`.
[[nodiscard]] TargetColumns target_columns(const TableLine& line, core::Problems& problems);

/// Why the places of a table cannot be taken: they are geodetic, and the world is flat or they belong to a platform.
/// Nothing where they can.
/// @param line  that names the columns
[[nodiscard]] std::optional<core::Problem> problem_of_places(const TargetColumns& columns, const TableLine& line,
                                                             const World& world, const std::string& platform);

/// One line of such a table: x, y, z [m], or latitude, longitude [deg] and height [m], and cross-section [m2], or what
/// is wrong with it.
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
///
/// Over the Earth the names may be latitude, longitude and height, for targets of the world itself: degrees, and metres
/// above the ellipsoid. A table that names all of x, y and z is one of these, whatever other columns it has.
/// @param world     where the targets are
/// @param stop      asked now and then; a requested stop throws Interrupted
/// @param progress  told of the bytes that were read; may be empty
[[nodiscard]] TargetImport import_targets(std::string_view text, const std::string& platform, const World& world = {},
                                          const core::StopFlag* stop = nullptr,
                                          const core::ProgressReport& progress = {});

/// The same table of targets, tab-separated with a line of names, for the clipboard.
[[nodiscard]] std::string targets_text(const std::vector<Target>& targets);

}  // namespace sarsim::scene
