#include "workflow/sweep/sweep_axes.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/hash/fnv1a.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/stop_points.hpp"
#include "core/text/counted.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "scene/schema/table_text.hpp"
#include "scene/schema/unit_table.hpp"
#include "scene/schema/value_list.hpp"
#include "scene/script/reader.hpp"
#include "workflow/input/bare_number.hpp"
#include "workflow/input/motion_input.hpp"
#include "workflow/input/target_tables.hpp"
#include "workflow/sweep/random_values.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// A table of values, and where they stand in its file.
struct ValueTable {
  std::vector<SweepAxis> axes;
  std::size_t heading_line = 0;         // Of the names; from 1.
  std::vector<std::size_t> lines = {};  // Of each value of every axis.
};

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

// Reads a table of values for a sweep: a first line of names of fields ("Target1.rcs", "let.speed", or "Target1.rcs
// [m2]" for numbers in that unit), then a line for each variation. Separators, comments and quotes as of
// scene/schema/table_text.hpp. What is wrong is added to `problems`, with its line; some twenty are the last.
ValueTable read_value_table(const NamedThings& things, const std::filesystem::path& file, core::Problems& problems) {
  auto read = read_table_text(file, {"the table of values", std::uint64_t{1} << 28, ""});
  if (auto* failure = std::get_if<core::Problem>(&read)) {
    problems.push_back(std::move(*failure));
    return {};
  }
  return TableReader(things, file.string(), problems).read(std::get<std::string>(read));
}

// Room for the temporary name and for the file system's own limit of 255 bytes.
constexpr std::size_t longest_name = 200;

// Of settings that are wrong; those behind them are not read.
constexpr std::size_t max_mistakes = 20;

const char* option_of(std::string_view setting) { return setting.starts_with(let_prefix) ? "" : "--set "; }

core::ProblemBuilder mistake_in(const std::string& setting, const std::string& message) {
  return core::error(fmt::format("{}{}: {}", option_of(setting), setting.substr(0, 80), message));
}

// The same word for the same value, another one for each other value.
std::vector<std::string> distinct_words(const std::vector<std::string>& values) {
  std::vector<std::string> words;
  std::set<std::string> taken;
  std::map<std::string, std::string> known;
  for (const std::string& value : values) {
    const auto [word, is_new] = known.try_emplace(value);
    if (is_new) {
      const std::string safe = safe_word(value);
      word->second = safe;
      for (int number = 2; !taken.insert(word->second).second; ++number)
        word->second = fmt::format("{}-{}", safe, number);
    }
    words.push_back(word->second);
  }
  return words;
}

// What random values of a field are drawn with: the field itself, however it is called.
std::string key_of(const scene::NamedField& named) {
  std::string key = named.field->id;
  for (const scene::ObjectId id : named.objects) key += fmt::format(" {}{}", scene::name_of(id.kind), id.index);
  return key;
}

// Changes where a file is written anew.
std::uint64_t stamp_of(const fs::path& file) {
  std::error_code failure;
  const auto size = fs::file_size(file, failure);
  const auto time = fs::last_write_time(file, failure);
  return core::fnv1a(failure ? "missing" : fmt::format("{} {}", size, time.time_since_epoch().count()));
}

std::uint64_t stamp_of(const std::vector<fs::path>& files) {
  std::uint64_t stamp = 1;
  for (const fs::path& file : files) stamp = core::fnv1a(fmt::format("{:016x}", stamp_of(file)), stamp);
  return stamp;
}

// "Radar1.bandwidth=10MHz,20MHz"; random values are not drawn yet.
std::optional<SweepAxis> axis_of(const NamedThings& things, const std::string& setting, core::Problems& problems) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    problems.push_back(
        mistake_in(setting, "there is no '='").hint("write OBJECT.FIELD=VALUES, as in Radar1.bandwidth=10MHz,20MHz"));
    return std::nullopt;
  }
  const std::string texts(core::trimmed(std::string_view(setting).substr(equals + 1)));
  SweepAxis axis;
  axis.name = core::trimmed(std::string_view(setting).substr(0, equals));
  SweptField swept = find_swept_field(things, axis.name, is_random(texts) ? "0" : texts);
  axis.field = std::move(swept.named);
  axis.let = std::move(swept.let);
  std::string failure = axis.field.failure;
  if (axis.field.field != nullptr && is_random(texts)) {
    axis.law = texts;
  } else if (axis.field.field != nullptr) {
    scene::ValueList list = scene::read_value_list(texts, *axis.field.field, max_variations);
    failure = std::move(list.failure);
    axis.values = std::move(list.texts);
  }
  if (failure.empty()) return axis;
  problems.push_back(mistake_in(setting, failure));
  return std::nullopt;
}

