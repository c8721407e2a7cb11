#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/number_text.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/drawing_pen.hpp"

namespace sarsim::picture {

namespace {

constexpr std::array<Role, 3> axis_roles{Role::x_axis, Role::y_axis, Role::z_axis};
constexpr std::array<const char*, 3> axis_letters{"X", "Y", "Z"};
constexpr double main_axis_px = 200.0;
constexpr double mark_part = 0.9;     // of a main axis: the mark stands below
constexpr double letter_part = 1.07;  // of an axis: where its letter stands
constexpr double end_on_px = 12.0;    // a shorter line is seen end on and carries no words
constexpr double letter_drop_px = 4.0;
constexpr double triad_room_px = 48.0;   // about the corner triad: main axes end there
constexpr double label_gap_px = 12.0;    // from a mark to its label
constexpr double letter_room_px = 12.0;  // a letter that stands nearer to the edge of the picture is cut

core::Vec3 axis_of(std::size_t i) { return core::Mat3{}.row[i]; }

double distance_px(const PicturePoint& a, const PicturePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

void put_letter(Pen& pen, const PicturePoint& at, std::size_t axis) {
  pen.text(at.x, at.y + pen.px(letter_drop_px), axis_letters[axis], axis_roles[axis], true, true);
}

// A letter that the edge would cut stands just inside; one that is out of sight stays there.
PicturePoint whole_in_picture(const Pen& pen, const PicturePoint& point) {
  const double room = pen.px(letter_room_px);
  const double right = pen.camera().width_px;
  const double bottom = pen.camera().height_px;
  if (point.x < -room || point.y < -room || point.x > right + room || point.y > bottom + room) return point;
  if (right < 2.0 * room || bottom < 2.0 * room) return point;
  return {std::clamp(point.x, room, right - room), std::clamp(point.y, room, bottom - room), point.depth_m};
}

PicturePoint triad_origin(const Pen& pen) {
  return {pen.camera().width_px - pen.px(50.0), pen.camera().height_px - pen.px(50.0), 0.0};
}

bool in_triad(const Pen& pen, const PicturePoint& point) {
  return pen.options().corner_triad && distance_px(point, triad_origin(pen)) < pen.px(triad_room_px);
}

// How much of a line can be drawn before it runs into the corner triad, 0 to 1. A line that starts there runs on.
double part_before_triad(const Pen& pen, const PicturePoint& from, const PicturePoint& to) {
  const PicturePoint centre = triad_origin(pen);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double fx = from.x - centre.x;
  const double fy = from.y - centre.y;
  const double a = dx * dx + dy * dy;
  const double b = dx * fx + dy * fy;
  const double c = fx * fx + fy * fy - pen.px(triad_room_px) * pen.px(triad_room_px);
  const double root = b * b - a * c;
  if (!pen.options().corner_triad || !(a > 0.0) || !(c > 0.0) || !(b < 0.0) || !(root > 0.0)) return 1.0;
  return std::min(1.0, (-b - std::sqrt(root)) / a);
}

// Beside an axis rather than on it: to the right of a steep one, below a flat one.
void put_mark_label(Pen& pen, const PicturePoint& origin, const PicturePoint& mark, const std::string& words) {
  const double length = distance_px(origin, mark);
  double across_x = -(mark.y - origin.y) / length;
  double across_y = (mark.x - origin.x) / length;
  const bool steep = std::abs(across_x) > 0.5;
  if (steep ? across_x < 0.0 : across_y < 0.0) across_x = -across_x, across_y = -across_y;
  pen.text(mark.x + pen.px(label_gap_px * across_x),
           mark.y + pen.px(label_gap_px * across_y + letter_drop_px * (1.0 + across_y)), words, Role::text, false,
           !steep, Drawing::Hold::spare);
}

// One axis from the world's origin with the mark at a round distance.
void draw_main_axis(Pen& pen, const PicturePoint& origin, std::size_t axis, double length_m) {
  const core::Vec3 unit = axis_of(axis);
  const auto end = pen.project(length_m * unit);
  const double shown = end ? part_before_triad(pen, origin, *end) : 1.0;
  pen.world_line({}, shown * length_m * unit, axis_roles[axis], 2.0);
  if (!end || distance_px(origin, *end) < pen.px(end_on_px)) return;
  if (const auto letter = pen.project(letter_part * length_m * unit); letter && !in_triad(pen, *letter))
    put_letter(pen, whole_in_picture(pen, *letter), axis);
  const double mark_m = round_below(mark_part * length_m);
  const auto mark = pen.project(mark_m * unit);
  if (!mark || shown * length_m < mark_m || in_triad(pen, *mark) || distance_px(origin, *mark) < pen.px(end_on_px))
    return;
  pen.disc(*mark, 5.0, Role::text, false);
  if (pen.options().labels && !pen.options().coarse)
    put_mark_label(pen, origin, *mark, core::with_prefix(mark_m, "m", 3));
}

}  // namespace

void draw_axes(Pen& pen, const PicturePoint& origin, const core::Mat3& world_from_frame, double length_px,
               double width_px, bool letters) {
  const core::Mat3 axes_world = core::transposed(world_from_frame);
  for (std::size_t i = 0; i < 3; ++i) {
    const PicturePoint end = pen.along(origin, axes_world.row[i], length_px);
    pen.line(origin, end, axis_roles[i], width_px);
    if (letters && distance_px(origin, end) >= pen.px(0.2 * length_px))
      put_letter(pen, pen.along(origin, axes_world.row[i], length_px + 8.0), i);
  }
}

void draw_main_axes(Pen& pen) {
  const auto origin = pen.project({});
  if (!origin) return;
  const double length_m = pen.px(main_axis_px) / pen.camera().scale_at(origin->depth_m);
  for (std::size_t i = 0; i < 3; ++i) draw_main_axis(pen, *origin, i, length_m);
}

void draw_corner_triad(Pen& pen) { draw_axes(pen, triad_origin(pen), core::Mat3{}, 30.0, 1.0, true); }

void draw_scale_bar(Pen& pen) {
  const double length_m = round_below(pen.px(120.0) / pen.camera().pixels_per_m);
  const double length_px = length_m * pen.camera().pixels_per_m;
  const PicturePoint left{pen.px(20.0), pen.camera().height_px - pen.px(20.0), 0.0};
  const PicturePoint right{left.x + length_px, left.y, 0.0};
  pen.line(left, right, Role::text, 2.0);
  for (const PicturePoint& end : {left, right})
    pen.line({end.x, end.y - pen.px(4.0), 0.0}, {end.x, end.y + pen.px(4.0), 0.0}, Role::text, 1.0);
  pen.text(0.5 * (left.x + right.x), left.y - pen.px(7.0), core::with_prefix(length_m, "m", 3), Role::text, false,
           true);
}

}  // namespace sarsim::picture
