#include "picture/scene/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "picture/scene/drawing_pen.hpp"
#include "picture/scene/globe.hpp"
#include "picture/scene/place_labels.hpp"
#include "picture/scene/solids.hpp"

namespace sarsim::picture {

namespace {

void clear(Drawing& drawing) {
  drawing.lines.clear();
  drawing.discs.clear();
  drawing.texts.clear();
  drawing.handles.clear();
}

void draw_solids(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options, Drawing& drawing) {
  Solids solids = solids_of(snapshot, camera, options);
  drawing.meshes = std::move(solids.meshes);
  drawing.scenery = solids.scenery;
  if (!drawing.rasteriser) drawing.rasteriser = std::make_shared<Rasteriser>();
  drawing.rasteriser->render(drawing.meshes, camera.viewpoint(),
                             {options.threads, options.coarse ? 1 : options.samples}, drawing.solids);
}

// Of a plane ground: where level lines of sight meet the picture.
std::optional<double> horizon_of(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options) {
  if (!options.sky || !camera.perspective || (snapshot.earth && shows_curvature(camera))) return std::nullopt;
  const double below = std::tan(camera.elevation_rad) * camera.heights_away * camera.height_px;
  return std::clamp(0.5 * camera.height_px - below, 0.0, camera.height_px);
}

}  // namespace

raster::Rgb colour_of(const Drawing::Line& line, bool dark) {
  return line.role == Role::track ? track_colour(line.tone / 255.0, dark) : colour(line.role, dark);
}

void draw_scene(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options, Drawing& drawing) {
  clear(drawing);
  draw_solids(snapshot, camera, options, drawing);
  drawing.horizon_px = horizon_of(snapshot, camera, options);
  Pen pen(camera, options, drawing);
  if (options.ground_grid && snapshot.earth && shows_curvature(camera))
    draw_graticule(pen, *snapshot.earth);
  else if (options.ground_grid)
    draw_ground_grid(pen);
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
  place_labels(drawing.texts, camera, options.pixel_scale);
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
