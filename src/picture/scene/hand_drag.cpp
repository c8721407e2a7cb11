#include "picture/scene/hand_drag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "picture/figure/ticks.hpp"
#include "picture/scene/ground_point.hpp"
#include "scene/schema/quantity.hpp"
#include "scene/schema/unit_table.hpp"

namespace sarsim::picture {

namespace {

constexpr double edge_on_rad = 5.0 * core::rad_per_deg;     // A plane seen from nearer to its edge is not moved on.
constexpr double horizon_rad = 1.0 * core::rad_per_deg;     // Lines of sight go at least so steeply onto a plane.
constexpr double end_on_rad = 8.0 * core::rad_per_deg;      // An axis nearer to the line of sight is seen end on.
constexpr double flat_ring_rad = 10.0 * core::rad_per_deg;  // A ring whose axis lies nearer to the picture's plane.
constexpr double hand_coarse_px = 10.0;                     // Snapped coordinates are round to about so many pixels,
constexpr double hand_fine_px = 0.5;                        // others to so many, so that scripts do not fill up.
constexpr double fine_turn_rad = 0.1 * core::rad_per_deg;
constexpr double coarse_turn_rad = 5.0 * core::rad_per_deg;
const core::Vec3 level_normal{0.0, 0.0, 1.0};

core::Vec3 along_unit(const core::Vec3& v) { return (1.0 / core::norm(v)) * v; }

struct Sights {
  SightLine from;
  SightLine to;
};

bool seen_from_its_edge(const SightLine& line, const core::Vec3& normal) {
  return std::abs(core::dot(line.along, normal)) < std::sin(edge_on_rad);
}

// Where a line of sight meets a plane; one that passes above its horizon is lowered.
core::Vec3 on_plane(const SightLine& line, const core::Vec3& through, const core::Vec3& normal, double side) {
  core::Vec3 along = line.along;
  const double least = std::sin(horizon_rad);
  const double down = side * core::dot(along, normal);
  if (down < least) along = along + side * (least - down) * normal;
  return line.from_m + (core::dot(through - line.from_m, normal) / core::dot(along, normal)) * along;
}

core::Vec3 way_on_plane(const Sights& sights, const core::Vec3& through, const core::Vec3& normal) {
  const double side = core::dot(sights.from.along, normal) < 0.0 ? -1.0 : 1.0;
  return on_plane(sights.to, through, normal, side) - on_plane(sights.from, through, normal, side);
}

// Where an axis passes nearest to a line of sight, m from `through`.
double nearest_on_axis(const SightLine& line, const core::Vec3& through, const core::Vec3& axis) {
  const double slant = core::dot(axis, line.along);
  const core::Vec3 across = axis - slant * line.along;
  return core::dot(across, line.from_m - through) / (1.0 - slant * slant);
}

double way_along(const HandDrag& drag, const Sights& sights, const core::Vec3& axis, double up_px, double scale) {
  if (core::norm(core::cross(axis, sights.from.along)) < std::sin(end_on_rad)) return up_px / scale;
  return nearest_on_axis(sights.to, drag.place_world_m, axis) - nearest_on_axis(sights.from, drag.place_world_m, axis);
}

core::Vec3 free_way(const HandDrag& drag, const Sights& sights, double up_px, double scale, bool& upright) {
  const core::Vec3& axis = drag.axes_world[drag.lock.axis];
  switch (drag.lock.kind) {
    case HandLock::Kind::axis: return way_along(drag, sights, axis, up_px, scale) * axis;
    case HandLock::Kind::plane:
      if (!seen_from_its_edge(sights.from, axis)) return way_on_plane(sights, drag.place_world_m, axis);
      {
        const core::Vec3 seen = along_unit(core::cross(axis, sights.from.along));
        return way_along(drag, sights, seen, up_px, scale) * seen;
      }
    case HandLock::Kind::level: break;
  }
  upright = seen_from_its_edge(sights.from, level_normal);
  if (!upright) return way_on_plane(sights, drag.place_world_m, level_normal);
  const core::Vec3 facing{sights.from.along.x, sights.from.along.y, 0.0};
  return way_on_plane(sights, drag.place_world_m, along_unit(facing));
}

bool of_the_world(const HandDrag& drag) { return drag.axes_world == core::Mat3{}.row; }

// Coordinates that the view cannot change keep every digit.
core::Vec3 rounded_way(const HandDrag& drag, const core::Vec3& way, double fine, double coarse, bool snap) {
  const std::array<double, 3> place{drag.place_world_m.x, drag.place_world_m.y, drag.place_world_m.z};
  const bool snaps_places = of_the_world(drag) || drag.lock.kind == HandLock::Kind::level;
  const std::array<core::Vec3, 3> axes = drag.lock.kind == HandLock::Kind::level ? core::Mat3{}.row : drag.axes_world;
  core::Vec3 rounded;
  for (std::size_t i = 0; i < 3; ++i) {
    const double by = core::dot(way, axes[i]);
    if (std::abs(by) < 0.1 * fine) continue;
    const double from = snaps_places ? place[i] : 0.0;
    rounded = rounded + (snap ? core::rounded_to(from + by, coarse) - from : core::rounded_to(by, fine)) * axes[i];
  }
  return rounded;
}

// Of a number whose unit is not whole yet the number alone.
std::optional<double> typed_value(const std::string& typed, scene::Quantity quantity, std::string_view bare_unit) {
  if (const auto reading = scene::read_quantity(typed, quantity, bare_unit); reading.value) return reading.value;
  return scene::read_quantity(typed.substr(0, scene::number_length(typed)), quantity, bare_unit).value;
}

// In (-pi, pi].
double min_turn(double rad) {
  const double reduced = std::remainder(rad, 2.0 * core::pi);
  return reduced <= -core::pi ? reduced + 2.0 * core::pi : reduced;
}

double pointed_turn(const HandDrag& drag, const core::Vec3& axis, double x_px, double y_px) {
  const Sights sights{sight_line(drag.camera, drag.x_px, drag.y_px), sight_line(drag.camera, x_px, y_px)};
  const double facing = core::dot(sights.from.along, axis);
  if (std::abs(facing) < std::sin(flat_ring_rad)) {
    // The near side of the ring goes along this line of the picture.
    const core::Vec3 along = drag.camera.picture_from_world() * along_unit(core::cross(sights.from.along, axis));
    const double way_px = along.x * (x_px - drag.x_px) - along.y * (y_px - drag.y_px);
    return way_px / (ring_px * drag.pixel_scale);
  }
  const double side = facing < 0.0 ? -1.0 : 1.0;
  const core::Vec3 a = on_plane(sights.from, drag.place_world_m, axis, side) - drag.place_world_m;
  const core::Vec3 b = on_plane(sights.to, drag.place_world_m, axis, side) - drag.place_world_m;
  return std::atan2(core::dot(axis, core::cross(a, b)), core::dot(a, b));
}

std::string length_words(double m, double step_m) {
  return core::with_minus_sign(scene::quantity_text(core::rounded_to(m, step_m), scene::Quantity::length));
}

std::string angle_words(double rad) {
  return core::with_minus_sign(core::format_number(core::rounded_to(rad * core::deg_per_rad, 0.01)) + "°");
}

constexpr std::array<const char*, 3> hand_axis_letters{"x", "y", "z"};

std::string lock_words(const HandDrag& drag, const HandMove& move) {
  const std::string own = of_the_world(drag) ? "" : "own ";
  const std::size_t axis = drag.lock.axis;
  if (drag.lock.kind == HandLock::Kind::axis) return fmt::format(" along {}{}", own, hand_axis_letters[axis]);
  if (drag.lock.kind == HandLock::Kind::plane)
    return fmt::format(" in {}{}, {}", own, hand_axis_letters[(axis + 1) % 3], hand_axis_letters[(axis + 2) % 3]);
  return move.upright ? " upright: the ground is seen from its edge" : "";
}

}  // namespace

HandMove hand_move(const HandDrag& drag, double x_px, double y_px, bool snap) {
  const core::Vec3 in_picture = drag.camera.picture_from_world() * (drag.place_world_m - drag.camera.focus_world_m);
  const double scale = drag.camera.scale_at(-in_picture.z);
  HandMove move;
  if (scale <= 0.0) return move;
  const double fine = round_below(hand_fine_px * drag.pixel_scale / scale);
  const double coarse = round_below(hand_coarse_px * drag.pixel_scale / scale);
  move.resolution_m = snap ? coarse : fine;
  if (!drag.typed.empty()) {
    move.resolution_m = std::min(fine, 1e-3);
    move.delta_world_m =
        typed_value(drag.typed, scene::Quantity::length, "m").value_or(0.0) * drag.axes_world[drag.lock.axis];
    return move;
  }
  const Sights sights{sight_line(drag.camera, drag.x_px, drag.y_px), sight_line(drag.camera, x_px, y_px)};
  const core::Vec3 way = free_way(drag, sights, drag.y_px - y_px, scale, move.upright);
  move.delta_world_m = rounded_way(drag, way, fine, coarse, snap);
  return move;
}

double hand_turn(const HandDrag& drag, const core::Vec3& axis_world, double from_rad, double x_px, double y_px,
                 bool snap) {
  if (!drag.typed.empty())
    return typed_value(drag.typed, scene::Quantity::angle, "deg").value_or(0.0) * core::rad_per_deg;
  const double by = pointed_turn(drag, axis_world, x_px, y_px);
  if (snap) return min_turn(core::rounded_to(from_rad + by, coarse_turn_rad) - from_rad);
  return min_turn(core::rounded_to(by, fine_turn_rad));
}

std::size_t main_axis(const HandDrag& drag, const core::Vec3& delta_world_m) {
  std::array<double, 3> by{};
  for (std::size_t i = 0; i < 3; ++i) by[i] = std::abs(core::dot(delta_world_m, drag.axes_world[i]));
  return static_cast<std::size_t>(std::ranges::max_element(by) - by.begin());
}

std::string move_words(const HandDrag& drag, const HandMove& move, const core::Vec3& place_world_m) {
  const double step = move.resolution_m;
  const core::Vec3& by = move.delta_world_m;
  std::string words = fmt::format("x {}  y {}  z {}", length_words(place_world_m.x, step),
                                  length_words(place_world_m.y, step), length_words(place_world_m.z, step));
  if (!drag.typed.empty())
    return words + fmt::format("\nΔ {}{}: typed", core::with_minus_sign(drag.typed), lock_words(drag, move));
  if (drag.lock.kind == HandLock::Kind::axis)
    return words + fmt::format("\nΔ {}{}", length_words(core::dot(by, drag.axes_world[drag.lock.axis]), step),
                               lock_words(drag, move));
  return words + fmt::format("\nΔ {}, {}, {}{}", length_words(by.x, step), length_words(by.y, step),
                             length_words(by.z, step), lock_words(drag, move));
}

std::string turn_words(const HandDrag& drag, const std::string& name, double from_rad, double by_rad) {
  const std::string by = drag.typed.empty() ? angle_words(by_rad) : core::with_minus_sign(drag.typed) + ": typed";
  return fmt::format("{} {}\nΔ {}", name, angle_words(from_rad + by_rad), by);
}

}  // namespace sarsim::picture
