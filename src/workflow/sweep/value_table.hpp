#pragma once

#include <filesystem>
#include <vector>

#include "core/report/problem.hpp"
#include "workflow/sweep/sweep_axes.hpp"

namespace sarsim::workflow {

/// A table of values, and where they stand in its file.
struct ValueTable {
  std::vector<SweepAxis> axes;
  std::size_t heading_line = 0;         ///< Of the names; from 1.
  std::vector<std::size_t> lines = {};  ///< Of each value of every axis.
};

/// Reads a table of values for a sweep: a first line of names of fields ("Target1.rcs", "let.speed", or "Target1.rcs
/// [m2]" for numbers in that unit), then a line for each variation. Separators, comments and quotes as of
/// scene/schema/table_text.hpp. What is wrong is added to `problems`, with its line; some twenty are the last.
[[nodiscard]] ValueTable read_value_table(const NamedThings& things, const std::filesystem::path& file,
                                          core::Problems& problems);

}  // namespace sarsim::workflow
