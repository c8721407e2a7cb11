#include "workflow/input/target_tables.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <variant>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "scene/edit/import_targets.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::workflow {

namespace {

constexpr std::uint64_t largest_bytes = std::uint64_t{1} << 30;

std::string platform_for(const TargetTable& table, const scene::Scene& scene) {
  if (!table.platform.empty()) return table.platform;
  return scene.targets.empty() ? scene::Target().platform : scene.targets.front().platform;
}

core::Problems add_table(const TargetTable& table, scene::Scene& scene) {
  auto opened = core::InputFile::open(table.file);
  if (auto* failure = std::get_if<core::Problem>(&opened)) return {std::move(*failure)};
  const core::InputFile& input = std::get<core::InputFile>(opened);
  if (input.size() > largest_bytes)
    return {core::problem_of(core::Severity::error, "the table of targets is too large", table.file.string(),
                             fmt::format("{} bytes at most", largest_bytes), "make a $CLOUD of it")};
  std::string text(static_cast<std::size_t>(input.size()), '\0');
  input.read_all_at(0, std::as_writable_bytes(std::span(text)));
  scene::TargetImport import = scene::import_targets(text, platform_for(table, scene));
  for (core::Problem& problem : import.problems) problem.place.file = table.file.string();
  if (import.targets.empty() && import.problems.empty()) {
    import.problems.push_back(core::problem_of(core::Severity::error, "the table holds no targets", {},
                                               "lines of x, y, z and, where there is one, the cross-section", {}));
    import.problems.back().place.file = table.file.string();
  }
  std::ranges::move(import.targets, std::back_inserter(scene.targets));
  return std::move(import.problems);
}

}  // namespace

TargetTable target_table_of(const std::string& word, const scene::Scene& scene) {
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos && equals > 0)
    if (std::string name = word.substr(0, equals); scene::find_platform(scene, name) != scene::not_found)
      return {std::move(name), word.substr(equals + 1)};
  return {"", word};
}

core::Problems add_targets(const std::vector<TargetTable>& tables, scene::Scene& scene) {
  core::Problems problems;
  for (const TargetTable& table : tables) std::ranges::move(add_table(table, scene), std::back_inserter(problems));
  return problems;
}

}  // namespace sarsim::workflow