// Which axis sets a field first.
class Setters {
 public:
  // The axis that sets one of these fields already. Where there is none, `axis` sets them all from now on.
  std::optional<std::size_t> earlier(const scene::NamedField& named, std::size_t axis) {
    std::vector<scene::ObjectId> objects = named.objects;
    if (objects.empty()) objects.emplace_back();  // An option, whose field no object has.
    for (const scene::ObjectId object : objects)
      if (const auto known = axes_.find({named.field->id, object}); known != axes_.end()) return known->second;
    for (const scene::ObjectId object : objects) axes_.emplace(std::pair(named.field->id, object), axis);
    return std::nullopt;
  }

 private:
  std::map<std::pair<std::string, scene::ObjectId>, std::size_t> axes_;
};

// What two draws of one value are, of which no two variations can be made.
core::Problem equal_draws(const SweepAxis& axis, std::size_t first, std::size_t second) {
  const bool whole = axis.field.field->quantity == scene::Quantity::count;
  return core::error(
             fmt::format("--set {}={}: the values of this law do not differ enough: draws {} and {} are both {}",
                         axis.name, axis.law, first + 1, second + 1, axis.values[second]))
      .hint(fmt::format(
          "{}; use a wider law or fewer draws, or pair them with something that differs, as in --zip --set seed=1..N",
          whole ? "draws are rounded to whole numbers" : "draws have nine digits"));
}

// Whether an axis sets the field that a problem is about.
bool sets(const SweepAxis& axis, const core::Subject& subject) {
  const std::string_view id = axis.field.field->id;
  const bool field = id == subject.field || (id.starts_with(subject.field) && id.size() > subject.field.size() &&
                                             id[subject.field.size()] == '.' && !subject.field.empty());
  if (axis.field.objects.empty()) return field && subject.kind == (axis.field.of_atmosphere ? "atmosphere" : "options");
  return field && std::ranges::any_of(axis.field.objects, [&](scene::ObjectId object) {
           return scene::name_of(object.kind) == subject.kind && object.index == subject.index;
         });
}

}  // namespace

std::string safe_word(const std::string& text) {
  std::string word;
  for (const char c : text) {
    const bool plain = core::is_digit(c) || core::is_letter(c) || static_cast<unsigned char>(c) >= 0x80 ||
                       std::string_view("._+=-").find(c) != std::string_view::npos;
    if (c == ' ') continue;
    word += plain ? c : '-';
  }
  return word.empty() ? "-" : word;
}

std::string SweepAxis::unit() const {
  if (!is_number()) return {};
  const auto units = scene::units_of(field.field->quantity);
  return units.empty() ? std::string() : std::string(units.front());
}

bool SweepAxis::names_files() const {
  if (field.field->kind == scene::FieldKind::function) return true;
  return field.field->id == "file" && !field.objects.empty() && field.objects.front().kind == scene::ObjectKind::cloud;
}

std::string SweepAxis::table_text(std::size_t value) const {
  const std::string& text = values.at(value);
  if (!is_number() || is_seed()) return text;
  const scene::QuantityReading reading = scene::read_quantity(text, field.field->quantity);
  return reading.value ? core::format_number(*reading.value) : text;
}

std::string SweepAxis::let_word(std::size_t value) const {
  return fmt::format("{}={}", name.substr(let_prefix.size()), values.at(value));
}

Sweep::Sweep(const scene::Scene& scene, const SweepValues& values, SceneSource source)
    : source_(std::move(source)), folder_(values.folder), table_(values.table) {
  if (values.settings.empty() && values.table.empty())
    throw core::InvalidRequest("sweep: nothing varies",
                               "say what does with --set, for instance --set seed=1..10, or with --values FILE.csv");
  core::Problems problems;
  read_axes(scene, values, problems);
  group_axes(values.paired);
  if (problems.empty()) draw(scene.options.seed, values, problems);
  if (problems.empty()) set_size(problems);
  name_values(problems);
  if (!problems.empty()) throw core::InvalidRequest(std::move(problems));
  look_at_source();
}

