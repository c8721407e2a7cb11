#pragma once

#include <string>

#include "scene/model/object.hpp"

namespace sarsim {

/// True for the kinds that have names: platforms and radars.
[[nodiscard]] inline bool has_name(ObjectKind kind) {
  return kind == ObjectKind::platform || kind == ObjectKind::radar;
}

/// The name of a platform or radar; empty for others.
[[nodiscard]] inline std::string name_of_object(const Scene& scene, ObjectId id) {
  if (!has_object(scene, id)) return {};
  if (id.kind == ObjectKind::platform) return scene.platforms[id.index].name;
  if (id.kind == ObjectKind::radar) return scene.radars[id.index].name;
  return {};
}

}  // namespace sarsim
