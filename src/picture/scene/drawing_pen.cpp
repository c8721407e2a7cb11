#include "picture/scene/drawing_pen.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::picture {

namespace {

constexpr double margin_px = 64.0;            // about the picture, of the screen
constexpr double nearest_stroke_part = 1e-2;  // of the viewer's distance

struct Frame {
  double left, top, right, bottom;
};

Frame frame_of(const Camera& camera, double pixel_scale) {
  const double margin = margin_px * pixel_scale;
  return {-margin, -margin, camera.width_px + margin, camera.height_px + margin};
}

// Keeps the part of a segment within the frame (Liang and Barsky 1984); false where nothing is left.
bool clip_segment(PicturePoint& a, PicturePoint& b, const Frame& frame) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double enter = 0.0;
  double leave = 1.0;
  const auto keep = [&](double towards, double room) {
    if (towards == 0.0) return room >= 0.0;
    const double at = room / towards;
    if (towards < 0.0)
      enter = std::max(enter, at);
    else
      leave = std::min(leave, at);
    return enter <= leave;
  };
  if (!keep(-dx, a.x - frame.left) || !keep(dx, frame.right - a.x) || !keep(-dy, a.y - frame.top) ||
      !keep(dy, frame.bottom - a.y))
    return false;
  b = {a.x + leave * dx, a.y + leave * dy, b.depth_m};
  a = {a.x + enter * dx, a.y + enter * dy, a.depth_m};
  return true;
}

// The part of a polygon where `room` is not negative (Sutherland and Hodgman 1974); `between(a, b, t)` mixes corners.
template <class Corner, class Room, class Between>
std::vector<Corner> clip_polygon(const std::vector<Corner>& corners, const Room& room, const Between& between) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const double room_a = room(a);
    const double room_b = room(b);
    if (room_a >= 0.0) kept.push_back(a);
    if ((room_a >= 0.0) != (room_b >= 0.0)) kept.push_back(between(a, b, room_a / (room_a - room_b)));
  }
  return kept;
}

std::vector<PicturePoint> clip_to_frame(std::vector<PicturePoint> corners, const Frame& frame) {
  const auto between = [](const PicturePoint& a, const PicturePoint& b, double t) {
    return PicturePoint{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth_m + t * (b.depth_m - a.depth_m)};
  };
  corners = clip_polygon(
      corners, [&](const PicturePoint& p) { return p.x - frame.left; }, between);
  corners = clip_polygon(
      corners, [&](const PicturePoint& p) { return frame.right - p.x; }, between);
  corners = clip_polygon(
      corners, [&](const PicturePoint& p) { return p.y - frame.top; }, between);
  return clip_polygon(
      corners, [&](const PicturePoint& p) { return frame.bottom - p.y; }, between);
}

}  // namespace

Pen::Pen(const Camera& camera, const DrawingOptions& options, Drawing& drawing)
    : camera_(camera),
      options_(options),
      drawing_(drawing),
      picture_from_world_(camera.picture_from_world()),
      nearest_depth_m_(-(1.0 - nearest_stroke_part) * camera.viewer_distance_m()) {}

core::Vec3 Pen::in_picture_axes(const core::Vec3& world_m) const {
  return picture_from_world_ * (world_m - camera_.focus_world_m);
}

PicturePoint Pen::point_of(const core::Vec3& picture_m) const {
  const double scale = camera_.scale_at(-picture_m.z);
  return {0.5 * camera_.width_px + scale * picture_m.x, 0.5 * camera_.height_px - scale * picture_m.y, -picture_m.z};
}

std::optional<PicturePoint> Pen::project(const core::Vec3& world_m) const {
  const core::Vec3 picture_m = in_picture_axes(world_m);
  if (camera_.perspective && !(-picture_m.z > nearest_depth_m_)) return std::nullopt;
  const PicturePoint point = point_of(picture_m);
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
  return point;
}

bool Pen::visible(const PicturePoint& point) const {
  const double margin = px(margin_px);
  return point.x >= -margin && point.y >= -margin && point.x <= camera_.width_px + margin &&
         point.y <= camera_.height_px + margin;
}

PicturePoint Pen::along(const PicturePoint& start, const core::Vec3& direction_world, double length_px) const {
  const core::Vec3 step = px(length_px) * (picture_from_world_ * direction_world);
  return {start.x + step.x, start.y - step.y, start.depth_m};
}

void Pen::line(const PicturePoint& a, const PicturePoint& b, Role role, double width_px, bool dotted) {
  PicturePoint from = a;
  PicturePoint to = b;
  if (!clip_segment(from, to, frame_of(camera_, options_.pixel_scale))) return;
  drawing_.lines.push_back({static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x),
                            static_cast<float>(to.y), role, static_cast<float>(px(width_px)), dotted});
}

void Pen::world_line(const core::Vec3& a_world_m, const core::Vec3& b_world_m, Role role, double width_px,
                     bool dotted) {
  core::Vec3 a = in_picture_axes(a_world_m);
  core::Vec3 b = in_picture_axes(b_world_m);
  if (camera_.perspective) {
    const double room_a = -a.z - nearest_depth_m_;
    const double room_b = -b.z - nearest_depth_m_;
    if (!(room_a > 0.0 || room_b > 0.0)) return;
    const core::Vec3 crossing = a + (room_a / (room_a - room_b)) * (b - a);
    if (room_a <= 0.0) a = crossing;
    if (room_b <= 0.0) b = crossing;
  }
  const PicturePoint from = point_of(a);
  const PicturePoint to = point_of(b);
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return;
  line(from, to, role, width_px, dotted);
}

void Pen::disc(const PicturePoint& at, double diameter_px, Role role, bool outlined) {
  if (!visible(at)) return;
  drawing_.discs.push_back(
      {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(px(diameter_px)), role, outlined});
}

void Pen::polygon(const std::array<core::Vec3, 3>& corners_world_m, Role role, std::uint8_t shade, bool filled) {
  std::vector<core::Vec3> corners(corners_world_m.begin(), corners_world_m.end());
  for (core::Vec3& corner : corners) corner = in_picture_axes(corner);
  if (camera_.perspective)
    corners = clip_polygon(
        corners, [&](const core::Vec3& p) { return -p.z - nearest_depth_m_; },
        [](const core::Vec3& a, const core::Vec3& b, double t) { return a + t * (b - a); });
  Drawing::Polygon polygon{{}, role, shade, filled};
  polygon.corners.reserve(corners.size());
  for (const core::Vec3& corner : corners) polygon.corners.push_back(point_of(corner));
  for (const PicturePoint& corner : polygon.corners)
    if (!std::isfinite(corner.x + corner.y)) return;
  polygon.corners = clip_to_frame(std::move(polygon.corners), frame_of(camera_, options_.pixel_scale));
  if (polygon.corners.size() >= 3) drawing_.polygons.push_back(std::move(polygon));
}

void Pen::text(double x, double y, const std::string& words, Role role, bool bold, bool centred) {
  if (words.empty() || !visible({x, y, 0.0})) return;
  drawing_.texts.push_back({static_cast<float>(x), static_cast<float>(y), words, role, bold, centred});
}

void Pen::handle(const scene::ObjectId& id, const PicturePoint& at, std::optional<std::size_t> path_point) {
  drawing_.handles.push_back(
      {id, static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.depth_m), path_point});
}

Role Pen::role_of(const scene::ObjectId& id, Role usual) const {
  if (hovered(id)) return Role::hovered;
  return selected(id) ? Role::selected : usual;
}

}  // namespace sarsim::picture
