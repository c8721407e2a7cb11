#pragma once

#include <cstddef>
#include <string_view>

#include "scene/check/check_findings.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// What is said of a platform whose file is not read; follows from other mistakes where these kept it from being read.
inline constexpr std::string_view unread_motion = "the motion of the platform is not read";

/// Checks the world itself: epoch, anchor, leap seconds.
void check_world(Findings& findings, const Scene& scene);

/// Checks what moves a platform beyond the script language: files, routes, leaders and parents, laws that need the
/// Earth. The findings must be about that platform.
void check_motion(Findings& findings, const Scene& scene, std::size_t platform);

}  // namespace sarsim::scene
