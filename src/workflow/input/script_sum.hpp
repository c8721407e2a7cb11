#pragma once

#include <string>

#include "core/task/parallel.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Checksum of a scene as 16 hexadecimal digits: of its text and of what its data files and tables of points hold.
[[nodiscard]] std::string script_sum(const scene::Scene& scene, const core::WorkControl& control = {});

}  // namespace sarsim::workflow
