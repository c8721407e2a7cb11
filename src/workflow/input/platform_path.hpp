#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/report/problem.hpp"
#include "radar/orbit/state_table.hpp"
#include "scene/model/read_path.hpp"
#include "scene/model/scene.hpp"
#include "workflow/input/world_axes.hpp"

namespace sarsim::workflow {

/// The file of a platform.
struct FileText {
  std::string text;
  std::string path;
};

/// Times of the scene, as seconds and, where there is an epoch, as dates.
[[nodiscard]] std::string typed_times(const radar::TimeSpan& span, const WorldAxes& axes);

/// The path of one platform that is an orbit (`scene::is_orbit`), in the scene's world; null where there is none, which
/// a problem says.
/// @param file  of Path::ephemeris; nothing for the others
[[nodiscard]] std::shared_ptr<const scene::ReadPath> path_of_platform(const scene::Scene& scene,
                                                                      const scene::Platform& platform,
                                                                      const std::optional<FileText>& file,
                                                                      core::Problems& problems);

}  // namespace sarsim::workflow
