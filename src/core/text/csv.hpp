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

/// Splits such a text; lines end with LF or CR LF. Rows that are too short get empty values, too long ones are cut.
[[nodiscard]] CsvTable read_csv(std::string_view text);

}  // namespace sarsim::core
