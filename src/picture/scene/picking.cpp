#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "picture/scene/drawing.hpp"

namespace sarsim::picture {

namespace {

constexpr double same_distance_px = 0.5;  // nearer together than that, depth decides

template <class Accept>
const Drawing::Handle* nearest_handle(const Drawing& drawing, double x_px, double y_px, double reach_px,
                                      const Accept& accept) {
  const auto distance = [&](const Drawing::Handle& h) {
    return std::hypot(static_cast<double>(h.x) - x_px, static_cast<double>(h.y) - y_px);
  };
  double nearest = reach_px;
  bool found = false;
  for (const Drawing::Handle& handle : drawing.handles)
    if (accept(handle) && distance(handle) <= nearest) nearest = distance(handle), found = true;
  if (!found) return nullptr;
  const Drawing::Handle* best = nullptr;
  for (const Drawing::Handle& handle : drawing.handles)
    if (accept(handle) && distance(handle) <= nearest + same_distance_px &&
        (best == nullptr || handle.depth_m < best->depth_m))
      best = &handle;
  return best;
}

struct Side {
  double inside;       // twice the signed area with the point
  double distance_px;  // of the point from the segment
};

Side side_of(const PicturePoint& a, const PicturePoint& b, double x, double y) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0.0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
  return {dx * (y - a.y) - dy * (x - a.x), std::hypot(a.x + t * dx - x, a.y + t * dy - y)};
}

// Depth of a triangle under a picture point: of its centre, where the point lies in it or within reach of its rim.
std::optional<double> depth_under(const Snapshot::Surface& surface, const Camera& camera, double x, double y,
                                  double reach_px) {
  std::array<PicturePoint, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto point = camera.project(surface.corner_world_m[i]);
    if (!point) return std::nullopt;
    corner[i] = *point;
  }
  int left = 0;
  int right = 0;
  double rim_px = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Side side = side_of(corner[i], corner[(i + 1) % 3], x, y);
    rim_px = std::min(rim_px, side.distance_px);
    (side.inside > 0.0 ? left : right) += 1;
  }
  const bool inside = left == 3 || right == 3;
  if (!inside && rim_px > reach_px) return std::nullopt;
  return (corner[0].depth_m + corner[1].depth_m + corner[2].depth_m) / 3.0;
}

bool drawn(const Drawing& drawing, const scene::ObjectId& id) {
  return std::ranges::any_of(drawing.handles, [&](const Drawing::Handle& handle) { return handle.id == id; });
}

// What is solid at a point, and can be picked.
std::optional<scene::ObjectId> solid_under(const Drawing& drawing, double x_px, double y_px) {
  const auto seen = triangle_at(drawing.solids, x_px, y_px);
  if (!seen || seen->mesh >= drawing.meshes.size()) return std::nullopt;
  const std::vector<scene::ObjectId>& objects = drawing.meshes[seen->mesh]->objects;
  if (objects.empty()) return std::nullopt;
  return objects.size() == 1 ? objects.front() : objects.at(seen->triangle);
}

std::optional<scene::ObjectId> surface_under(const Drawing& drawing, const Snapshot& snapshot, const Camera& camera,
                                             double x_px, double y_px, double reach_px) {
  std::optional<scene::ObjectId> best;
  double best_depth = std::numeric_limits<double>::infinity();
  for (const Snapshot::Surface& surface : snapshot.surfaces) {
    const auto depth = depth_under(surface, camera, x_px, y_px, reach_px);
    if (!depth || *depth >= best_depth || !drawn(drawing, surface.id)) continue;
    best = surface.id;
    best_depth = *depth;
  }
  return best;
}

}  // namespace

std::optional<scene::ObjectId> picked(const Drawing& drawing, const Snapshot& snapshot, const Camera& camera,
                                      double x_px, double y_px, double reach_px) {
  const auto small = [](const Drawing::Handle& handle) {
    const scene::ObjectKind kind = handle.id.kind;
    return kind == scene::ObjectKind::target || kind == scene::ObjectKind::cloud || kind == scene::ObjectKind::radar;
  };
  const auto platform = [](const Drawing::Handle& handle) {
    return handle.id.kind == scene::ObjectKind::platform && !handle.path_point;
  };
  if (const Drawing::Handle* handle = nearest_handle(drawing, x_px, y_px, reach_px, small)) return handle->id;
  if (const Drawing::Handle* handle = nearest_handle(drawing, x_px, y_px, reach_px, platform)) return handle->id;
  if (const auto solid = solid_under(drawing, x_px, y_px)) return solid;
  return surface_under(drawing, snapshot, camera, x_px, y_px, reach_px);
}

std::optional<PathPointId> picked_path_point(const Drawing& drawing, double x_px, double y_px, double reach_px) {
  const auto of_path = [](const Drawing::Handle& handle) { return handle.path_point.has_value(); };
  const Drawing::Handle* const handle = nearest_handle(drawing, x_px, y_px, reach_px, of_path);
  if (handle == nullptr) return std::nullopt;
  return PathPointId{handle->id, *handle->path_point};
}

std::optional<PathPlace> picked_path_place(const Snapshot& snapshot, const DrawingOptions& options,
                                           const Camera& camera, double x_px, double y_px, double reach_px) {
  std::optional<PathPlace> nearest;
  double least = reach_px;
  for (const Snapshot::Platform& platform : snapshot.platforms) {
    if (!options.selected.contains(platform.id) || options.hidden.contains(platform.id)) continue;
    for (std::size_t i = 1; i < platform.path_world_m.size(); ++i) {
      const core::Vec3& from = platform.path_world_m[i - 1];
      const core::Vec3& to = platform.path_world_m[i];
      const auto a = camera.project(from);
      const auto b = camera.project(to);
      if (!a || !b) continue;
      const double dx = b->x - a->x;
      const double dy = b->y - a->y;
      const double t =
          std::clamp(((x_px - a->x) * dx + (y_px - a->y) * dy) / std::max(dx * dx + dy * dy, 1e-12), 0.0, 1.0);
      const double distance = std::hypot(a->x + t * dx - x_px, a->y + t * dy - y_px);
      if (distance > least) continue;
      least = distance;
      // Along the part as it is foreshortened.
      const double depth_a = camera.scale_at(a->depth_m);
      const double depth_b = camera.scale_at(b->depth_m);
      const double part = t * depth_a / ((1.0 - t) * depth_b + t * depth_a);
      nearest = {platform.id, from + part * (to - from)};
    }
  }
  return nearest;
}

}  // namespace sarsim::picture
