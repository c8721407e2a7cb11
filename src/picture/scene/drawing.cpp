#include "picture/scene/drawing.hpp"

#include <algorithm>

#include "picture/scene/drawing_pen.hpp"

namespace sarsim::picture {

namespace {

void clear(Drawing& drawing) {
  drawing.polygons.clear();
  drawing.lines.clear();
  drawing.discs.clear();
  drawing.texts.clear();
  drawing.handles.clear();
}

double mean_depth(const Drawing::Polygon& polygon) {
  double sum = 0.0;
  for (const PicturePoint& corner : polygon.corners) sum += corner.depth_m;
  return sum / static_cast<double>(polygon.corners.size());
}

}  // namespace

void draw_scene(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options, Drawing& drawing) {
  clear(drawing);
  Pen pen(camera, options, drawing);
  if (options.ground_grid) draw_ground_grid(pen);
  draw_surfaces(pen, snapshot.surfaces);
  if (options.coordinate_systems) {
    draw_main_axes(pen);
    draw_scale_bar(pen);
  }
  if (options.corner_triad) draw_corner_triad(pen);
  draw_targets(pen, snapshot.cloud_points);
  draw_targets(pen, snapshot.targets);
  draw_radars(pen, snapshot.radars);
  draw_platforms(pen, snapshot.platforms);
  draw_hands(pen);
  std::ranges::stable_sort(drawing.polygons, std::ranges::greater{}, mean_depth);
}

std::vector<core::Vec3> points_of(const Snapshot& snapshot) {
  std::vector<core::Vec3> points;
  for (const Snapshot::Platform& platform : snapshot.platforms) {
    points.push_back(platform.pose.position_world_m);
    points.insert(points.end(), platform.path_points_world_m.begin(), platform.path_points_world_m.end());
  }
  for (const Snapshot::Target& target : snapshot.targets) points.push_back(target.position_world_m);
  for (const Snapshot::Target& point : snapshot.cloud_points) points.push_back(point.position_world_m);
  for (const Snapshot::Surface& surface : snapshot.surfaces)
    points.insert(points.end(), surface.corner_world_m.begin(), surface.corner_world_m.end());
  for (const Snapshot::Radar& radar : snapshot.radars) points.push_back(radar.position_world_m);
  return points;
}

}  // namespace sarsim::picture