void Sweep::look_at_source() {
  if (std::ranges::any_of(axes_, [](const SweepAxis& axis) { return axis.let != nullptr; }))
    source_stamp_ = stamp_of(source_.files);
}

void Sweep::read_axes(const scene::Scene& scene, const SweepValues& values, core::Problems& problems) {
  Setters setters;
  // @param again  the mistake, where the field is set already; its message is only begun
  const auto add = [&](SweepAxis axis, core::Problem again) {
    if (const auto earlier = setters.earlier(axis.field, axes_.size())) {
      const SweepAxis& other = axes_[*earlier];
      again.message += fmt::format("this field is set by {} already", other.name);
      if (other.of_table) again.hint = fmt::format("in line {} of '{}'", heading_line_, table_.string());
      problems.push_back(std::move(again));
    } else {
      axes_.push_back(std::move(axis));
    }
  };
  if (!values.table.empty()) {
    ValueTable table = read_value_table({scene, source_.names}, values.table, problems);
    heading_line_ = table.heading_line;
    table_lines_ = std::move(table.lines);
    for (SweepAxis& axis : table.axes) {
      if (problems.size() >= max_mistakes) return;
      axis.of_table = true;
      core::Problem again = core::error(axis.name + ": ").in(table_.string(), heading_line_);
      add(std::move(axis), std::move(again));
    }
  }
  for (const std::string& setting : values.settings) {
    if (problems.size() >= max_mistakes) return;
    if (std::optional<SweepAxis> axis = axis_of({scene, source_.names}, setting, problems))
      add(*std::move(axis), mistake_in(setting, ""));
  }
}

void Sweep::group_axes(bool paired) {
  std::optional<std::size_t> of_table;
  std::optional<std::size_t> drawn;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    std::optional<std::size_t> alone;
    std::optional<std::size_t>& group = paired || axes_[i].of_table ? of_table : axes_[i].law.empty() ? alone : drawn;
    if (!group) {
      group = groups_.size();
      groups_.emplace_back();
    }
    groups_[*group].push_back(i);
  }
}

void Sweep::draw(std::uint64_t seed, const SweepValues& values, core::Problems& problems) {
  const bool random = std::ranges::any_of(axes_, [](const SweepAxis& axis) { return !axis.law.empty(); });
  const auto listed = std::ranges::find_if(axes_, [](const SweepAxis& axis) { return axis.law.empty(); });
  std::size_t count = values.draws;
  if (count == 0 && values.paired && listed != axes_.end()) count = listed->values.size();
  if (random && count == 0)
    problems.push_back(core::error("--set: it is not said how often random values are drawn")
                           .hint("add --draws N, or pair them with other values, as in --zip --set seed=1..N"));
  if (!random && count > 0 && values.draws > 0)
    problems.push_back(
        core::error("--draws: no value is random").hint("write one as in --set 'Target1.rcs=normal(1, 0.2)'"));
  for (SweepAxis& axis : axes_) {
    if (axis.law.empty() || !problems.empty()) continue;
    scene::ValueList list = draw_values(axis.law, *axis.field.field, count, seed, key_of(axis.field));
    if (!list.failure.empty()) problems.push_back(mistake_in(axis.name + "=" + axis.law, list.failure));
    axis.values = std::move(list.texts);
  }
}

void Sweep::set_size(core::Problems& problems) {
  double size = 1.0;
  for (const std::vector<std::size_t>& group : groups_) {
    const SweepAxis& first = axes_[group.front()];
    for (const std::size_t i : group)
      if (axes_[i].values.size() != first.values.size() && problems.size() < max_mistakes)
        problems.push_back(mistake_in(
            axes_[i].name,
            fmt::format("with --zip all lists are of one length; this one has {} values and that of {} has {}",
                        axes_[i].values.size(), first.name, first.values.size())));
    size *= static_cast<double>(first.values.size());
  }
  if (size > static_cast<double>(max_variations)) {
    problems.push_back(core::error(fmt::format("the sweep would have {:.0f} variations", size))
                           .hint("vary less at once, or pair the values with --zip"));
    problems.back().expected = fmt::format("{} at most", max_variations);
  }
  if (!problems.empty()) return;
  size_ = 1;
  for (std::size_t group = groups_.size(); group-- > 0;) {
    for (const std::size_t i : groups_[group]) axes_[i].stride = size_;
    size_ *= axes_[groups_[group].front()].values.size();
  }
}

