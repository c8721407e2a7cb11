#include "picture/scene/drawing_pen.hpp"

#include <algorithm>
#include <cmath>

namespace sarsim::picture {

namespace {

constexpr double margin_px = 64.0;            // about the picture, of the screen
constexpr double nearest_stroke_part = 1e-2;  // of the viewer's distance
constexpr double piece_px = 4.0;              // of a line, which is seen or hidden
constexpr int max_pieces = 2000;

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

}  // namespace

Pen::Pen(const Camera& camera, const DrawingOptions& options, Drawing& drawing)
    : camera_(camera),
      options_(options),
      drawing_(drawing),
      picture_from_world_(camera.picture_from_world()),
      viewpoint_(camera.viewpoint()),
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

bool Pen::hides(const PicturePoint& point) const {
  return hides_at(point.x, point.y, -point.depth_m * camera_.scale_at(point.depth_m));
}

bool Pen::hides_at(double x_px, double y_px, double nearness_px) const {
  if (drawing_.scenery == 0 || !is_hidden(drawing_.solids, viewpoint_, x_px, y_px, nearness_px)) return false;
  const auto by = triangle_at(drawing_.solids, x_px, y_px);
  return by && by->mesh < drawing_.scenery;
}

void Pen::line(const PicturePoint& a, const PicturePoint& b, Role role, double width_px, bool dotted,
               std::uint8_t tone) {
  PicturePoint from = a;
  PicturePoint to = b;
  if (!clip_segment(from, to, frame_of(camera_, options_.pixel_scale))) return;
  drawing_.lines.push_back({static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(to.x),
                            static_cast<float>(to.y), role, static_cast<float>(px(width_px)), dotted, tone});
}

void Pen::world_line(const core::Vec3& a_world_m, const core::Vec3& b_world_m, Role role, double width_px, bool dotted,
                     std::uint8_t tone) {
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
  PicturePoint from = point_of(a);
  PicturePoint to = point_of(b);
  if (!std::isfinite(from.x + from.y + to.x + to.y)) return;
  if (drawing_.scenery == 0 || drawing_.solids.empty()) {
    line(from, to, role, width_px, dotted, tone);
    return;
  }
  // Nearness, not depth, is linear along a line of the picture.
  from.depth_m = -from.depth_m * camera_.scale_at(from.depth_m);
  to.depth_m = -to.depth_m * camera_.scale_at(to.depth_m);
  seen_parts(from, to, role, width_px, dotted, tone);
}

// Pieces of some pixels are seen or hidden as their middle is; those that are seen are joined again.
void Pen::seen_parts(PicturePoint from, PicturePoint to, Role role, double width_px, bool dotted, std::uint8_t tone) {
  if (!clip_segment(from, to, frame_of(camera_, options_.pixel_scale))) return;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int pieces = std::clamp(static_cast<int>(length / px(piece_px)), 1, max_pieces);
  const auto at = [&](double t) {
    return PicturePoint{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                        from.depth_m + t * (to.depth_m - from.depth_m)};
  };
  const auto hidden_piece = [&](const PicturePoint& p) { return hides_at(p.x, p.y, p.depth_m); };
  int first = -1;  // of the pieces that are seen, up to now
  for (int i = 0; i <= pieces; ++i) {
    const bool seen = i < pieces && !hidden_piece(at((i + 0.5) / pieces));
    if (seen && first < 0) first = i;
    if (seen || first < 0) continue;
    line(at(static_cast<double>(first) / pieces), at(static_cast<double>(i) / pieces), role, width_px, dotted, tone);
    first = -1;
  }
}

void Pen::disc(const PicturePoint& at, double diameter_px, Role role, bool outlined) {
  if (!visible(at)) return;
  drawing_.discs.push_back(
      {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(px(diameter_px)), role, outlined});
}

void Pen::text(double x, double y, const std::string& words, Role role, bool bold, bool centred, Drawing::Hold hold) {
  if (words.empty() || !visible({x, y, 0.0})) return;
  drawing_.texts.push_back({static_cast<float>(x), static_cast<float>(y), words, role, bold, centred, hold});
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
