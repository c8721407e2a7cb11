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
constexpr std::size_t quantities = 4;

struct ColumnKind {
  std::string_view words;
  Quantity quantity;
  std::array<std::string_view, 6> names;
};
constexpr std::array<ColumnKind, quantities> kinds{
    {{"x", Quantity::length, {"x", "x_m", "x coordinate"}},
     {"y", Quantity::length, {"y", "y_m", "y coordinate"}},
     {"z", Quantity::length, {"z", "z_m", "z coordinate"}},
     {"cross-section",
      Quantity::area,
      {"rcs", "rcs_m2", "sigma", "radar cross section", "cross-section", "cross section"}}}};

// Where each quantity stands in a line, and in which unit.
struct Columns {
  std::array<std::optional<std::size_t>, quantities> at{0, 1, 2, 3};
  std::array<std::string, quantities> unit;
  std::size_t count = quantities;  // beyond this, cells are a surprise
};

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

class Importer {
 public:
  Importer(TargetImport& import, const std::string& platform) : import_(import), platform_(platform) {}

  void read(const std::vector<TableLine>& lines) {
    std::size_t first = 0;
    if (!lines.empty() && names_columns(lines.front())) {
      if (!read_heading(lines.front())) return;
      first = 1;
    }
    import_.targets.reserve(lines.size());
    for (std::size_t i = first; i < lines.size(); ++i) read_line(lines[i]);
    report_rest();
  }

 private:
  static bool names_columns(const TableLine& line) {
    if (!is_heading(line)) return false;
    return std::ranges::any_of(headings_of(line),
                               [](const ColumnHeading& heading) { return kind_of(heading).has_value(); });
  }

  static std::optional<std::size_t> kind_of(const ColumnHeading& heading) {
    for (std::size_t kind = 0; kind < quantities; ++kind)
      if (!heading.name.empty() && std::ranges::find(kinds[kind].names, heading.name) != kinds[kind].names.end())
        return kind;
    return std::nullopt;
  }

  bool read_heading(const TableLine& line) {
    columns_.at.fill(std::nullopt);
    const std::vector<ColumnHeading> headings = headings_of(line);
    columns_.count = headings.size();
    bool sound = true;
    for (std::size_t i = 0; i < headings.size(); ++i) {
      const auto kind = kind_of(headings[i]);
      if (!kind) continue;  // a column of something else
      sound = take_column(line, *kind, i, headings[i].unit) && sound;
    }
    for (std::size_t kind = 0; kind < 3; ++kind) {
      if (columns_.at[kind]) continue;
      sound = false;
      add(problem_of(core::Severity::error, line,
                     fmt::format("the names of the columns do not include {}", kinds[kind].words),
                     std::string(line.text), "x, y, z and, where there is one, rcs"));
    }
    return sound;
  }

  bool take_column(const TableLine& line, std::size_t kind, std::size_t at, const std::string& unit) {
    if (columns_.at[kind]) {
      add(problem_of(core::Severity::error, line, fmt::format("two columns are named {}", kinds[kind].words),
                     std::string(line.text), "each name once"));
      return false;
    }
    columns_.at[kind] = at;
    columns_.unit[kind] = unit;
    if (unit.empty() || read_quantity("1 " + unit, kinds[kind].quantity).value) return true;
    std::string units;
    for (const std::string_view name : units_of(kinds[kind].quantity))
      units += fmt::format("{}{}", units.empty() ? "" : ", ", name);
    add(problem_of(core::Severity::error, line, fmt::format("the unit of column {} is not known", kinds[kind].words),
                   unit, units));
    return false;
  }

  void read_line(const TableLine& line) {
    std::array<double, quantities> values{0.0, 0.0, 0.0, 1.0};
    std::string message;
    std::string found;
    for (std::size_t kind = 0; kind < quantities && message.empty(); ++kind) {
      const auto at = columns_.at[kind];
      const bool empty = !at || *at >= line.cells.size() || line.cells[*at].empty();
      if (empty && kind == 3) continue;
      if (empty) {
        message = fmt::format("{} is missing", kinds[kind].words);
        found = line.text;
        break;
      }
      const QuantityReading reading = read_cell(line.cells[*at], kinds[kind].quantity, columns_.unit[kind]);
      if (!reading.value)
        message = fmt::format("{}: {}", kinds[kind].words, reading.failure);
      else if (!computable(*reading.value))
        message = fmt::format("{} is too large to compute with", kinds[kind].words);
      if (!message.empty()) found = line.cells[*at];
      values[kind] = reading.value.value_or(0.0);
    }
    if (!message.empty())
      return add(problem_of(core::Severity::error, line, std::move(message), std::move(found),
                            "x, y, z and, where there is one, the cross-section"));
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
  Columns columns_;
  std::size_t unsaid_ = 0;
  std::size_t more_cells_ = 0;
  TableLine first_longer_;
};

}  // namespace

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
