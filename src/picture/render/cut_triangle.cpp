#include "picture/render/cut_triangle.hpp"

#include <cmath>

#include "picture/render/clip.hpp"

namespace sarsim::picture {

namespace {

constexpr double margin_px = 64.0;         // about the picture: what is cut there is not seen
constexpr double nearest_cut_part = 1e-2;  // of the viewer's distance

core::Vec3 mixed(const core::Vec3& a, const core::Vec3& b, double t) { return a + t * (b - a); }

// To pixels right of and below the upper left corner, and nearness; linear between points of a plane.
core::Vec3 seen_at(const Viewpoint& view, const core::Vec3& picture_m) {
  const double scale = view.pixels_per_m / (1.0 - picture_m.z * view.inverse_viewer_m);
  return {0.5 * view.width_px + scale * picture_m.x, 0.5 * view.height_px - scale * picture_m.y, scale * picture_m.z};
}

Corner corner_of(const core::Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

}  // namespace

std::vector<std::array<Corner, 3>> cut_triangle(const Viewpoint& view,
                                                const std::array<core::Vec3, 3>& corners_world_m) {
  std::vector<core::Vec3> points;
  for (const core::Vec3& corner : corners_world_m)
    points.push_back(view.picture_from_world * (corner - view.focus_world_m));
  points = clip_polygon(
      points, [&](const core::Vec3& p) { return 1.0 - p.z * view.inverse_viewer_m - nearest_cut_part; }, mixed);
  for (core::Vec3& point : points) point = seen_at(view, point);
  points = clip_polygon(
      points, [](const core::Vec3& p) { return p.x + margin_px; }, mixed);
  points = clip_polygon(
      points, [&](const core::Vec3& p) { return view.width_px + margin_px - p.x; }, mixed);
  points = clip_polygon(
      points, [](const core::Vec3& p) { return p.y + margin_px; }, mixed);
  points = clip_polygon(
      points, [&](const core::Vec3& p) { return view.height_px + margin_px - p.y; }, mixed);
  std::vector<std::array<Corner, 3>> parts;
  for (std::size_t i = 2; i < points.size(); ++i)
    parts.push_back({corner_of(points[0]), corner_of(points[i - 1]), corner_of(points[i])});
  return parts;
}

}  // namespace sarsim::picture
