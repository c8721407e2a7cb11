#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "scene/scene.hpp"

namespace sarsim::cli {

/// Where products go.
struct OutputRules {
  std::filesystem::path folder = ".";
  bool keep_paths = false;           ///< Keep the folders that names hold; otherwise only the base name counts.
  std::optional<FileFormat> format;  ///< Of all recordings, instead of the script's: also changes the extension.
};

/// The files that a scene's products become: one path for each simulation, then one for each geometry table.
struct OutputNames {
  std::vector<std::filesystem::path> simulations;
  std::vector<std::filesystem::path> tables;
  Problems problems;  ///< Without places; the subjects say where.
};

/// Decides the files of all products of a scene. The base name after either kind of slash goes into the folder; of
/// several products with one name the second becomes name-2.ext and so on, with a warning here where `check` has none:
/// when a change of format or another product's number makes names alike. A name without a base name is an error.
[[nodiscard]] OutputNames output_names(const Scene& scene, const OutputRules& rules);

/// Problems that keep a file from being made there: a file that exists (unless `force`), a folder of that name, the
/// file that it is made from.
[[nodiscard]] Problems problems_of_output(const std::filesystem::path& path, const std::filesystem::path& source,
                                          bool force);

/// Base name after the last slash of either kind and after a drive letter.
[[nodiscard]] std::string base_name(const std::string& name);

}  // namespace sarsim::cli