void Sweep::name_values(core::Problems& problems) {
  for (SweepAxis& axis : axes_) {
    axis.words = distinct_words(axis.values);
    if (!axis.names_files()) continue;
    for (const std::string& value : axis.values)
      axis.stamps.push_back(stamp_of(scene::data_file_on_disk(folder_, value)));
  }
  for (const std::vector<std::size_t>& group : groups_) {
    if (problems.size() >= max_mistakes) return;
    refuse_repetition(group, problems);
  }
}

// Two variations of the same values would have files of one name.
void Sweep::refuse_repetition(const std::vector<std::size_t>& group, core::Problems& problems) const {
  const auto length = [&](std::size_t i) { return axes_[i].values.size(); };
  if (std::ranges::any_of(group, [&](std::size_t i) { return length(i) != length(group.front()); })) return;
  std::map<std::string, std::size_t> known;
  for (std::size_t number = 0; number < axes_[group.front()].values.size(); ++number) {
    std::string values;
    for (const std::size_t i : group) values += fmt::format("{}={} ", axes_[i].name, axes_[i].values[number]);
    values.pop_back();
    const auto [first, is_new] = known.try_emplace(values, number);
    if (is_new) continue;
    problems.push_back(repetition(group, first->second, number));
    return;
  }
}

core::Problem Sweep::repetition(const std::vector<std::size_t>& group, std::size_t first, std::size_t second) const {
  const SweepAxis& axis = axes_[group.front()];
  if (group.size() == 1 && !axis.law.empty()) return equal_draws(axis, first, second);
  if (group.size() == 1) {
    core::Problem problem = mistake_of(axis, second, "the value is given twice");
    problem.hint = axis.of_table ? fmt::format("it is on line {}, too", table_lines_.at(first))
                                 : "values of several fields that are paired (--zip) may be repeated";
    return problem;
  }
  std::string values;
  for (const std::size_t i : group)
    values += fmt::format("{}{}={}", values.empty() ? "" : " ", axes_[i].name, axes_[i].values[second]);
  core::Problem problem =
      core::error(fmt::format("variations {} and {} have the same values: {}", first + 1, second + 1, values))
          .hint("pair them with something that differs, as in --zip --set seed=1..N");
  if (std::ranges::all_of(group, [this](std::size_t i) { return !axes_[i].law.empty(); }))
    problem.hint =
        "the values of these laws do not differ enough: draws have nine digits, or are whole numbers; " + problem.hint;
  for (const std::size_t i : group)
    if (axes_[i].of_table) problem.place = place_of_value(axes_[i], second);
  if (std::ranges::all_of(group, [this](std::size_t i) { return axes_[i].of_table; }))
    problem.hint = fmt::format("they are on line {}, too", table_lines_.at(first));
  return problem;
}

core::Place Sweep::place_of_value(const SweepAxis& axis, std::size_t value) const {
  if (!axis.of_table) return {};
  return {table_.string(), table_lines_.at(value), 0};
}

// Of a value of the table, its file and line say where it stands.
core::Problem Sweep::mistake_of(const SweepAxis& axis, std::size_t value, const std::string& message) const {
  const std::string setting = axis.name + "=" + axis.values.at(value);
  if (!axis.of_table) return mistake_in(setting, message);
  return core::error(fmt::format("{}: {}", core::clipped(setting), message)).in(place_of_value(axis, value));
}

std::size_t Sweep::value_of(std::size_t variation, std::size_t axis) const {
  return variation / axes_[axis].stride % axes_[axis].values.size();
}

std::string Sweep::label(std::size_t variation) const {
  std::vector<std::string> settings;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    settings.push_back(fmt::format("{}={}", axes_[i].name, axes_[i].values[value_of(variation, i)]));
  return fmt::format("{}", fmt::join(settings, " "));
}

void Sweep::add_to(SceneOverrides& overrides, std::size_t variation) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const SweepAxis& axis = axes_[i];
    const std::size_t value = value_of(variation, i);
    if (axis.let != nullptr)
      overrides.let.push_back(axis.let_word(value));
    else
      overrides.settings.push_back(fmt::format("{}={}", axis.name, axis.values[value]));
  }
}

