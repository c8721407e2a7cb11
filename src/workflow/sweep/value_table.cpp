#include "workflow/sweep/value_table.hpp"

#include <span>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/text/counted.hpp"
#include "core/text/letters.hpp"
#include "scene/schema/table_text.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t largest_bytes = std::uint64_t{1} << 28;
constexpr std::size_t most_told = 20;

// Reads the lines of a table into the axes of its columns.
class TableReader {
 public:
  TableReader(const scene::Scene& scene, std::string file, core::Problems& problems)
      : scene_(scene), file_(std::move(file)), problems_(problems) {}

  std::vector<SweepAxis> read(std::string_view text) {
    const std::vector<scene::TableLine> lines = scene::table_lines(text);
    if (lines.size() < 2) {
      tell(0, "the table has no values", {}, "a line of names of fields, then a line for each variation");
      return {};
    }
    if (lines.size() - 1 > most_variations) {
      tell(lines.back().number, "the table has too many lines", core::counted(lines.size() - 1, "line"),
           fmt::format("{} at most", most_variations));
      return {};
    }
    std::vector<SweepAxis> axes = axes_of(lines[0]);
    for (std::size_t i = 1; i < lines.size() && !axes.empty() && problems_.size() < most_told; ++i)
      add_line(lines[i], axes);
    return axes;
  }

 private:
  void tell(std::size_t line, std::string message, std::string found, std::string expected, std::string hint = {}) {
    core::Problem problem = core::problem_of(core::Severity::error, std::move(message), std::move(found),
                                             std::move(expected), std::move(hint));
    problem.place = {file_, line, 0};
    problems_.push_back(std::move(problem));
  }

  std::vector<SweepAxis> axes_of(const scene::TableLine& line) {
    std::vector<SweepAxis> axes;
    for (const scene::ColumnHeading& column : scene::headings_of(line)) {
      SweepAxis axis;
      axis.name = column.written;
      axis.field = scene::find_named_field(scene_, axis.name, column.unit.empty() ? "" : "0");
      if (axis.field.field == nullptr)
        tell(line.number, "a column is not named after a field: " + axis.field.failure, std::string(column.written),
             "names as in Radar1.bandwidth or seed", "leave other columns out of the table");
      units_.push_back(column.unit);
      axes.push_back(std::move(axis));
    }
    if (!problems_.empty()) axes.clear();
    return axes;
  }

  void add_line(const scene::TableLine& line, std::vector<SweepAxis>& axes) {
    if (line.cells.size() != axes.size()) {
      tell(line.number, "a line has another number of values than there are columns",
           core::counted(line.cells.size(), "value"), fmt::format("{}", axes.size()));
      return;
    }
    for (std::size_t i = 0; i < axes.size(); ++i) add_cell(line, std::string(line.cells[i]), units_[i], axes[i]);
  }

  void add_cell(const scene::TableLine& line, std::string cell, const std::string& unit, SweepAxis& axis) {
    // The heading alone does not tell "carrier", a number, from the kind of carrier of the same name.
    if (axis.values.empty()) axis.field = scene::find_named_field(scene_, axis.name, cell);
    std::string failure = cell.empty() ? "a value is missing" : axis.field.failure;
    if (failure.empty() && axis.is_number() && !axis.is_seed()) {
      if (scene::number_length(cell) == cell.size()) cell += unit;
      failure = scene::read_quantity(cell, axis.field.field->quantity).failure;
    }
    if (!failure.empty()) tell(line.number, fmt::format("{}: {}", axis.name, failure), {}, {});
    axis.values.push_back(std::move(cell));
  }

  const scene::Scene& scene_;
  std::string file_;
  core::Problems& problems_;
  std::vector<std::string> units_;
};

}  // namespace

std::vector<SweepAxis> read_value_table(const scene::Scene& scene, const std::filesystem::path& file,
                                        core::Problems& problems) {
  auto opened = core::InputFile::open(file);
  if (auto* failure = std::get_if<core::Problem>(&opened)) {
    problems.push_back(std::move(*failure));
    return {};
  }
  const core::InputFile& input = std::get<core::InputFile>(opened);
  if (input.size() > largest_bytes) {
    problems.push_back(core::problem_of(core::Severity::error, "the table of values is too large", file.string(),
                                        fmt::format("{} bytes at most", largest_bytes), {}));
    return {};
  }
  std::string text(static_cast<std::size_t>(input.size()), '\0');
  input.read_all_at(0, std::as_writable_bytes(std::span(text)));
  return TableReader(scene, file.string(), problems).read(text);
}

}  // namespace sarsim::workflow
