#include "workflow/input/target_tables.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "core/task/stop_points.hpp"
#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "scene/edit/import_targets.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::workflow {

namespace {

constexpr TableFileRules rules_of_targets{"the table of targets", std::uint64_t{1} << 30,
                                          "give it as positions = { file = ... }; in a .scr, as a $CLOUD"};

std::string platform_for(const TargetTable& table, const scene::Scene& scene) {
  if (!table.platform.empty()) return table.platform;
  return scene.targets.empty() ? scene::world_name() : *scene.targets.front().platform;
}

std::string listed_platforms(const scene::Scene& scene) {
  std::string names = "Earth";
  for (const scene::Platform& platform : scene.platforms)
    if (!core::equal_ignoring_case(platform.name, "Earth")) names += ", " + platform.name;
  return core::clipped(names);
}

// Looks at the bytes of a table one after the other.
class TextWatch {
 public:
  explicit TextWatch(const TableFileRules& rules) : rules_(rules) {}

  // What is wrong with the first bytes that are; the place has the line alone.
  std::optional<core::Problem> look_at(std::string_view piece) {
    for (const char c : piece) {
      if (c == '\0')
        return fault(fmt::format("{} is not text", rules_.name))
            .found("a byte that is zero")
            .expected("lines of text")
            .hint("save the table as text, in UTF-8");
      if (c == '\n') ++line_;
      length_ = c == '\n' || c == '\r' ? 0 : length_ + 1;
      if (length_ > longest_table_line)
        return fault(fmt::format("a line of {} is too long", rules_.name))
            .expected(fmt::format("{} bytes at most", longest_table_line))
            .hint("end each line with a line feed");
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] core::ProblemBuilder fault(std::string message) const {
    return core::error(std::move(message)).in({}, line_);
  }

  const TableFileRules& rules_;
  std::size_t line_ = 1;
  std::size_t length_ = 0;  // Of this line so far.
};

core::Problems add_table(const TargetTable& table, scene::Scene& scene, const core::StopFlag* stop) {
  auto read = read_table_text(table.file, rules_of_targets, stop);
  if (auto* failure = std::get_if<core::Problem>(&read)) {
    std::error_code none;
    if (!std::filesystem::exists(table.file, none) && table.file.string().find('=') != std::string::npos)
      failure->hint = fmt::format("the name before '=' is that of a platform: {}", listed_platforms(scene));
    return {std::move(*failure)};
  }
  scene::TargetImport import =
      scene::import_targets(std::get<std::string>(read), platform_for(table, scene), scene.world, stop);
  for (core::Problem& problem : import.problems) problem.place.file = table.file.string();
  if (import.targets.empty() && import.problems.empty())
    import.problems.push_back(core::error("the table holds no targets")
                                  .expected("lines of x, y, z and, where there is one, the cross-section")
                                  .in(table.file.string()));
  // Not one line of a table: the first of them says so, and the others are not told.
  if (import.targets.empty() && import.problems.size() > 1) {
    import.problems.front().count = import.problems.size();
    import.problems.resize(1);
  }
  std::ranges::move(import.targets, std::back_inserter(scene.targets));
  return std::move(import.problems);
}

}  // namespace

std::variant<std::string, core::Problem> read_table_text(const std::filesystem::path& file, const TableFileRules& rules,
                                                         const core::StopFlag* stop) {
  auto opened = core::InputFile::open(file);
  if (auto* failure = std::get_if<core::Problem>(&opened)) return std::move(*failure);
  const core::InputFile& input = std::get<core::InputFile>(opened);
  if (input.size() > rules.largest_bytes)
    return core::error(fmt::format("{} is too large", rules.name))
        .found(file.string())
        .expected(fmt::format("{} bytes at most", rules.largest_bytes))
        .hint(rules.too_large_hint);
  constexpr std::size_t piece_bytes = std::size_t{1} << 20;
  TextWatch watch(rules);
  std::string text;
  while (text.size() < input.size()) {
    core::end_if_asked(stop);
    const std::size_t begin = text.size();
    text.resize(std::min(static_cast<std::size_t>(input.size()), begin + piece_bytes));
    const std::span<char> piece = std::span(text).subspan(begin);
    input.read_all_at(begin, std::as_writable_bytes(piece));
    if (auto problem = watch.look_at({piece.data(), piece.size()})) {
      problem->place.file = file.string();
      return *std::move(problem);
    }
  }
  return text;
}

TargetTable target_table_of(const std::string& word, const scene::Scene& scene) {
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos && equals > 0)
    if (std::string name = word.substr(0, equals); scene::find_platform(scene, name) != scene::not_found)
      return {std::move(name), word.substr(equals + 1)};
  return {"", word};
}

core::Problems add_targets(const std::vector<TargetTable>& tables, scene::Scene& scene, const core::StopFlag* stop) {
  core::Problems problems;
  for (const TargetTable& table : tables) core::append(problems, add_table(table, scene, stop));
  return problems;
}

}  // namespace sarsim::workflow
