#include "workflow/sweep/value_table.hpp"

#include <string>
#include <variant>

#include <fmt/format.h>

#include "core/text/counted.hpp"
#include "core/text/letters.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/schema/table_text.hpp"
#include "workflow/input/target_tables.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::size_t max_told = 20;

// Reads the lines of a table into the axes of its columns.
class TableReader {
 public:
  TableReader(const NamedThings& things, std::string file, core::Problems& problems)
      : things_(things), file_(std::move(file)), problems_(problems) {}

  ValueTable read(std::string_view text) {
    const std::vector<scene::TableLine> lines = scene::table_lines(text);
    if (lines.size() < 2) {
      tell(
          0,
          core::error("the table has no values").expected("a line of names of fields, then a line for each variation"));
      return {};
    }
    if (lines.size() - 1 > max_variations) {
      tell(lines.back().number, core::error("the table has too many lines")
                                    .found(core::counted(lines.size() - 1, "line"))
                                    .expected(fmt::format("{} at most", max_variations)));
      return {};
    }
    heading_line_ = lines[0].number;
    ValueTable table{axes_of(lines[0]), heading_line_};
    for (std::size_t i = 1; i < lines.size() && !table.axes.empty() && problems_.size() < max_told; ++i)
      add_line(lines[i], table);
    return table;
  }

 private:
  void tell(std::size_t line, core::ProblemBuilder problem) { problems_.push_back(std::move(problem).in(file_, line)); }

  std::vector<SweepAxis> axes_of(const scene::TableLine& line) {
    expect_whole_brackets(line);
    std::vector<SweepAxis> axes;
    if (line.cells.empty())
      tell(line.number, core::error("the first line of the table names no fields")
                            .found(core::quoted_word(line.text))
                            .expected("names as in Radar1.bandwidth or seed"));
    for (const scene::ColumnHeading& column : scene::headings_of(line)) {
      if (problems_.size() >= max_told) break;
      SweepAxis axis;
      axis.name = column.written;
      name(axis, column.unit.empty() ? "" : "0");
      if (axis.name.empty())
        tell(line.number, core::error("a column has no name")
                              .found(std::string(core::quoted_word(line.text)))
                              .expected("names as in Radar1.bandwidth or seed"));
      else if (axis.field.field == nullptr)
        tell(line.number, core::error(  // What is wrong with a name of several words would quote them.
                              core::quoted_word(column.written) == column.written
                                  ? "a column is not named after a field: " + axis.field.failure
                                  : "a column is not named after a field")
                              .found(core::quoted_word(column.written))
                              .expected("names as in Radar1.bandwidth or seed")
                              .hint("leave other columns out of the table"));
      else if (!column.unit.empty())
        expect_unit(axis, column.unit);
      units_.push_back(column.unit);
      axes.push_back(std::move(axis));
    }
    const auto known = [](const SweepAxis& axis) { return axis.field.field != nullptr; };
    // Not one column of a table: what the others are called is no news, and perhaps nobody's business.
    if (!axes.empty() && std::ranges::none_of(axes, known) && problems_.size() > 1) {
      problems_.front().count = problems_.size();
      problems_.resize(1);
    }
    if (!problems_.empty()) axes.clear();
    return axes;
  }

  void name(SweepAxis& axis, std::string_view value) const {
    SweptField swept = find_swept_field(things_, axis.name, value);
    axis.field = std::move(swept.named);
    axis.let = std::move(swept.let);
  }

  // Units stand in brackets at the end of a name.
  void expect_whole_brackets(const scene::TableLine& line) {
    for (const std::string_view cell : line.cells) {
      const std::size_t open = cell.find_first_of("[(");
      if (open == std::string_view::npos || problems_.size() >= max_told) continue;
      const std::size_t close = cell.find(cell[open] == '[' ? ']' : ')', open);
      if (close == cell.size() - 1) continue;
      tell(line.number, core::error(close == std::string_view::npos ? "the bracket of a unit is not closed"
                                                                    : "something follows a unit's bracket")
                            .found(core::quoted_word(cell))
                            .expected("a name and its unit, as in Target1.x [m]"));
    }
  }

  void expect_unit(const SweepAxis& axis, const std::string& unit) {
    const std::string found = core::clipped(fmt::format("{} [{}]", axis.name, unit));
    if (!axis.is_number() || axis.is_seed())
      return tell(heading_line_,
                  core::error(fmt::format("{} has no unit", axis.name)).found(found).expected(axis.name + " alone"));
    if (const scene::QuantityReading one = scene::read_quantity("1 " + unit, axis.field.field->quantity); !one.value)
      tell(heading_line_,
           core::error(fmt::format("{}: the unit does not fit: {}", axis.name, one.failure)).found(found));
  }

  void add_line(const scene::TableLine& line, ValueTable& table) {
    std::vector<SweepAxis>& axes = table.axes;
    if (line.cells.size() != axes.size()) {
      tell(line.number, core::error("a line has another number of values than there are columns")
                            .found(core::counted(line.cells.size(), "value"))
                            .expected(fmt::format("{}", axes.size())));
      return;
    }
    table.lines.push_back(line.number);
    for (std::size_t i = 0; i < axes.size(); ++i) add_cell(line, std::string(line.cells[i]), units_[i], axes[i]);
  }

  void add_cell(const scene::TableLine& line, std::string cell, const std::string& unit, SweepAxis& axis) {
    // The heading alone does not tell "carrier", a number, from the kind of carrier of the same name.
    if (axis.values.empty()) name(axis, cell);
    std::string failure = cell.empty() ? "a value is missing" : axis.field.failure;
    if (failure.empty() && axis.is_number() && !axis.is_seed()) {
      if (scene::number_length(cell) == cell.size()) cell += unit;
      failure = scene::read_quantity(cell, axis.field.field->quantity).failure;
    } else if (failure.empty() && !unit.empty()) {
      failure = fmt::format("'{}' is not a number in {}", core::quoted_word(cell), unit);
    }
    if (!failure.empty() && problems_.size() < max_told)
      tell(line.number, core::error(fmt::format("{}: {}", axis.name, failure)));
    axis.values.push_back(std::move(cell));
  }

  const NamedThings& things_;
  std::string file_;
  core::Problems& problems_;
  std::vector<std::string> units_;
  std::size_t heading_line_ = 0;
};

}  // namespace

ValueTable read_value_table(const NamedThings& things, const std::filesystem::path& file, core::Problems& problems) {
  auto read = read_table_text(file, {"the table of values", std::uint64_t{1} << 28, ""});
  if (auto* failure = std::get_if<core::Problem>(&read)) {
    problems.push_back(std::move(*failure));
    return {};
  }
  return TableReader(things, file.string(), problems).read(std::get<std::string>(read));
}

}  // namespace sarsim::workflow
