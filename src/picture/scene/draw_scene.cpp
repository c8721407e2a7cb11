#include "picture/scene/draw_scene.hpp"

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

}  // namespace sarsim::picture
