#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "picture/scene/drawing.hpp"
#include "picture/scene/gizmo.hpp"
#include "picture/scene/snapshot.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::picture {

/// The gizmo of an object, and which angle each of its rings changes.
struct Handles {
  /// An angle of the object.
  struct Angle {
    std::string name;  ///< "yaw"
    double rad = 0.0;  ///< As it is.
  };
  Gizmo gizmo;
  std::vector<Angle> angles;  ///< One for each ring.
};

/// The handles of an object: arrows for targets and for platforms that stay where they are; rings for the constant
/// rotation of platforms, the normals of directional targets and the constant beams of radars. Nothing for what can be
/// neither moved nor turned, and for the world itself ("Earth").
/// @param snapshot  of the scene
/// @param own_axes  arrows along the axes of a platform, or of what carries a target, instead of the world's
[[nodiscard]] std::optional<Handles> handles_of(const scene::Scene& scene, const Snapshot& snapshot,
                                                scene::ObjectId object, bool own_axes);

/// The handles of a point of a path; nothing where the snapshot has no such point.
[[nodiscard]] std::optional<Handles> handles_of(const Snapshot& snapshot, const PathPointId& point);

/// The object with the angle of a ring of `handles_of` changed.
[[nodiscard]] scene::AnyObject turned(scene::AnyObject object, std::size_t ring, double by_rad);

/// The position that a hand moves, where an object has one that is its own; otherwise null.
[[nodiscard]] core::Vec3* position_of(scene::AnyObject& object);

}  // namespace sarsim::picture