std::string Sweep::file_name(const std::string& stem, const std::string& extension, std::size_t variation) const {
  std::string values;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    values += fmt::format("_{}={}", safe_word(axes_[i].name), axes_[i].words[value_of(variation, i)]);
  const std::string safe = safe_word(stem);
  if (safe.size() + values.size() + extension.size() <= longest_name) return safe + values + extension;
  return fmt::format("{}_{:016x}{}", safe.substr(0, longest_name / 2), core::fnv1a(values, core::fnv1a(safe)),
                     extension);
}

scene::Scene Sweep::scene(const scene::Scene& base, std::size_t variation, core::Problems& problems,
                          const core::StopFlag* stop) const {
  core::end_if_asked(stop);
  scene::Scene scene = source_stamp_ == 0 ? base : read_anew(variation, problems, stop);
  if (!problems.empty()) return scene;
  const scene::PointsLoader load = scene::disk_points(folder_);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i].let != nullptr) continue;
    const std::size_t value = value_of(variation, i);
    const std::string failure = scene::set_named_field(scene, axes_[i].field, axes_[i].values[value], load);
    if (!failure.empty()) problems.push_back(mistake_of(axes_[i], value, failure));
  }
  if (!problems.empty()) return scene;
  // Warnings about files are those of the scene, said before the sweep.
  problems = read_files_of(scene, folder_, {1, stop});
  std::erase_if(problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
  return scene;
}

// The text says what follows from a name of [let].
scene::Scene Sweep::read_anew(std::size_t variation, core::Problems& problems, const core::StopFlag* stop) const {
  SceneOverrides overrides = source_.overrides;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i].let != nullptr) overrides.let.push_back(axes_[i].let_word(value_of(variation, i)));
  try {
    SceneInput input = read_scene(source_.file, overrides, CheckLevel::reading, {1, stop});
    std::erase_if(input.problems, [](const core::Problem& p) { return p.severity != core::Severity::error; });
    problems = std::move(input.problems);
    if (stamp_of(source_.files) != source_stamp_)
      problems.push_back(
          core::error(fmt::format("'{}' or a file that it names has changed since the sweep began", source_.file))
              .hint("start the sweep again"));
    return std::move(input.scene);
  } catch (core::InvalidRequest& refused) {
    problems = std::move(refused.problems);
    return {};
  }
}

std::uint64_t Sweep::stamp(std::size_t variation) const {
  std::uint64_t stamp = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (!axes_[i].stamps.empty())
      stamp = core::fnv1a(fmt::format("{:016x}", axes_[i].stamps[value_of(variation, i)]), stamp);
  return stamp;
}

std::vector<fs::path> Sweep::sources() const {
  std::vector<fs::path> sources;
  if (!table_.empty()) sources.push_back(table_);
  for (const SweepAxis& axis : axes_) {
    if (!axis.names_files()) continue;
    for (const std::string& value : axis.values)
      if (fs::path file = scene::data_file_on_disk(folder_, value); !file.empty()) sources.push_back(std::move(file));
  }
  return sources;
}

bool Sweep::varies(const core::Subject& subject) const {
  return std::ranges::any_of(axes_, [&](const SweepAxis& axis) { return sets(axis, subject); });
}

core::Place Sweep::place_of(const core::Subject& subject, std::size_t variation) const {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i].of_table && sets(axes_[i], subject)) return place_of_value(axes_[i], value_of(variation, i));
  return {};
}

core::Problems Sweep::remarks(const scene::Scene& scene) const {
  core::Problems remarks;
  for (const SweepAxis& axis : axes_) {
    if (axis.let != nullptr) continue;
    for (std::size_t value = 0; value < axis.values.size(); ++value)
      if (auto remark = remark_on_bare_number(scene, axis.field, axis.name, axis.values[value])) {
        constexpr std::string_view option = "--set ";
        if (axis.of_table && remark->message.starts_with(option)) remark->message.erase(0, option.size());
        remark->place = place_of_value(axis, value);
        remarks.push_back(*std::move(remark));
        break;
      }
  }
  return remarks;
}

std::size_t Sweep::first_alike(std::size_t variation) const {
  for (const std::vector<std::size_t>& group : groups_)
    if (const std::size_t i = group.front(); group.size() == 1 && axes_[i].is_seed())
      return variation - value_of(variation, i) * axes_[i].stride;
  return variation;
}

}  // namespace sarsim::workflow
