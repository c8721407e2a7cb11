#include "scene/edit/import_targets.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/limits.hpp"
#include "scene/schema/table_text.hpp"

namespace sarsim::scene {

namespace {

constexpr std::size_t most_line_problems = 100;  // more would only say the same again
constexpr std::size_t quantities = TargetColumns::quantities;

constexpr std::string_view decibel_name = "rcs_dbsm";

struct ColumnKind {
  std::string_view words;
  Quantity quantity;
  std::array<std::string_view, 7> names;
};
constexpr std::array<ColumnKind, quantities> table_kinds{
    {{"x", Quantity::length, {"x", "x_m", "x coordinate"}},
     {"y", Quantity::length, {"y", "y_m", "y coordinate"}},
     {"z", Quantity::length, {"z", "z_m", "z coordinate"}},
     {"cross-section",
      Quantity::area,
      {"rcs", "rcs_m2", decibel_name, "sigma", "radar cross section", "cross-section", "cross section"}}}};

core::Problem problem_of(core::Severity severity, const TableLine& line, std::string message, std::string found,
                         std::string expected) {
  constexpr std::size_t longest = 80;
  if (found.size() > longest) found.replace(longest, std::string::npos, "...");
  core::Problem problem;
  problem.severity = severity;
  problem.message = std::move(message);
  problem.found = std::move(found);
  problem.expected = std::move(expected);
  problem.place.line = line.number;
  return problem;
}

std::optional<std::size_t> kind_of(const ColumnHeading& heading) {
  for (std::size_t kind = 0; kind < quantities; ++kind)
    if (!heading.name.empty() &&
        std::ranges::find(table_kinds[kind].names, heading.name) != table_kinds[kind].names.end())
      return kind;
  return std::nullopt;
}

bool names_columns(const TableLine& line) {
  if (!is_heading(line)) return false;
  return std::ranges::any_of(headings_of(line),
                             [](const ColumnHeading& heading) { return kind_of(heading).has_value(); });
}

std::optional<core::Problem> take_column(TargetColumns& columns, const TableLine& line, std::size_t kind,
                                         std::size_t at, const ColumnHeading& heading) {
  if (columns.at[kind])
    return problem_of(core::Severity::error, line, fmt::format("two columns are named {}", table_kinds[kind].words),
                      std::string(line.text), "each name once");
  const std::string unit = heading.unit.empty() && heading.name == decibel_name ? "dBsm" : heading.unit;
  columns.at[kind] = at;
  columns.unit[kind] = unit;
  if (unit.empty() || read_quantity("1 " + unit, table_kinds[kind].quantity).value) return std::nullopt;
  std::string units;
  for (const std::string_view name : units_of(table_kinds[kind].quantity))
    units += fmt::format("{}{}", units.empty() ? "" : ", ", name);
  return problem_of(core::Severity::error, line,
                    fmt::format("the unit of column {} is not known", table_kinds[kind].words), unit, units);
}

class Importer {
 public:
  Importer(TargetImport& import, const std::string& platform) : import_(import), platform_(platform) {}

  void read(const std::vector<TableLine>& lines) {
    if (!lines.empty()) columns_ = target_columns(lines.front(), import_.problems);
    if (core::has_errors(import_.problems)) return;
    import_.targets.reserve(lines.size());
    for (std::size_t i = columns_.heading ? 1 : 0; i < lines.size(); ++i) read_line(lines[i]);
    report_rest();
  }

 private:
  void read_line(const TableLine& line) {
    const TargetLine read = read_target_line(line, columns_);
    if (!read.message.empty())
      return add(problem_of(core::Severity::error, line, read.message, read.found,
                            "x, y, z and, where there is one, the cross-section"));
    const auto& values = read.values;
    if (line.cells.size() > columns_.count && more_cells_++ == 0) first_longer_ = line;
    Target target;
    target.platform = platform_;
    target.position_m = {values[0], values[1], values[2]};
    target.rcs_m2 = values[3];
    import_.targets.push_back(std::move(target));
  }

  void add(core::Problem problem) {
    if (import_.problems.size() < most_line_problems)
      import_.problems.push_back(std::move(problem));
    else
      ++unsaid_;
  }

  void report_rest() {
    if (unsaid_ > 0) {
      core::Problem& last = import_.problems.back();
      last.hint = fmt::format("{} more lines could not be read.", unsaid_);
    }
    if (more_cells_ == 0) return;
    core::Problem problem =
        problem_of(core::Severity::warning, first_longer_,
                   fmt::format("columns behind the {} expected are ignored", columns_.count),
                   std::string(first_longer_.text), "x, y, z and, where there is one, the cross-section");
    problem.count = more_cells_;
    import_.problems.push_back(std::move(problem));
  }

  TargetImport& import_;
  const std::string& platform_;
  TargetColumns columns_;
  std::size_t unsaid_ = 0;
  std::size_t more_cells_ = 0;
  TableLine first_longer_;
};

}  // namespace

TargetColumns target_columns(const TableLine& line, core::Problems& problems) {
  TargetColumns columns;
  columns.heading = names_columns(line);
  if (!columns.heading) return columns;
  columns.at.fill(std::nullopt);
  const std::vector<ColumnHeading> headings = headings_of(line);
  columns.count = headings.size();
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto kind = kind_of(headings[i]);
    if (!kind) continue;  // a column of something else
    if (auto problem = take_column(columns, line, *kind, i, headings[i])) problems.push_back(std::move(*problem));
  }
  for (std::size_t kind = 0; kind < 3; ++kind)
    if (!columns.at[kind])
      problems.push_back(problem_of(core::Severity::error, line,
                                    fmt::format("the names of the columns do not include {}", table_kinds[kind].words),
                                    std::string(line.text), "x, y, z and, where there is one, rcs"));
  return columns;
}

TargetLine read_target_line(const TableLine& line, const TargetColumns& columns) {
  TargetLine read;
  for (std::size_t kind = 0; kind < quantities && read.message.empty(); ++kind) {
    const auto at = columns.at[kind];
    const bool empty = !at || *at >= line.cells.size() || line.cells[*at].empty();
    if (empty && kind == 3) continue;
    if (empty) {
      read.message = fmt::format("{} is missing", table_kinds[kind].words);
      read.found = line.text;
      break;
    }
    const QuantityReading reading = read_cell(line.cells[*at], table_kinds[kind].quantity, columns.unit[kind]);
    if (!reading.value)
      read.message = fmt::format("{}: {}", table_kinds[kind].words, reading.failure);
    else if (!computable(*reading.value))
      read.message = fmt::format("{} is too large to compute with", table_kinds[kind].words);
    if (!read.message.empty()) read.found = line.cells[*at];
    read.values[kind] = reading.value.value_or(0.0);
  }
  return read;
}

TargetImport import_targets(std::string_view text, const std::string& platform) {
  TargetImport import;
  Importer(import, platform).read(table_lines(text));
  return import;
}

std::string targets_text(const std::vector<Target>& targets) {
  std::string text = "x [m]\ty [m]\tz [m]\trcs [m2]\n";
  for (const Target& target : targets) {
    const core::Vec3& at = target.position_m;
    text += core::format_number(at.x) + '\t' + core::format_number(at.y) + '\t' + core::format_number(at.z) + '\t' +
            core::format_number(target.rcs_m2) + '\n';
  }
  return text;
}

}  // namespace sarsim::scene
