#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace sarsim::test {

/// What a row of docs/theory/thesis-numbers.md promises; nothing where the cell holds a dash.
struct TableRow {
  std::optional<double> classic;
  std::optional<double> physical;
  double tolerance = 0.0;
};

/// Rows by the name in their last cell. Reads every line "| ... | `Name` |" with seven cells: what, unit, thesis,
/// classic, physical, tolerance, name.
[[nodiscard]] std::map<std::string, TableRow> read_table(const std::filesystem::path& path);

}  // namespace sarsim::test
