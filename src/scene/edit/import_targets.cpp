#include "scene/edit/import_targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/model/limits.hpp"
#include "scene/model/world_frame.hpp"
#include "scene/schema/table_text.hpp"

namespace sarsim::scene {

namespace {

constexpr std::size_t max_line_problems = 100;  // more would only say the same again
constexpr std::size_t quantities = TargetColumns::quantities;

constexpr std::string_view decibel_name = "rcs_dbsm";

struct ColumnKind {
  std::string_view words;
  Quantity quantity;
  std::array<std::string_view, 7> names;
};
using ColumnKinds = std::array<ColumnKind, quantities>;
constexpr ColumnKind cross_section{
    "cross-section",
    Quantity::area,
    {"rcs", "rcs_m2", decibel_name, "sigma", "radar cross section", "cross-section", "cross section"}};
constexpr ColumnKinds cartesian_kinds{{{"x", Quantity::length, {"x", "x_m", "x coordinate"}},
                                       {"y", Quantity::length, {"y", "y_m", "y coordinate"}},
                                       {"z", Quantity::length, {"z", "z_m", "z coordinate"}},
                                       cross_section}};
constexpr ColumnKinds geodetic_kinds{
    {{"latitude", Quantity::angle, {"latitude", "latitude_deg", "lat", "lat_deg"}},
     {"longitude", Quantity::angle, {"longitude", "longitude_deg", "lon", "lon_deg", "long"}},
     {"height", Quantity::length, {"height", "height_m", "ellipsoidal height", "h", "h_m"}},
     cross_section}};

const ColumnKinds& kinds_of(const TargetColumns& columns) {
  return columns.geodetic ? geodetic_kinds : cartesian_kinds;
}

core::Problem problem_of(core::Severity severity, const TableLine& line, std::string message, std::string found,
                         std::string expected) {
  constexpr std::size_t longest = 80;
  if (found.size() > longest) found.replace(longest, std::string::npos, "...");
  core::Problem problem =
      core::ProblemBuilder(severity, std::move(message)).found(std::move(found)).expected(std::move(expected));
  problem.place.line = line.number;
  return problem;
}

std::optional<std::size_t> kind_of(const ColumnHeading& heading, const ColumnKinds& meant) {
  for (std::size_t kind = 0; kind < quantities; ++kind)
    if (!heading.name.empty() && std::ranges::find(meant[kind].names, heading.name) != meant[kind].names.end())
      return kind;
  return std::nullopt;
}

// The unit that a name ends in: "rcs_dbsm" is in dBsm; empty where it has none.
std::string_view unit_in_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> endings{
      {{"_dbsm", "dBsm"}, {"_m2", "m2"}, {"_deg", "deg"}, {"_m", "m"}}};
  const auto found = std::ranges::find_if(endings, [&](const auto& ending) { return name.ends_with(ending.first); });
  return found == endings.end() ? std::string_view() : found->second;
}

// How many of the first `count` quantities are named.
std::size_t named(const std::vector<ColumnHeading>& headings, const ColumnKinds& meant, std::size_t count) {
  std::array<bool, quantities> met{};
  for (const ColumnHeading& heading : headings)
    if (const auto kind = kind_of(heading, meant)) met[*kind] = true;
  return static_cast<std::size_t>(std::count(met.begin(), met.begin() + static_cast<std::ptrdiff_t>(count), true));
}

// A height alone may be anything's.
bool names_places(const std::vector<ColumnHeading>& headings) {
  return named(headings, geodetic_kinds, 2) > 0 && named(headings, cartesian_kinds, 3) < 3;
}

std::optional<core::Problem> take_column(TargetColumns& columns, const TableLine& line, std::size_t kind,
                                         std::size_t at, const ColumnHeading& heading) {
  const ColumnKind& meant = kinds_of(columns)[kind];
  if (columns.at[kind])
    return problem_of(core::Severity::error, line, fmt::format("two columns are named {}", meant.words),
                      core::quoted_word(line.text), "each name once");
  const std::string_view in_name = unit_in_name(heading.name);
  const std::string unit = heading.unit.empty() && heading.name == decibel_name ? "dBsm" : heading.unit;
  columns.at[kind] = at;
  columns.unit[kind] = unit;
  if (unit.empty()) return std::nullopt;
  if (const auto value = read_quantity("1 " + unit, meant.quantity).value) {
    if (in_name.empty() || *value == read_quantity(fmt::format("1 {}", in_name), meant.quantity).value)
      return std::nullopt;
    return problem_of(core::Severity::error, line,
                      fmt::format("name and unit of the column of {} contradict each other", meant.words),
                      fmt::format("{} [{}]", core::quoted_word(heading.written), core::quoted_word(unit)),
                      fmt::format("{}, or a name without a unit", in_name));
  }
  std::string units;
  for (const std::string_view name : units_of(meant.quantity))
    units += fmt::format("{}{}", units.empty() ? "" : ", ", name);
  return problem_of(core::Severity::error, line, fmt::format("the unit of column {} is not known", meant.words),
                    core::quoted_word(unit), units);
}

class Importer {
 public:
  Importer(TargetImport& import, const std::string& platform, const World& world)
      : import_(import), platform_(platform), world_(world) {}

  void read(std::string_view text, const core::StopFlag* stop, const core::ProgressReport& progress) {
    constexpr std::size_t between_looks = 1024;
    std::size_t lines = 0;
    each_table_line(text, [&](const TableLine& line) {
      if (lines % between_looks == 0) {
        if (stop != nullptr && stop->requested()) throw core::Interrupted();
        if (progress) progress({static_cast<std::size_t>(line.text.data() - text.data()), text.size()});
      }
      if (lines++ == 0) begin(line);
      if (!refused_ && (lines > 1 || !columns_.heading)) read_line(line);
    });
    if (!refused_) report_rest();
  }

