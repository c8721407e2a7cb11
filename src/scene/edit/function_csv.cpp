#include <algorithm>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/edit/function_model.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/function_table.hpp"
#include "scene/schema/table_text.hpp"
#include "scene/script/named_columns.hpp"

namespace sarsim::scene {

namespace {

using namespace function_tables;

constexpr std::size_t max_problems = 20;  // of a file that is refused in any case

struct Column {
  std::string name;
  Quantity quantity;
  std::string unit;
};

class CsvReader {
 public:
  CsvReader(const FunctionKind& kind, std::string file_name) : kind_(kind), file_name_(std::move(file_name)) {
    functions_.resize(kind.block.count);
  }

  void read(const std::vector<TableLine>& lines) {
    if (lines.empty()) return add({}, "the file holds no numbers", "", expected());
    const bool named = is_heading(lines.front());
    const std::span<const TableLine> rows = std::span(lines).subspan(named ? 1 : 0);
    // Values alone, in turn, are enough where x only counts them.
    const bool single = std::ranges::all_of(rows, [](const TableLine& row) { return row.cells.size() == 1; });
    x_given_ = !(kind_.block.x_ignored && single);
    if (x_given_) columns_.push_back({std::string(kind_.x_name), kind_.x_quantity, {}});
    for (std::size_t i = 0; i < kind_.block.count; ++i)
      columns_.push_back({std::string(kind_.part_names[i]), kind_.y_quantity, {}});
    places_.resize(columns_.size());
    std::iota(places_.begin(), places_.end(), std::size_t{0});
    if (named) read_heading(lines.front());
    for (const TableLine& row : rows) read_line(row);
    for (std::size_t i = 0; i < functions_.size(); ++i) finish(i);
  }

  [[nodiscard]] std::vector<std::vector<core::Knot>> take_functions() { return std::move(functions_); }
  [[nodiscard]] core::Problems take_problems() { return std::move(problems_); }

 private:
  [[nodiscard]] std::string expected() const {
    std::string text;
    for (const Column& column : columns_) text += fmt::format("{}{}", text.empty() ? "" : ", ", column.name);
    return text;
  }

  void add(const TableLine& line, std::string message, std::string_view found, std::string expected_text,
           core::Severity severity = core::Severity::error) {
    if (problems_.size() >= max_problems) return;
    problems_.push_back(core::ProblemBuilder(severity, std::move(message))
                            .found(core::quoted_word(found))
                            .expected(std::move(expected_text))
                            .in(file_name_, line.number));
  }

  void read_heading(const TableLine& line) {
    std::vector<std::size_t> usual(columns_.size());
    std::iota(usual.begin(), usual.end(), x_given_ ? 0U : 1U);
    const std::vector<ColumnHeading> headings = headings_of(line);
    const NamedColumns named = named_columns(kind_.block, headings, usual);
    if (named.fault) return add(line, named.fault->message, named.fault->found, named.fault->expected);
    places_ = named.places;
    for (std::size_t i = 0; i < std::min(headings.size(), columns_.size()); ++i) {
      Column& column = columns_[places_[i]];
      const std::string& unit = named.units[i];
      // A unit that the quantity does not know, such as m/sqrt(s), says what the editor says.
      if (unit.empty() || units_of(column.quantity).empty()) continue;
      if (!read_quantity("1 " + unit, column.quantity).value)
        add(line, fmt::format("the unit of column {} is not known", column.name), unit,
            fmt::format("{}", fmt::join(units_of(column.quantity), ", ")));
      else
        column.unit = unit;
    }
  }

  void read_line(const TableLine& line) {
    if (line.cells.size() > columns_.size())
      return add(line, fmt::format("{} columns where {} are expected", line.cells.size(), columns_.size()), line.text,
                 expected());
    std::vector<double> values(columns_.size(), 0.0);
    std::vector<bool> given(columns_.size(), false);
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
      if (line.cells[i].empty()) continue;
      const std::size_t at = places_[i];
      const Column& column = columns_[at];
      const QuantityReading reading = read_cell(line.cells[i], column.quantity, column.unit);
      if (!reading.value)
        return add(line, fmt::format("{}: {}", column.name, reading.failure), line.cells[i], "a number");
      if (!computable(*reading.value))
        return add(line, fmt::format("{} is too large to compute with", column.name), line.cells[i],
                   fmt::format("a magnitude up to {:g}", largest_value));
      values[at] = *reading.value;
      given[at] = true;
    }
    if (x_given_ && !given[0]) return add(line, fmt::format("{} is missing", kind_.x_name), line.text, expected());
    const std::size_t first = x_given_ ? 1 : 0;
    if (std::ranges::none_of(given.begin() + static_cast<std::ptrdiff_t>(first), given.end(), std::identity{}))
      return add(line, "the line has no value", line.text, expected());
    for (std::size_t i = first; i < columns_.size(); ++i) {
      if (!given[i]) continue;
      auto& knots = functions_[i - first];
      const double x = x_given_ ? values[0] : static_cast<double>(knots.size());
      if (kind_.block.x_ignored && !(values[i] > 0.0))
        return add(line, fmt::format("{} is not above zero", columns_[i].name), core::format_number(values[i]),
                   "a number above 0");
      knots.push_back({x, values[i]});
    }
  }

  void finish(std::size_t part) {
    auto& knots = functions_[part];
    if (knots.empty() && problems_.empty())
      add({}, fmt::format("{} has no points", kind_.part_names[part]), "", expected());
    if (kind_.block.x_ignored) return;
    std::ranges::stable_sort(knots, {}, &core::Knot::x);
    const auto twice = std::ranges::adjacent_find(knots, {}, &core::Knot::x);
    if (twice != knots.end())
      add({}, fmt::format("{} has two points at the same {}", kind_.part_names[part], kind_.x_name),
          core::format_number(twice->x), "each once");
  }

  const FunctionKind& kind_;
  std::string file_name_;
  std::vector<Column> columns_;
  std::vector<std::size_t> places_;  // Of each column of the file, in `columns_`.
  std::vector<std::vector<core::Knot>> functions_;
  core::Problems problems_;
  bool x_given_ = true;
};

}  // namespace

FunctionReading import_function_csv(const AnyObject& object, std::string_view field, std::string_view text,
                                    const std::string& file_name) {
  FunctionReading reading{function_of(object, field), {}};
  CsvReader reader(function_kind(object, field), file_name);
  reader.read(table_lines(text));
  reading.problems = reader.take_problems();
  if (core::has_errors(reading.problems)) return reading;
  auto functions = reader.take_functions();
  for (std::size_t i = 0; i < functions.size(); ++i) reading.draft.parts[i].knots = std::move(functions[i]);
  reading.draft.file.clear();
  return reading;
}

}  // namespace sarsim::scene
