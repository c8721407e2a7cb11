#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Targets read from a table, and what was wrong with its lines (Place::line counts from 1).
struct TargetImport {
  std::vector<Target> targets;
  core::Problems problems;
};

/// Reads targets from lines of x, y, z and, where there is one, the cross-section: what a spreadsheet puts on the
/// clipboard (tabs), CSV (commas or semicolons), or columns of blanks. A first line of names may give the columns in
/// another order (x, y, z, rcs; units in brackets are taken: "x [km]"). Empty lines and those that begin with '#' or
/// '!' are skipped. Metres and square metres otherwise. A bad line is a problem; the others are taken.
[[nodiscard]] TargetImport import_targets(std::string_view text, const std::string& platform);

/// The same table of targets, tab-separated with a line of names, for the clipboard.
[[nodiscard]] std::string targets_text(const std::vector<Target>& targets);

}  // namespace sarsim::scene
