#include <algorithm>
#include <cmath>

#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/drawing_pen.hpp"
#include "scene/schema/quantity.hpp"

namespace sarsim::picture {

namespace {

constexpr double grid_px = 90.0;         // between lines, at most twice as much
constexpr double grid_part = 0.45;       // of the picture's larger side that the grid reaches from its middle
constexpr double label_out_px = 10.0;    // from the end of a line to its distance
constexpr double edge_on = 0.035;        // sine of the elevation below which the plane is a line
constexpr double far_from_ground = 5.0;  // widths of the picture

struct Grid {
  double step_m = 1.0;
  long first[2] = {0, 0};  // of lines, in steps, along x and y
  long last[2] = {0, 0};
};

// Under what is looked at: where the line of sight through the focus meets the plane.
std::optional<Grid> grid_of(const Camera& camera, double pixel_scale) {
  const core::Mat3 axes = camera.picture_from_world();
  const core::Vec3 towards_viewer = axes.row[2];
  if (std::abs(towards_viewer.z) < edge_on) return std::nullopt;
  const double way_m = camera.focus_world_m.z / towards_viewer.z;
  if (std::abs(way_m) * camera.pixels_per_m > far_from_ground * camera.width_px) return std::nullopt;
  const core::Vec3 middle = camera.focus_world_m - way_m * towards_viewer;
  Grid grid;
  grid.step_m = round_below(2.0 * grid_px * pixel_scale / camera.pixels_per_m);
  const double reach_m = grid_part * std::max(camera.width_px, camera.height_px) / camera.pixels_per_m;
  const long lines = std::max(3L, std::lround(reach_m / grid.step_m));
  for (int axis = 0; axis < 2; ++axis) {
    const long at = std::lround((axis == 0 ? middle.x : middle.y) / grid.step_m);
    grid.first[axis] = at - lines;
    grid.last[axis] = at + lines;
  }
  return grid;
}

core::Vec3 node(const Grid& grid, int axis, long along, long across) {
  const double a = static_cast<double>(along) * grid.step_m;
  const double b = static_cast<double>(across) * grid.step_m;
  return axis == 0 ? core::Vec3{a, b, 0.0} : core::Vec3{b, a, 0.0};
}

// A distance stands beyond the end of its line that is lower in the picture.
void put_distance(Pen& pen, const core::Vec3& one, const core::Vec3& other, double value_m) {
  const auto a = pen.project(one);
  const auto b = pen.project(other);
  if (!a || !b) return;
  const PicturePoint& near = a->y >= b->y ? *a : *b;
  const PicturePoint& far = a->y >= b->y ? *b : *a;
  const double length = std::hypot(near.x - far.x, near.y - far.y);
  if (length < 1.0 || !pen.visible(near)) return;
  const double out = pen.px(label_out_px) / length;
  pen.text(near.x + out * (near.x - far.x), near.y + out * (near.y - far.y) + pen.px(4.0),
           core::with_minus_sign(scene::quantity_text(core::tidy(value_m, 6), scene::Quantity::length)), Role::text,
           false, true, Drawing::Hold::spare);
}

}  // namespace

void draw_ground_grid(Pen& pen) {
  const auto grid = grid_of(pen.camera(), pen.options().pixel_scale);
  if (!grid) return;
  const bool words = pen.options().labels && !pen.options().coarse;
  for (int axis = 0; axis < 2; ++axis)
    for (long along = grid->first[axis]; along <= grid->last[axis]; ++along) {
      const core::Vec3 from = node(*grid, axis, along, grid->first[1 - axis]);
      const core::Vec3 to = node(*grid, axis, along, grid->last[1 - axis]);
      pen.world_line(from, to, Role::faint, along == 0 ? 2.0 : 1.0);
      // The ends of both families meet at the corners. 0 is said once, where no axes with their own words show it.
      const bool inner = along > grid->first[axis] && along < grid->last[axis];
      const bool said = along == 0 && (axis != 0 || pen.options().coordinate_systems);
      if (words && inner && !said) put_distance(pen, from, to, static_cast<double>(along) * grid->step_m);
    }
}

}  // namespace sarsim::picture
