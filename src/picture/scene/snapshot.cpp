#include "picture/scene/snapshot.hpp"

#include <algorithm>

namespace sarsim::picture {

std::optional<core::Vec3> place_of(const Snapshot& snapshot, scene::ObjectId id) {
  std::optional<core::Vec3> place;
  const auto look = [&](const auto& objects, const auto& place_in) {
    const auto found = std::ranges::find(objects, id, [](const auto& object) { return object.id; });
    if (found != objects.end()) place = place_in(*found);
  };
  switch (id.kind) {
    case scene::ObjectKind::platform:
      look(snapshot.platforms, [](const Snapshot::Platform& platform) { return platform.pose.position_world_m; });
      break;
    case scene::ObjectKind::target:
      look(snapshot.targets, [](const Snapshot::Target& target) { return target.position_world_m; });
      break;
    case scene::ObjectKind::cloud:
      look(snapshot.cloud_points, [](const Snapshot::Target& point) { return point.position_world_m; });
      break;
    case scene::ObjectKind::surface:
      look(snapshot.surfaces, [](const Snapshot::Surface& surface) {
        const auto& [a, b, c] = surface.corner_world_m;
        return (1.0 / 3.0) * (a + b + c);
      });
      break;
    case scene::ObjectKind::radar:
      look(snapshot.radars, [](const Snapshot::Radar& radar) { return radar.position_world_m; });
      break;
    case scene::ObjectKind::simulation:
    case scene::ObjectKind::geometry: break;
  }
  return place;
}

}  // namespace sarsim::picture
