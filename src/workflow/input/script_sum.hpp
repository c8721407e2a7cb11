#pragma once

#include <string>

#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Checksum of a scene as 16 hexadecimal digits: of its text and of what its data files hold.
/// @param script  the scene as text (write_script)
[[nodiscard]] std::string script_sum(const scene::Scene& scene, const std::string& script);

}  // namespace sarsim::workflow
