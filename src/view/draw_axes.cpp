#include <array>
#include <cmath>

#include "base/number_text.hpp"
#include "view/drawing_pen.hpp"
#include "view/ticks.hpp"

namespace sarsim {

namespace {

constexpr std::array<Role, 3> axis_roles{Role::x_axis, Role::y_axis, Role::z_axis};
constexpr std::array<const char*, 3> axis_letters{"X", "Y", "Z"};
constexpr double main_axis_px = 200.0;
constexpr double mark_part = 0.9;     // of a main axis: the mark stands below
constexpr double letter_part = 1.07;  // of an axis: where its letter stands
constexpr double end_on_px = 12.0;    // a shorter line is seen end on and carries no words
constexpr double letter_drop_px = 4.0;

Vec3 axis_of(std::size_t i) { return Mat3{}.row[i]; }

double distance_px(const PicturePoint& a, const PicturePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

void put_letter(Pen& pen, const PicturePoint& at, std::size_t axis) {
  pen.text(at.x, at.y + pen.px(letter_drop_px), axis_letters[axis], axis_roles[axis], true, true);
}

// One axis from the world's origin with the mark at a round distance.
void draw_main_axis(Pen& pen, const PicturePoint& origin, std::size_t axis, double length_m) {
  const Vec3 unit = axis_of(axis);
  pen.world_line({}, length_m * unit, axis_roles[axis], 2.0);
  const auto end = pen.project(length_m * unit);
  if (!end || distance_px(origin, *end) < pen.px(end_on_px)) return;
  if (const auto letter = pen.project(letter_part * length_m * unit)) put_letter(pen, *letter, axis);
  const double mark_m = round_below(mark_part * length_m);
  const auto mark = pen.project(mark_m * unit);
  if (!mark || distance_px(origin, *mark) < pen.px(end_on_px)) return;
  pen.disc(*mark, 5.0, Role::text, false);
  if (pen.options().labels && !pen.options().coarse)
    pen.text(mark->x + pen.px(6.0), mark->y + pen.px(14.0), with_prefix(mark_m, "m", 3), Role::text, false, false);
}

}  // namespace

void draw_axes(Pen& pen, const PicturePoint& origin, const Mat3& world_from_frame, double length_px, double width_px,
               bool letters) {
  const Mat3 axes_world = transposed(world_from_frame);
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

void draw_corner_triad(Pen& pen) {
  const PicturePoint origin{pen.camera().width_px - pen.px(50.0), pen.camera().height_px - pen.px(50.0), 0.0};
  draw_axes(pen, origin, Mat3{}, 30.0, 1.0, true);
}

void draw_scale_bar(Pen& pen) {
  const double length_m = round_below(pen.px(120.0) / pen.camera().pixels_per_m);
  const double length_px = length_m * pen.camera().pixels_per_m;
  const PicturePoint left{pen.px(20.0), pen.camera().height_px - pen.px(20.0), 0.0};
  const PicturePoint right{left.x + length_px, left.y, 0.0};
  pen.line(left, right, Role::text, 2.0);
  for (const PicturePoint& end : {left, right})
    pen.line({end.x, end.y - pen.px(4.0), 0.0}, {end.x, end.y + pen.px(4.0), 0.0}, Role::text, 1.0);
  pen.text(0.5 * (left.x + right.x), left.y - pen.px(7.0), with_prefix(length_m, "m", 3), Role::text, false, true);
}

}  // namespace sarsim
