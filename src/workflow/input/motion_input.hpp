#pragma once

#include <filesystem>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Reads the orbits and attitudes of the platforms of a scene that are not read yet, and turns them into its world:
/// file by file what `read_ephemeris`, `read_mean_elements` and `read_attitude` take; Path::orbit without a file. Mean
/// elements are evaluated around the times of the recordings. What is wrong is an error of its platform; the platform
/// then stays without path.
/// @param folder  of the script: where files are looked for first, as data files of functions are
[[nodiscard]] core::Problems read_motions(scene::Scene& scene, const std::filesystem::path& folder);

/// Everything that the objects of a scene take from files: `read_clouds`, `read_motions` and
/// `read_function_tables`.
[[nodiscard]] core::Problems read_files_of(scene::Scene& scene, const std::filesystem::path& folder,
                                           const core::WorkControl& control = {});

}  // namespace sarsim::workflow
