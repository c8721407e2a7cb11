#pragma once

#include <compare>
#include <cstddef>

namespace sarsim::scene {

/// The lists of a scene, in the order in which people see them.
enum class ObjectKind { platform, target, cloud, surface, radar, simulation, geometry };

/// One object of a scene: number `index` of its list. Ids change when objects before them are added or removed.
struct ObjectId {
  ObjectKind kind = ObjectKind::platform;
  std::size_t index = 0;

  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

}  // namespace sarsim::scene
