#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace sarsim::test {

/// The lines of a table without quoted cells, by the names of their columns.
inline std::vector<std::map<std::string, std::string>> read_csv(const std::string& text) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    return cells;
  };
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = cells_of(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) rows.back()[names[i]] = cells[i];
  }
  return rows;
}

/// A table without its last column, the seconds, which no two runs have in common.
inline std::string without_seconds(const std::string& text) {
  std::istringstream stream(text);
  std::string result;
  for (std::string line; std::getline(stream, line);) result += line.substr(0, line.rfind(',')) + "\n";
  return result;
}

}  // namespace sarsim::test
