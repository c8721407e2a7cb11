#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sarsim::core {

/// A table of comma-separated values (RFC 4180), as Sarsim writes them: a line of names, then as many values in each
/// row.
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;  ///< Each as long as `names`.
};

/// The values of one line of such a table, which may end with LF or CR LF.
[[nodiscard]] std::vector<std::string> csv_cells(std::string_view line);

/// A text as one value of such a table: in quotes where it would break the line.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// Splits such a text; lines end with LF or CR LF. Rows that are too short get empty values, too long ones are cut.
[[nodiscard]] CsvTable read_csv(std::string_view text);

}  // namespace sarsim::core
