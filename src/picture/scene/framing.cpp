#include "picture/scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace sarsim::picture {

namespace {

constexpr double fit_margin_px = 40.0;  // of the screen
constexpr double free_edge_px = 6.0;
constexpr double buttons_px = 34.0;          // above: buttons and read-outs lie over the picture
constexpr double main_axis_room_px = 230.0;  // with the letter
constexpr double own_axis_room_px = 70.0;
constexpr double point_room_px = 8.0;
constexpr double letter_px = 8.0;
constexpr double bar_width_px = 160.0;  // of the lower left corner: the scale bar, with its words
constexpr double bar_height_px = 46.0;
constexpr double letter_corner_px = 100.0;  // of the lower right corner: the axes there
constexpr double triad_px = 130.0;          // of the lower right corner: the axes there, and own axes above them

// What axes with letters take about their origin.
MarkRoom room_of_axes(const Camera& camera, const core::Vec3& at_m, const core::Mat3& world_from_axes,
                      double length_px) {
  MarkRoom room{at_m, 0.0, 0.0, 0.0, 0.0};
  const core::Mat3 axes_world = core::transposed(world_from_axes);
  for (const core::Vec3& axis : axes_world.row) {
    const core::Vec3 end = length_px * (camera.picture_from_world() * axis);
    room.left_px = std::max(room.left_px, -end.x);
    room.right_px = std::max(room.right_px, end.x);
    room.above_px = std::max(room.above_px, end.y);
    room.below_px = std::max(room.below_px, -end.y);
  }
  return room;
}

double half_width_px(const std::string& words) { return 0.5 * letter_px * static_cast<double>(words.size()); }

std::vector<MarkRoom> rooms_of(const Snapshot& snapshot, const Camera& camera, const DrawingOptions& options) {
  const double scale = options.pixel_scale;
  std::vector<MarkRoom> rooms;
  if (options.coordinate_systems) rooms.push_back(room_of_axes(camera, {}, {}, scale * main_axis_room_px));
  for (const Snapshot::Platform& platform : snapshot.platforms) {
    const core::Vec3& at_m = platform.pose.position_world_m;
    if (options.coordinate_systems)
      rooms.push_back(room_of_axes(camera, at_m, platform.pose.world_from_platform, scale * own_axis_room_px));
    const double half = scale * half_width_px(platform.name);
    if (options.labels) rooms.push_back({at_m, half, half, scale * 26.0, 0.0});
  }
  for (const Snapshot::Radar& radar : snapshot.radars) {
    const double half = scale * half_width_px(radar.name);
    rooms.push_back({radar.position_world_m, half, half, scale * 12.0, scale * 28.0});
  }
  return rooms;
}

// What lifts the lowest of the points that lie under the corner triad above it.
std::optional<MarkRoom> room_above_triad(const Camera& camera, const std::vector<core::Vec3>& points_m,
                                         double pixel_scale) {
  const double corner_px = triad_px * pixel_scale;
  const Projection project(camera);
  std::optional<MarkRoom> lowest;
  double lowest_px = camera.height_px - corner_px;
  for (const core::Vec3& point : points_m) {
    const auto at = project(point);
    if (!at || at->x < camera.width_px - corner_px || at->y < lowest_px) continue;
    lowest_px = at->y;
    lowest = MarkRoom{point, 0.0, 0.0, 0.0, corner_px};
  }
  return lowest;
}

// What lifts the letters of the main axes above the scale bar and the corner triad, where there are these.
std::vector<MarkRoom> rooms_above_corners(const Camera& camera, const DrawingOptions& options) {
  const auto origin = camera.project({});
  if (!origin || !options.coordinate_systems) return {};
  const double scale = options.pixel_scale;
  const double letter_triad_px = options.corner_triad ? letter_corner_px * scale : 0.0;
  std::vector<MarkRoom> rooms;
  for (const core::Vec3& axis : core::transposed(camera.picture_from_world()).row) {
    const double x_px = origin->x + main_axis_room_px * scale * axis.x;
    const double below_px = -main_axis_room_px * scale * axis.y;
    const double free_px = x_px < bar_width_px * scale                ? bar_height_px * scale
                           : x_px > camera.width_px - letter_triad_px ? letter_triad_px
                                                                      : 0.0;
    if (origin->y + below_px > camera.height_px - free_px) rooms.push_back({{}, 0.0, 0.0, 0.0, below_px + free_px});
  }
  return rooms;
}

// The corners of the box that holds points in the picture's axes.
std::vector<core::Vec3> corners_about(const Camera& camera, const std::vector<core::Vec3>& points_m) {
  const core::Mat3 picture_from_world = camera.picture_from_world();
  const double infinity = std::numeric_limits<double>::infinity();
  core::Vec3 low{infinity, infinity, infinity};
  core::Vec3 high = -low;
  for (const core::Vec3& point : points_m) {
    const core::Vec3 p = picture_from_world * point;
    if (!std::isfinite(p.x + p.y + p.z)) continue;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  std::vector<core::Vec3> corners;
  if (!(low.x <= high.x)) return corners;
  for (const double x : {low.x, high.x})
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z})
        corners.push_back(core::transposed(picture_from_world) * core::Vec3{x, y, z});
  return corners;
}

