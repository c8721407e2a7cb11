#include "thesis/table.hpp"

#include <fstream>
#include <sstream>
#include <vector>

namespace sarsim::test {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" `");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" `") - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(trimmed(cell));
  return cells;
}

std::optional<double> number_in(const std::string& cell) {
  if (cell == "-") return std::nullopt;
  return std::stod(cell);
}

}  // namespace

std::map<std::string, TableRow> read_table(const std::filesystem::path& path) {
  std::map<std::string, TableRow> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("|") || line.find("| `") == std::string::npos) continue;
    const auto cells = cells_of(line);
    if (cells.size() != 7) continue;
    rows[cells[6]] = {number_in(cells[3]), number_in(cells[4]), std::stod(cells[5])};
  }
  return rows;
}

}  // namespace sarsim::test
