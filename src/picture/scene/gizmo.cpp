#include "picture/scene/gizmo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/maths/constants.hpp"
#include "picture/scene/drawing_pen.hpp"
#include "picture/scene/hand_drag.hpp"

namespace sarsim::picture {

namespace {

constexpr double arrow_from_px = 20.0;  // Nearer is the thing itself, which is taken hold of as ever.
constexpr double arrow_to_px = 96.0;
constexpr double arrow_head_px = 11.0;
constexpr double square_from_px = 28.0;
constexpr double square_to_px = 44.0;
constexpr double handle_reach_px = 6.0;
constexpr double min_arrow_px = 16.0;  // A shorter one is seen end on.
constexpr double min_facing = 0.2;     // Of a square: sine of the angle to its plane.
constexpr int ring_points = 72;
constexpr double max_behind = 0.05;  // Of a ring's radius: what is farther behind its middle is the far half.
constexpr std::array<Role, 3> gizmo_roles{Role::x_axis, Role::y_axis, Role::z_axis};
constexpr std::array<const char*, 3> gizmo_letters{"X", "Y", "Z"};

// The handles of a gizmo as lines of the picture.
class HandleLines {
 public:
  HandleLines(const Gizmo& gizmo, const Camera& camera, double pixel_scale)
      : gizmo_(gizmo),
        picture_from_world_(camera.picture_from_world()),
        scale_(pixel_scale),
        origin_(camera.project(gizmo.place_world_m)) {
    const core::Vec3 towards = picture_from_world_.row[2];
    if (!camera.perspective) {
      towards_ = towards;
      return;
    }
    const core::Vec3 eye = camera.focus_world_m + camera.viewer_distance_m() * towards - gizmo.place_world_m;
    towards_ = (1.0 / std::max(core::norm(eye), 1e-300)) * eye;
  }

  [[nodiscard]] bool seen() const { return origin_.has_value(); }
  // Pixels of the screen from the place of the thing.
  [[nodiscard]] PicturePoint at(const core::Vec3& world_px) const {
    const core::Vec3 step = scale_ * (picture_from_world_ * world_px);
    return {origin_->x + step.x, origin_->y - step.y, origin_->depth_m};
  }

  [[nodiscard]] std::vector<PicturePoint> arrow(std::size_t axis) const {
    const core::Vec3& along = gizmo_.axes_world[axis];
    const core::Vec3 seen = picture_from_world_ * along;
    if (!gizmo_.moves || (arrow_to_px - arrow_from_px) * std::hypot(seen.x, seen.y) < min_arrow_px) return {};
    return {at(arrow_from_px * along), at(arrow_to_px * along)};
  }

  [[nodiscard]] std::vector<PicturePoint> square(std::size_t axis) const {
    if (!gizmo_.moves || std::abs(core::dot(gizmo_.axes_world[axis], towards_)) < min_facing) return {};
    const core::Vec3& u = gizmo_.axes_world[(axis + 1) % 3];
    const core::Vec3& v = gizmo_.axes_world[(axis + 2) % 3];
    const auto corner = [&](double a, double b) { return at(a * u + b * v); };
    return {corner(square_from_px, square_from_px), corner(square_to_px, square_from_px),
            corner(square_to_px, square_to_px), corner(square_from_px, square_to_px),
            corner(square_from_px, square_from_px)};
  }

  // The near half, or all of a ring that faces the viewer.
  [[nodiscard]] std::vector<PicturePoint> ring(std::size_t index) const {
    const core::Vec3& axis = gizmo_.rings[index].axis_world;
    const double facing = core::dot(axis, towards_);
    core::Vec3 near = towards_ - facing * axis;
    const double length = core::norm(near);
    if (length < 0.1)  // Any direction across the axis.
      near = core::cross(axis, std::abs(axis.x) < 0.6 ? core::Vec3{1.0, 0.0, 0.0} : core::Vec3{0.0, 1.0, 0.0});
    near = (1.0 / core::norm(near)) * near;
    const core::Vec3 across = core::cross(axis, near);
    const double half_turn = length < 0.1 ? core::pi : std::acos(std::max(-1.0, -max_behind / length));
    std::vector<PicturePoint> points;
    for (int i = 0; i <= ring_points; ++i) {
      const double turn = half_turn * (2.0 * i / ring_points - 1.0);
      points.push_back(at(ring_px * (std::cos(turn) * near + std::sin(turn) * across)));
    }
    return points;
  }

  [[nodiscard]] std::vector<PicturePoint> of(const GizmoHandle& handle) const {
    switch (handle.kind) {
      case GizmoHandle::Kind::arrow: return arrow(handle.index);
      case GizmoHandle::Kind::square: return square(handle.index);
      case GizmoHandle::Kind::ring: return ring(handle.index);
    }
    return {};
  }

 private:
  const Gizmo& gizmo_;
  core::Mat3 picture_from_world_;
  double scale_;
  std::optional<PicturePoint> origin_;
  core::Vec3 towards_;  // from the thing to the viewer
};

double distance_from_line(const std::vector<PicturePoint>& line, double x, double y) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double dx = line[i].x - line[i - 1].x;
    const double dy = line[i].y - line[i - 1].y;
    const double length2 = std::max(dx * dx + dy * dy, 1e-12);
    const double t = std::clamp(((x - line[i - 1].x) * dx + (y - line[i - 1].y) * dy) / length2, 0.0, 1.0);
    least = std::min(least, std::hypot(line[i - 1].x + t * dx - x, line[i - 1].y + t * dy - y));
  }
  return least;
}