Camera fitted_with_margin(const Camera& camera, const std::vector<core::Vec3>& points_m, double pixel_scale) {
  Camera inner = camera;
  inner.width_px = std::max(0.5 * camera.width_px, camera.width_px - 2.0 * fit_margin_px * pixel_scale);
  inner.height_px = std::max(0.5 * camera.height_px, camera.height_px - 2.0 * fit_margin_px * pixel_scale);
  inner = fitted(inner, points_m);
  inner.width_px = camera.width_px;
  inner.height_px = camera.height_px;
  return inner;
}

// Half of the way to the nearest other point; 0 where there is none.
double lonely_radius_m(const Snapshot& snapshot, const core::Vec3& at_m) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const core::Vec3& point : points_of(snapshot)) {
    const double away = core::norm(point - at_m);
    if (away > 1e-6 * std::max(1.0, core::norm(at_m))) nearest = std::min(nearest, away);
  }
  return std::isfinite(nearest) ? 0.5 * nearest : 0.0;
}

}  // namespace

Camera showing_all(const Camera& camera, const Snapshot& snapshot, const DrawingOptions& options) {
  const std::vector<core::Vec3> points = points_of(snapshot);
  Camera shown = fitted_with_margin(camera, points, options.pixel_scale);
  std::vector<MarkRoom> rooms = rooms_of(snapshot, shown, options);
  const double room = point_room_px * options.pixel_scale;
  for (const core::Vec3& corner : corners_about(shown, points)) rooms.push_back({corner, room, room, room, room});
  for (MarkRoom& mark : rooms) mark.above_px += buttons_px * options.pixel_scale;
  const double edge = free_edge_px * options.pixel_scale;
  shown = with_whole_marks(shown, rooms, edge);
  std::vector<MarkRoom> corners = rooms_above_corners(shown, options);
  if (options.corner_triad)
    if (const auto above = room_above_triad(shown, points, options.pixel_scale)) corners.push_back(*above);
  if (corners.empty()) return shown;
  rooms.insert(rooms.end(), corners.begin(), corners.end());
  return with_whole_marks(shown, rooms, edge);
}

Camera showing(const Camera& camera, const Snapshot& snapshot, const std::set<scene::ObjectId>& objects,
               double pixel_scale) {
  std::vector<core::Vec3> points = points_of(snapshot, objects);
  if (points.empty()) return camera;
  const core::Vec3 first = points.front();
  const bool one = std::ranges::all_of(
      points, [&](const core::Vec3& p) { return core::norm(p - first) <= 1e-6 * std::max(1.0, core::norm(first)); });
  if (const double radius = one ? lonely_radius_m(snapshot, first) : 0.0; radius > 0.0) {
    const core::Mat3 axes = camera.picture_from_world();
    for (const core::Vec3& way : {axes.row[0], -axes.row[0], axes.row[1], -axes.row[1]})
      points.push_back(first + radius * way);
  }
  return fitted_with_margin(camera, points, pixel_scale);
}

std::vector<core::Vec3> points_of(const Snapshot& snapshot, const std::set<scene::ObjectId>& objects) {
  // Those of a kind stand in the order of their ids, so that a step on is nearly always enough.
  auto next = objects.begin();
  return points_of(snapshot, [&](scene::ObjectId id) {
    if (next != objects.end() && *next < id) ++next;
    if (next == objects.end() || *next != id) next = objects.lower_bound(id);
    return next != objects.end() && *next == id;
  });
}

bool shows_well(const Camera& camera, const std::vector<core::Vec3>& points_world_m) {
  double left = camera.width_px, right = 0.0, top = camera.height_px, bottom = 0.0;
  const Projection project(camera);
  for (const core::Vec3& point : points_world_m) {
    const auto at = project(point);
    if (!at || at->x < 0.0 || at->y < 0.0 || at->x > camera.width_px || at->y > camera.height_px) return false;
    left = std::min(left, at->x);
    right = std::max(right, at->x);
    top = std::min(top, at->y);
    bottom = std::max(bottom, at->y);
  }
  return right - left > 0.1 * camera.width_px || bottom - top > 0.1 * camera.height_px;
}

}  // namespace sarsim::picture
