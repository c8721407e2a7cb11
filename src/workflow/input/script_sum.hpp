#pragma once

#include <string>

#include "core/task/parallel.hpp"
#include "raster/table/raster.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Checksum of a scene as 16 hexadecimal digits: of its text and of what its data files and tables of points hold, and
/// of the motions and attitudes that were read, as they are throughout their files and, 16 385 times, throughout the
/// times that the scene needs.
[[nodiscard]] std::string script_sum(const scene::Scene& scene, const core::WorkControl& control = {});

/// Checksum of a recording as 16 hexadecimal digits: of its shape and of up to 64 of its rows, evenly chosen, the first
/// and the last included, as they are stored. Another seed, track or level changes every row; formats that store the
/// same numbers give the same checksum. Throws what reading throws.
[[nodiscard]] std::string samples_sum(const raster::Raster& file, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow
