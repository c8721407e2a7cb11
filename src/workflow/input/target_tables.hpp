#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// A table of targets that is added to a scene: "points.csv", or "Ship=points.csv" for those of a platform.
struct TargetTable {
  std::string platform;  ///< Empty: that of the first target of the scene, or Earth.
  std::filesystem::path file;
};

/// What such a word means to a scene: what stands before the '=' is a platform only where the scene has it.
[[nodiscard]] TargetTable target_table_of(const std::string& word, const scene::Scene& scene);

/// Adds the targets of tables (scene/edit/import_targets.hpp) behind those of the scene.
/// @returns what is wrong, with file and line; such lines add nothing
[[nodiscard]] core::Problems add_targets(const std::vector<TargetTable>& tables, scene::Scene& scene);

}  // namespace sarsim::workflow