 private:
  // What the first line says of the columns.
  void begin(const TableLine& line) {
    columns_ = target_columns(line, import_.problems);
    if (columns_.geodetic) {
      if (auto problem = problem_of_places(columns_, line, world_, *platform_))
        import_.problems.push_back(std::move(*problem));
      earth_ = earth_of(world_);
    }
    refused_ = core::has_errors(import_.problems);
  }

  void read_line(const TableLine& line) {
    const TargetLine read = read_target_line(line, columns_);
    if (!read.message.empty())
      return add(problem_of(core::Severity::error, line, read.message, read.found, columns_.words()));
    const auto& values = read.values;
    if (line.cells.size() > columns_.count && more_cells_++ == 0) first_longer_ = line;
    Target target;
    target.platform = platform_;
    target.position_m = {values[0], values[1], values[2]};
    if (earth_)
      target.position_m = earth_->world_of({core::rad_per_deg * values[0], core::rad_per_deg * values[1], values[2]});
    target.rcs_m2 = values[3];
    import_.targets.push_back(std::move(target));
  }

  void add(core::Problem problem) {
    if (import_.problems.size() < max_line_problems)
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
    core::Problem problem = problem_of(core::Severity::warning, first_longer_,
                                       fmt::format("columns behind the {} expected are ignored", columns_.count),
                                       core::quoted_word(first_longer_.text), columns_.words());
    problem.count = more_cells_;
    import_.problems.push_back(std::move(problem));
  }

  TargetImport& import_;
  SharedName platform_;
  const World& world_;
  std::optional<radar::EarthFrame> earth_;  // of geodetic places
  TargetColumns columns_;
  bool refused_ = false;  // for what the first line says
  std::size_t unsaid_ = 0;
  std::size_t more_cells_ = 0;
  TableLine first_longer_;
};

}  // namespace

std::string TargetColumns::words() const {
  return geodetic ? "latitude, longitude, height and, where there is one, the cross-section"
                  : "x, y, z and, where there is one, the cross-section";
}

TargetColumns target_columns(const TableLine& line, core::Problems& problems) {
  TargetColumns columns;
  if (!is_heading(line)) return columns;
  const std::vector<ColumnHeading> headings = headings_of(line);
  columns.geodetic = names_places(headings);
  const ColumnKinds& meant = kinds_of(columns);
  columns.heading = named(headings, meant, quantities) > 0;
  if (!columns.heading) return columns;
  columns.at.fill(std::nullopt);
  columns.count = headings.size();
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const auto kind = kind_of(headings[i], meant);
    if (!kind) continue;  // a column of something else
    if (auto problem = take_column(columns, line, *kind, i, headings[i])) problems.push_back(std::move(*problem));
  }
  for (std::size_t kind = 0; kind < 3; ++kind)
    if (!columns.at[kind])
      problems.push_back(problem_of(
          core::Severity::error, line, fmt::format("the names of the columns do not include {}", meant[kind].words),
          core::quoted_word(line.text),
          fmt::format("{}, {}, {} and, where there is one, rcs", meant[0].words, meant[1].words, meant[2].words)));
  return columns;
}

std::optional<core::Problem> problem_of_places(const TargetColumns& columns, const TableLine& line, const World& world,
                                               const std::string& platform) {
  if (!columns.geodetic) return std::nullopt;
  std::optional<core::Problem> problem;
  if (world.frame != World::Frame::earth) {
    problem = problem_of(core::Severity::error, line, "the world is flat and has no latitudes",
                         core::quoted_word(line.text), "columns x, y, z");
    problem->hint = "Latitudes need [world] frame = \"earth\" with an anchor.";
  } else if (!core::equal_ignoring_case(platform, "Earth")) {
    problem = problem_of(core::Severity::error, line, "places on the Earth cannot be those of a platform", platform,
                         "the platform Earth, or columns x, y, z in the platform's frame");
  }
  return problem;
}

TargetLine read_target_line(const TableLine& line, const TargetColumns& columns) {
  TargetLine read;
  const ColumnKinds& meant = kinds_of(columns);
  for (std::size_t kind = 0; kind < quantities && read.message.empty(); ++kind) {
    const auto at = columns.at[kind];
    const bool empty = !at || *at >= line.cells.size() || line.cells[*at].empty();
    if (empty && kind == 3) continue;
    if (empty) {
      read.message = fmt::format("{} is missing", meant[kind].words);
      read.found = core::quoted_word(line.text);
      break;
    }
    const QuantityReading reading = read_cell(line.cells[*at], meant[kind].quantity, columns.unit[kind]);
    if (!reading.value)
      read.message = fmt::format("{}: {}", meant[kind].words, reading.failure);
    else if (!computable(*reading.value))
      read.message = fmt::format("{} is too large to compute with", meant[kind].words);
    else if (columns.geodetic && kind == 0 && !(std::abs(*reading.value) <= 90.0))
      read.message = "latitude is beyond a pole";
    if (!read.message.empty()) read.found = core::quoted_word(line.cells[*at]);
    read.values[kind] = reading.value.value_or(0.0);
  }
  return read;
}

TargetImport import_targets(std::string_view text, const std::string& platform, const World& world,
                            const core::StopFlag* stop, const core::ProgressReport& progress) {
  TargetImport import;
  Importer(import, platform, world).read(text, stop, progress);
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
