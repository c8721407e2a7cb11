#pragma once

#include <string>

#include "scene/model/object.hpp"

namespace sarsim::gui {

/// The name of a platform or radar; empty for others.
[[nodiscard]] inline std::string name_of_object(const scene::Scene& scene, scene::ObjectId id) {
  if (!scene::has_object(scene, id)) return {};
  if (id.kind == scene::ObjectKind::platform) return scene.platforms[id.index].name;
  if (id.kind == scene::ObjectKind::radar) return scene.radars[id.index].name;
  return {};
}

}  // namespace sarsim::gui
