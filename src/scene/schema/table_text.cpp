#include "scene/schema/table_text.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/missing_word.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"

namespace sarsim::scene {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t max_cells = std::size_t{1} << 16U;  // No table has more columns; what follows is one cell.

std::string_view unquoted(std::string_view cell) {
  cell = core::trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    return core::trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

// The end of the cell that begins at `start`: where one of `separators` follows that is not within quotes around it.
std::size_t cell_end(std::string_view line, std::size_t start, std::string_view separators) {
  const std::size_t first = line.find_first_not_of(blanks, start);
  std::size_t from = start;
  if (first != std::string_view::npos && line[first] == '"') {
    const std::size_t close = line.find('"', first + 1);
    if (close != std::string_view::npos) from = close + 1;
  }
  return std::min(line.find_first_of(separators, from), line.size());
}

// What parts the cells of a line; quotes around names such as "x, m" or "x [km]" hold them together.
std::string_view separators_of(std::string_view line) {
  const bool pairs = std::ranges::count(line, '"') % 2 == 0;
  for (const std::string_view separator : {std::string_view("\t"), std::string_view(";"), std::string_view(",")}) {
    if (line.find(separator) == std::string_view::npos) continue;
    bool within = false;
    for (const char c : line) {
      within = pairs && c == '"' ? !within : within;
      if (c == separator.front() && !within) return separator;
    }
  }
  return blanks;
}

void find_cells(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  const std::string_view separators = separators_of(line);
  if (separators != blanks) {
    std::size_t start = 0;
    for (std::size_t end = cell_end(line, start, separators); end < line.size() && cells.size() < max_cells;
         end = cell_end(line, start, separators)) {
      cells.push_back(unquoted(line.substr(start, end - start)));
      start = end + 1;
    }
    cells.push_back(unquoted(line.substr(start)));
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return;
  }
  for (std::size_t start = line.find_first_not_of(blanks);
       start != std::string_view::npos && cells.size() < max_cells;) {
    const std::size_t end = cell_end(line, start, blanks);
    cells.push_back(unquoted(line.substr(start, end - start)));
    start = line.find_first_not_of(blanks, end);
  }
}

ColumnHeading heading_of(std::string_view cell) {
  const std::size_t open = cell.find_first_of("[(");
  if (open == std::string_view::npos) return {core::lower_case(cell), {}, std::string(cell)};
  const std::size_t close = std::min(cell.find_first_of("])", open), cell.size());
  const std::string_view name = core::trimmed(cell.substr(0, open));
  return {core::lower_case(name), std::string(core::trimmed(cell.substr(open + 1, close - open - 1))),
          std::string(name)};
}

// What is wrong with a cell, with no more of it than a word beside its number: the table may be a file of another kind.
std::string failure_of(std::string_view cell, Quantity quantity, std::string failure) {
  constexpr std::string_view between = " \t\r\n\v\f";
  const std::string_view whole = core::trimmed(cell);
  const std::string word = core::quoted_word(whole);
  std::string shown(whole);
  if (const std::size_t gap = whole.find_first_of(between); gap != std::string_view::npos) {
    const bool number = core::parse_number(whole.substr(0, gap)).has_value();
    shown = number ? fmt::format("{} {}", whole.substr(0, gap), core::quoted_word(whole.substr(gap))) : word;
  } else {
    shown = word;
  }
  if (shown != whole) {
    const QuantityReading again = read_quantity(shown, quantity);
    failure = again.value ? fmt::format("'{}' is not valid", word) : again.failure;
  }
  if (const std::size_t at = failure.find(shown); at != std::string::npos && !shown.empty() && word != shown)
    failure.replace(at, shown.size(), core::quoted_word(shown));
  return failure;
}

}  // namespace

void each_table_line(std::string_view text, const std::function<void(const TableLine&)>& take) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const char line_end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  TableLine line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(line_end), text.size());
    // The first cells of a spreadsheet's row may be empty: tabs at the beginning count.
    const std::string_view whole = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line.number;
    line.text = core::trimmed(whole);
    if (line.text.empty() || line.text.front() == '#' || line.text.front() == '!') continue;
    find_cells(whole, line.cells);
    take(line);
  }
}

std::vector<TableLine> table_lines(std::string_view text) {
  std::vector<TableLine> lines;
  each_table_line(text, [&](const TableLine& line) { lines.push_back(line); });
  return lines;
}

std::vector<ColumnHeading> headings_of(const TableLine& line) {
  std::vector<ColumnHeading> headings;
  for (const std::string_view cell : line.cells) {
    const bool unit_alone = !cell.empty() && (cell.front() == '[' || cell.front() == '(');
    if (unit_alone && !headings.empty() && headings.back().unit.empty())
      headings.back().unit = heading_of(cell).unit;
    else
      headings.push_back(heading_of(cell));
  }
  return headings;
}

bool is_heading(const TableLine& line) {
  return std::ranges::none_of(line.cells, [](std::string_view cell) {
    const bool number = !cell.empty() && std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
    return number || core::is_missing_word(cell);
  });
}

QuantityReading read_cell(std::string_view cell, Quantity quantity, const std::string& column_unit) {
  if (const auto plain = core::parse_number(cell)) {
    if (column_unit.empty()) return {*plain, {}};
    return read_quantity(std::string(cell) + " " + column_unit, quantity);
  }
  QuantityReading reading = read_quantity(cell, quantity);
  if (!reading.value) reading.failure = failure_of(cell, quantity, std::move(reading.failure));
  return reading;
}

}  // namespace sarsim::scene