// 0 within a square.
double distance_from_square(const std::vector<PicturePoint>& corners, double x, double y) {
  int left = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const PicturePoint& a = corners[i - 1];
    const PicturePoint& b = corners[i];
    left += (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) > 0.0 ? 1 : 0;
  }
  const bool inside = corners.size() == 5 && (left == 0 || left == 4);
  return inside ? 0.0 : distance_from_line(corners, x, y);
}

std::vector<GizmoHandle> handles_of(const Gizmo& gizmo, GizmoHandle::Kind kind) {
  const std::size_t count = kind == GizmoHandle::Kind::ring ? gizmo.rings.size() : gizmo.moves ? 3 : 0;
  std::vector<GizmoHandle> handles;
  for (std::size_t i = 0; i < count; ++i) handles.push_back({kind, i});
  return handles;
}

constexpr std::array handle_kinds{GizmoHandle::Kind::square, GizmoHandle::Kind::arrow, GizmoHandle::Kind::ring};

void draw_lines(Pen& pen, const std::vector<PicturePoint>& points, Role role, double width_px) {
  for (std::size_t i = 1; i < points.size(); ++i) pen.line(points[i - 1], points[i], role, width_px);
}

void draw_arrow_head(Pen& pen, const std::vector<PicturePoint>& arrow, Role role) {
  const PicturePoint& tip = arrow.back();
  const double dx = tip.x - arrow.front().x;
  const double dy = tip.y - arrow.front().y;
  const double length = std::hypot(dx, dy);
  const double head = std::min(pen.px(arrow_head_px), 0.5 * length) / length;
  for (const double side : {-0.45, -0.3, -0.15, 0.0, 0.15, 0.3, 0.45})
    pen.line({tip.x - head * (dx - side * dy), tip.y - head * (dy + side * dx), tip.depth_m}, tip, role, 2.0);
}

}  // namespace

std::optional<GizmoHandle> gizmo_handle_at(const Gizmo& gizmo, const Camera& camera, double pixel_scale, double x_px,
                                           double y_px) {
  const HandleLines lines(gizmo, camera, pixel_scale);
  if (!lines.seen()) return std::nullopt;
  for (const GizmoHandle::Kind kind : handle_kinds) {
    std::optional<GizmoHandle> nearest;
    double least = handle_reach_px * pixel_scale;
    for (const GizmoHandle& handle : handles_of(gizmo, kind)) {
      const std::vector<PicturePoint> line = lines.of(handle);
      const double distance = kind == GizmoHandle::Kind::square ? 3.0 * distance_from_square(line, x_px, y_px)
                                                                : distance_from_line(line, x_px, y_px);
      if (distance <= least) least = distance, nearest = handle;
    }
    if (nearest) return nearest;
  }
  return std::nullopt;
}

std::optional<PicturePoint> handle_point(const Gizmo& gizmo, const GizmoHandle& handle, const Camera& camera,
                                         double pixel_scale) {
  const HandleLines lines(gizmo, camera, pixel_scale);
  if (!lines.seen()) return std::nullopt;
  const std::vector<PicturePoint> line = lines.of(handle);
  if (line.empty()) return std::nullopt;
  if (handle.kind == GizmoHandle::Kind::ring) return line[line.size() / 2];
  const PicturePoint& a = line.front();
  const PicturePoint& b = handle.kind == GizmoHandle::Kind::square ? line[2] : line.back();
  return PicturePoint{0.5 * (a.x + b.x), 0.5 * (a.y + b.y), a.depth_m};
}

void draw_gizmo(Pen& pen, const Gizmo& gizmo, const std::optional<GizmoHandle>& hovered) {
  const HandleLines lines(gizmo, pen.camera(), pen.options().pixel_scale);
  if (!lines.seen()) return;
  for (const GizmoHandle::Kind kind : handle_kinds)
    for (const GizmoHandle& handle : handles_of(gizmo, kind)) {
      const std::vector<PicturePoint> line = lines.of(handle);
      if (line.empty()) continue;
      const bool held = hovered == handle;
      const Role usual = kind == GizmoHandle::Kind::ring ? gizmo.rings[handle.index].role : gizmo_roles[handle.index];
      const Role role = held ? Role::hovered : usual;
      draw_lines(pen, line, role, held ? 4.0 : 2.0);
      if (kind != GizmoHandle::Kind::arrow) continue;
      draw_arrow_head(pen, line, role);
      const PicturePoint letter = lines.at((arrow_to_px + 9.0) * gizmo.axes_world[handle.index]);
      pen.text(letter.x, letter.y + pen.px(4.0), gizmo_letters[handle.index], role, true, true);
    }
}

void draw_hands(Pen& pen) {
  const DrawingOptions& options = pen.options();
  if (options.ruler) draw_ruler(pen, *options.ruler, options.ruler_words);
  if (options.guide) draw_guide(pen, *options.guide);
  if (options.gizmo) draw_gizmo(pen, *options.gizmo, options.hovered_handle);
}

void draw_guide(Pen& pen, const GizmoGuide& guide) {
  const Camera& camera = pen.camera();
  const double reach_m = 4.0 * (camera.width_px + camera.height_px) / camera.pixels_per_m;
  pen.world_line(guide.through_world_m - reach_m * guide.axis_world, guide.through_world_m + reach_m * guide.axis_world,
                 guide.role, 1.0, true);
}

}  // namespace sarsim::picture
