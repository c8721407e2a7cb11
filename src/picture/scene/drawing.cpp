#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

raster::Rgb colour_of(const Drawing::Line& line, bool dark) {
  return line.role == Role::track ? track_colour(line.tone / 255.0, dark) : colour(line.role, dark);
}

std::vector<core::Vec3> points_of(const Snapshot& snapshot) {
  return points_of(snapshot, [](scene::ObjectId) { return true; });
}

std::vector<core::Vec3> points_of(const Snapshot& snapshot, const std::function<bool(scene::ObjectId)>& wanted) {
  std::vector<core::Vec3> points;
  const auto add = [&](const auto& more) { points.insert(points.end(), more.begin(), more.end()); };
  for (const Snapshot::Platform& platform : snapshot.platforms) {
    if (!wanted(platform.id)) continue;
    points.push_back(platform.pose.position_world_m);
    add(platform.path_points_world_m);
  }
  for (const std::vector<Snapshot::Target>* targets : {&snapshot.targets, &snapshot.cloud_points})
    for (const Snapshot::Target& target : *targets)
      if (wanted(target.id)) points.push_back(target.position_world_m);
  for (const Snapshot::Surface& surface : snapshot.surfaces)
    if (wanted(surface.id)) add(surface.corner_world_m);
  for (const Snapshot::Radar& radar : snapshot.radars)
    if (wanted(radar.id)) points.push_back(radar.position_world_m);
  return points;
}

}  // namespace sarsim::picture
