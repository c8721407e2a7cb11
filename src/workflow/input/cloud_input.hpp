#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// More points of one cloud are no longer looked at one by one where a look is enough: by `check`, by the survey before
/// a run, by theory beside images. The echoes of a recording are those of all points.
inline constexpr std::size_t max_cloud_looks = 65'536;

/// Reads the tables of the clouds of a scene that are not read yet: each file once, on several threads. What is wrong
/// with a file is an error of its cloud, with row and column; the cloud then stays without points.
/// @param folder  of the script: where files are looked for first, as data files of functions are
[[nodiscard]] core::Problems read_clouds(scene::Scene& scene, const std::filesystem::path& folder,
                                         const core::WorkControl& control = {});

/// A cloud of points in memory, as reading its file makes it.
/// @param file         that it names; it need not be there
/// @param positions_m  x, y and z of each, in the platform's frame
/// @param rcs_m2       of each; empty: 1 m2
/// @throws core::InvalidRequest without points, and for numbers that cannot be computed with
[[nodiscard]] scene::Cloud cloud_of_points(const std::string& platform, const std::string& file,
                                           std::span<const double> positions_m, std::span<const double> rcs_m2,
                                           const core::WorkControl& control = {core::thread_count(0)});

/// Number of the points of all clouds that are read.
[[nodiscard]] std::size_t cloud_points(const scene::Scene& scene);

}  // namespace sarsim::workflow
