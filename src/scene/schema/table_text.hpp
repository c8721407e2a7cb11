#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/quantity.hpp"

namespace sarsim::scene {

/// One line of a table of text: views into the text that was split.
struct TableLine {
  std::size_t number = 0;  ///< From 1.
  std::string_view text;
  std::vector<std::string_view> cells;  ///< Without blanks and quotes around them, without empty ones at the end.
};

/// Splits a table into lines and cells: at tabs where a line has any, else at semicolons, else at commas, else at
/// blanks. Empty lines and those that begin with '#' or '!' are left out; lines end with LF, CR LF or CR.
/// @param take  is given one line after the other; its text and cells point into `text`, the line itself is good until
///              it returns; what it throws ends the reading
void each_table_line(std::string_view text, const std::function<void(const TableLine&)>& take);
/// The same, all at once.
[[nodiscard]] std::vector<TableLine> table_lines(std::string_view text);

/// A column's heading: "x [km]" or "x (km)" is the name x with the unit km; the name in lower case.
struct ColumnHeading {
  std::string name;
  std::string unit;
  std::string written;  ///< The name as it stands there.
};
[[nodiscard]] std::vector<ColumnHeading> headings_of(const TableLine& line);

/// True where no cell of the line is a number or a word for a missing one ("NA"): a line of names.
[[nodiscard]] bool is_heading(const TableLine& line);

/// Reads a cell, in the unit of its column where it has none of its own.
[[nodiscard]] QuantityReading read_cell(std::string_view cell, Quantity quantity, const std::string& column_unit);

}  // namespace sarsim::scene
