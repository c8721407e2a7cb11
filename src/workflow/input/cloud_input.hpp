#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// More points of one cloud are no longer looked at one by one where a look is enough: by `check`, by the survey before
/// a run, by theory beside images. The echoes of a recording are those of all points.
inline constexpr std::size_t most_cloud_looks = 65'536;

/// Reads the tables of the clouds of a scene that are not read yet: each file once, on several threads. What is wrong
/// with a file is an error of its cloud, with row and column; the cloud then stays without points.
/// @param folder  of the script: where files are looked for first, as data files of functions are
[[nodiscard]] core::Problems read_clouds(scene::Scene& scene, const std::filesystem::path& folder,
                                         const core::WorkControl& control = {});

/// Number of the points of all clouds that are read.
[[nodiscard]] std::size_t cloud_points(const scene::Scene& scene);

}  // namespace sarsim::workflow
