#pragma once

#include <string>

#include "core/task/parallel.hpp"
#include "raster/table/raster.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Checksum of a scene as 16 hexadecimal digits: of its text and of what its data files and tables of points hold.
[[nodiscard]] std::string script_sum(const scene::Scene& scene, const core::WorkControl& control = {});

/// Checksum of a recording as 16 hexadecimal digits: of its shape and of up to 64 of its rows, evenly chosen, the first
/// and the last included, as they are stored. Another seed, another track or another level changes every row; it is the
/// same in every format that stores the same numbers. Throws what reading does.
[[nodiscard]] std::string samples_sum(const raster::Raster& file, const core::StopFlag* stop = nullptr);

}  // namespace sarsim::workflow
