#include "core/text/csv.hpp"

#include <utility>

namespace sarsim::core {

namespace {

// Takes one line off the beginning of a text.
std::vector<std::string> take_csv_line(std::string_view& text) {
  std::vector<std::string> cells(1);
  bool within_quotes = false;
  std::size_t i = 0;
  for (; i < text.size() && (within_quotes || text[i] != '\n'); ++i) {
    const char c = text[i];
    if (c == '"') {
      const bool doubled = within_quotes && i + 1 < text.size() && text[i + 1] == '"';
      if (doubled)
        cells.back() += text[i++];
      else
        within_quotes = !within_quotes;
    } else if (c == ',' && !within_quotes) {
      cells.emplace_back();
    } else if (c != '\r' || within_quotes) {
      cells.back() += c;
    }
  }
  text.remove_prefix(i < text.size() ? i + 1 : i);
  return cells;
}

}  // namespace

std::vector<std::string> csv_cells(std::string_view line) { return take_csv_line(line); }

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

CsvTable read_csv(std::string_view text) {
  CsvTable table;
  if (text.empty()) return table;
  table.names = take_csv_line(text);
  while (!text.empty()) {
    table.rows.push_back(take_csv_line(text));
    table.rows.back().resize(table.names.size());
  }
  return table;
}

}  // namespace sarsim::core
