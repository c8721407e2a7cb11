#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/stop.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// A table of targets that is added to a scene: "points.csv", or "Ship=points.csv" for those of a platform.
struct TargetTable {
  std::string platform;  ///< Empty: that of the first target of the scene, or Earth.
  std::filesystem::path file;
};

/// What such a word means to a scene: what stands before the '=' is a platform only where the scene has it.
[[nodiscard]] TargetTable target_table_of(const std::string& word, const scene::Scene& scene);

/// The bytes of a line of a table, at most.
inline constexpr std::size_t longest_table_line = 1'000'000;

/// What a file may be that holds a table.
struct TableFileRules {
  const char* name = "the table";  ///< For messages.
  std::uint64_t largest_bytes = std::uint64_t{1} << 30;
  const char* too_large_hint = "";  ///< What to do about a larger one.
};

/// The text of a table, or why there is none: the file cannot be read or is too large, has a byte that no text has
/// (zero), or a line of more than `longest_table_line` bytes. The file is read no further than the first of these.
/// A requested stop throws Interrupted.
[[nodiscard]] std::variant<std::string, core::Problem> read_table_text(const std::filesystem::path& file,
                                                                       const TableFileRules& rules,
                                                                       const core::StopFlag* stop = nullptr);

/// Adds the targets of tables (scene/edit/import_targets.hpp) behind those of the scene.
/// A requested stop throws Interrupted.
/// @returns what is wrong, with file and line; such lines add nothing
[[nodiscard]] core::Problems add_targets(const std::vector<TargetTable>& tables, scene::Scene& scene,
                                         const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow
