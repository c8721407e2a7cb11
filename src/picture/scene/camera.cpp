#include "picture/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"

namespace sarsim::picture {

namespace {

constexpr double fitted_part = 0.4;     // of the picture on either side of its middle
constexpr double nearest_fitted = 0.5;  // of the viewer's distance: no fitted point comes nearer

bool finite(const core::Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// In (-pi, pi].
double wrapped(double angle_rad) {
  const double reduced = std::remainder(angle_rad, 2.0 * core::pi);
  return reduced <= -core::pi ? reduced + 2.0 * core::pi : reduced;
}

// The world's step that moves a point at the focus's depth by so many pixels.
core::Vec3 world_step(const Camera& camera, double dx_px, double dy_px) {
  const core::Vec3 picture_m{dx_px / camera.pixels_per_m, -dy_px / camera.pixels_per_m, 0.0};
  return core::transposed(camera.picture_from_world()) * picture_m;
}

// The box that holds points in the picture's axes.
struct Box {
  core::Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                 std::numeric_limits<double>::infinity()};
  core::Vec3 high = -low;

  void add(const core::Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

// Largest scale at which a point `side_m` off the middle and `depth_m` behind the focus stays within `half_px` of it.
// The viewer stands K = heights_away * height / s away, so that side * s * K/(K + depth) <= half.
double largest_scale(const Camera& camera, double side_m, double depth_m, double half_px) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (!camera.perspective) return side_m > 0.0 ? half_px / side_m : infinity;
  const double viewer_px = camera.heights_away * camera.height_px;
  const double slope = side_m * viewer_px - half_px * depth_m;
  const double within = slope > 0.0 ? half_px * viewer_px / slope : infinity;
  const double in_front = depth_m < 0.0 ? nearest_fitted * viewer_px / -depth_m : infinity;
  return std::min(within, in_front);
}

// The box that marks take in the picture.
struct MarkBox {
  double left = HUGE_VAL;
  double right = -HUGE_VAL;
  double top = HUGE_VAL;
  double bottom = -HUGE_VAL;
};

MarkBox box_of(const std::vector<MarkRoom>& marks, const Camera& camera) {
  constexpr double largest_part = 0.4;
  const double wide = largest_part * camera.width_px;
  const double high = largest_part * camera.height_px;
  const Projection project(camera);
  MarkBox box;
  for (const MarkRoom& mark : marks) {
    const auto at = project(mark.at_world_m);
    if (!at) continue;
    box.left = std::min(box.left, at->x - std::min(mark.left_px, wide));
    box.right = std::max(box.right, at->x + std::min(mark.right_px, wide));
    box.top = std::min(box.top, at->y - std::min(mark.above_px, high));
    box.bottom = std::max(box.bottom, at->y + std::min(mark.below_px, high));
  }
  return box;
}

// How far a span must be moved to lie between the edges; to their middle where it is longer.
double way_inside(double first, double last, double size, double edge) {
  if (last - first > size - 2.0 * edge) return 0.5 * (size - first - last);
  return std::max(0.0, edge - first) + std::min(0.0, size - edge - last);
}

}  // namespace

Camera Camera::start(double width_px, double height_px) {
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  return preset(camera, ViewPreset::start);
}

core::Mat3 Camera::picture_from_world() const {
  const double s = std::sin(azimuth_rad);
  const double c = std::cos(azimuth_rad);
  const core::Vec3 right{-c, s, 0.0};
  const core::Vec3 towards = core::direction(azimuth_rad, elevation_rad);
  return {{right, core::cross(towards, right), towards}};
}

double Camera::scale_at(double depth_m) const {
  if (!perspective) return pixels_per_m;
  const double viewer_m = viewer_distance_m();
  const double ahead_m = viewer_m + depth_m;
  return ahead_m > nearest_seen_part * viewer_m ? pixels_per_m * viewer_m / ahead_m : 0.0;
}

std::optional<PicturePoint> Camera::project(const core::Vec3& world_m) const { return Projection(*this)(world_m); }

Projection::Projection(const Camera& camera) : camera_(camera), picture_from_world_(camera.picture_from_world()) {}

std::optional<PicturePoint> Projection::operator()(const core::Vec3& world_m) const {
  const core::Vec3 picture_m = picture_from_world_ * (world_m - camera_.focus_world_m);
  if (!finite(picture_m)) return std::nullopt;
  const double scale = camera_.scale_at(-picture_m.z);
  if (scale == 0.0) return std::nullopt;
  return PicturePoint{0.5 * camera_.width_px + scale * picture_m.x, 0.5 * camera_.height_px - scale * picture_m.y,
                      -picture_m.z};
}

core::Vec3 Camera::unproject(double x_px, double y_px) const {
  return focus_world_m + world_step(*this, x_px - 0.5 * width_px, y_px - 0.5 * height_px);
}

Viewpoint Camera::viewpoint() const {
  return {picture_from_world(),
          focus_world_m,
          pixels_per_m,
          perspective ? 1.0 / viewer_distance_m() : 0.0,
          width_px,
          height_px};
}

Camera turned(Camera camera, double dx_px, double dy_px, double scale) {
  camera.azimuth_rad = wrapped(camera.azimuth_rad + dx_px / (4.0 * scale) * core::rad_per_deg);
  camera.elevation_rad =
      std::clamp(camera.elevation_rad + dy_px / (2.0 * scale) * core::rad_per_deg, -0.5 * core::pi, 0.5 * core::pi);
  return camera;
}

Camera panned(Camera camera, double dx_px, double dy_px) {
  camera.focus_world_m = camera.focus_world_m - world_step(camera, dx_px, dy_px);
  return camera;
}

Camera zoomed(Camera camera, double factor, double x_px, double y_px) {
  if (!(factor > 0.0)) return camera;
  const core::Vec3 kept = camera.unproject(x_px, y_px);
  camera.pixels_per_m = std::clamp(camera.pixels_per_m * factor, smallest_pixels_per_m, largest_pixels_per_m);
  camera.focus_world_m = kept - world_step(camera, x_px - 0.5 * camera.width_px, y_px - 0.5 * camera.height_px);
  return camera;
}

Camera fitted(Camera camera, const std::vector<core::Vec3>& points_world_m) {
  const core::Mat3 picture_from_world = camera.picture_from_world();
  Box box;
  for (const core::Vec3& point : points_world_m)
    if (finite(point)) box.add(picture_from_world * point);
  if (!(box.low.x <= box.high.x)) return camera;
  const core::Vec3 middle = 0.5 * (box.low + box.high);
  camera.focus_world_m = core::transposed(picture_from_world) * middle;
  double scale = std::numeric_limits<double>::infinity();
  for (const core::Vec3& point : points_world_m) {
    if (!finite(point)) continue;
    const core::Vec3 p = picture_from_world * point - middle;
    scale = std::min({scale, largest_scale(camera, std::abs(p.x), -p.z, fitted_part * camera.width_px),
                      largest_scale(camera, std::abs(p.y), -p.z, fitted_part * camera.height_px)});
  }
  // Points that differ by rounding alone are one point.
  const double size = std::max({core::norm(box.low), core::norm(box.high), 1e-3});
  if (!std::isfinite(scale) || core::norm(box.high - box.low) < 1e-9 * size) return camera;
  camera.pixels_per_m = std::clamp(scale, smallest_pixels_per_m, largest_pixels_per_m);
  return camera;
}

Camera with_whole_marks(Camera camera, const std::vector<MarkRoom>& marks, double edge_px) {
  constexpr int max_steps = 40;
  constexpr double step = 0.93;
  for (int i = 0; i < max_steps; ++i) {
    const MarkBox box = box_of(marks, camera);
    if (!(box.left <= box.right)) return camera;
    const double dx = way_inside(box.left, box.right, camera.width_px, edge_px);
    const double dy = way_inside(box.top, box.bottom, camera.height_px, edge_px);
    if (dx != 0.0 || dy != 0.0) camera = panned(camera, dx, dy);
    const bool fits = box.right - box.left <= camera.width_px - 2.0 * edge_px &&
                      box.bottom - box.top <= camera.height_px - 2.0 * edge_px;
    // In perspective a point that is moved is seen at another scale.
    if (fits && (!camera.perspective || std::hypot(dx, dy) < 0.5)) return camera;
    if (!fits) camera = zoomed(camera, step, 0.5 * camera.width_px, 0.5 * camera.height_px);
  }
  return camera;
}

Camera along_beam(Camera camera, const core::Vec3& antenna_world_m, const core::Vec3& axis_world, double width_rad,
                  double reach_m) {
  constexpr double widest_rad = 60.0 * core::rad_per_deg;
  constexpr double widths_in_height = 3.0;
  constexpr double nearest_heights = 0.3;  // 118 degrees from edge to edge
  const double width = width_rad > 0.0 ? std::min(width_rad, widest_rad) : widest_rad;
  camera.perspective = true;
  camera.heights_away = std::max(nearest_heights, 0.5 / (widths_in_height * std::tan(0.5 * width)));
  camera.azimuth_rad = wrapped(core::azimuth_rad(-axis_world));
  camera.elevation_rad = core::elevation_rad(-axis_world);
  camera.pixels_per_m = camera.heights_away * camera.height_px / reach_m;
  camera.focus_world_m = antenna_world_m + reach_m * axis_world;
  return camera;
}

Camera preset(Camera camera, ViewPreset view) {
  // A view along a beam may have stood farther away, or nearer.
  camera.heights_away = distance_in_heights;
  const auto look_from = [&](double azimuth_deg, double elevation_deg) {
    camera.azimuth_rad = azimuth_deg * core::rad_per_deg;
    camera.elevation_rad = elevation_deg * core::rad_per_deg;
  };
  switch (view) {
    case ViewPreset::start: look_from(60.0, 30.0); break;
    case ViewPreset::top: look_from(180.0, 90.0); break;
    case ViewPreset::front: look_from(180.0, 0.0); break;
    case ViewPreset::side: look_from(90.0, 0.0); break;
  }
  return camera;
}

}  // namespace sarsim::picture
