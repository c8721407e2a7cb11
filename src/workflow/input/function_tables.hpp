#pragma once

#include <filesystem>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Reads the data files of functions that are HDF5: the dataset `/points` as a table (`scene::functions_of_table`). All
/// other data files are read together with the script. Faults of a table are errors of its object.
/// @param folder  of the script: where files are looked for first
[[nodiscard]] core::Problems read_function_tables(scene::Scene& scene, const std::filesystem::path& folder,
                                                  const core::WorkControl& control = {});

}  // namespace sarsim::workflow
