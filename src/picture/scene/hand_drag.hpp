#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "core/maths/vector.hpp"
#include "picture/scene/camera.hpp"

namespace sarsim::picture {

/// Along what a hand moves a thing.
struct HandLock {
  /// On the level plane through it; along one of its axes; on the plane across one.
  enum class Kind { level, axis, plane };
  Kind kind = Kind::level;
  std::size_t axis = 0;  ///< Of `HandDrag::axes_world`; of Kind::plane the one that stands on the plane.

  friend bool operator==(const HandLock&, const HandLock&) = default;
};

/// A thing in the hand: where thing and pointer were when the drag began, and what the drag may change. A value: where
/// the pointer goes is told to `hand_move` and `hand_turn`.
struct HandDrag {
  Camera camera;
  double x_px = 0.0;  ///< Of the pointer, device pixels.
  double y_px = 0.0;
  double pixel_scale = 1.0;  ///< Device pixels per pixel of the screen.
  core::Vec3 place_world_m;  ///< Of the thing.
  /// Unit, at right angles: those of the world, or of what carries the thing.
  std::array<core::Vec3, 3> axes_world{core::Vec3{1.0, 0.0, 0.0}, core::Vec3{0.0, 1.0, 0.0}, core::Vec3{0.0, 0.0, 1.0}};
  HandLock lock;
  /// A distance along the locked axis, or an angle, as it is being typed, in place of the pointer's; empty: the
  /// pointer's.
  std::string typed;
};

/// How far a hand has moved a thing.
struct HandMove {
  core::Vec3 delta_world_m;   ///< All the way from where it was.
  double resolution_m = 0.0;  ///< To which it is rounded.
  bool upright = false;       ///< The level plane is seen from its edge: the thing moves on an upright one.
};

/// How far the thing is moved with the pointer at a point of the picture. On the level plane and on planes along the
/// axes it stays under the pointer, along an axis as near to it as it can. Where the level plane is seen within 5
/// degrees of its edge, the thing moves on the upright plane that faces the viewer; where another plane is, along the
/// line as which it is seen; where an axis is seen end on, the way up in the picture counts. Above the horizon of a
/// perspective view a thing goes as far as a line of sight one degree below it.
///
/// Ways are rounded to half a pixel. With `snap` coordinates are round to about ten pixels: steps of 1, 2 or 5 times a
/// power of ten; along axes that are not the world's the ways are. What the view cannot change keeps every digit. A
/// typed distance is taken as it is, in m unless it has a unit; until it is a number, the object stays where it was.
[[nodiscard]] HandMove hand_move(const HandDrag& drag, double x_px, double y_px, bool snap);

/// By what angle the thing is turned about an axis through it with the pointer at a point of the picture, rad,
/// right-handed about the axis, of the pointer in (-pi, pi]. An axis that is seen within 10 degrees of the picture's
/// plane turns by a degree for each `ring_px` pi/180 pixels along the ring. Rounded to 0.1 degrees; with `snap`
/// `from_rad` and what is added are together a multiple of 5 degrees. What is typed is in degrees, or has a unit.
/// @param axis_world  unit
/// @param from_rad    the angle that is changed, as it was
[[nodiscard]] double hand_turn(const HandDrag& drag, const core::Vec3& axis_world, double from_rad, double x_px,
                               double y_px, bool snap);

/// The axis along which most of a way lies, for numbers that are typed before an axis is locked; of a way of no length
/// the first.
[[nodiscard]] std::size_t main_axis(const HandDrag& drag, const core::Vec3& delta_world_m);

/// Radius of the rings by which things are turned, pixels of the screen.
inline constexpr double ring_px = 70.0;

/// What a drag shows beside the pointer, two lines: "x 1.25 km  y 300 m  z 0 m" and "Δ 250 m along x".
/// @param place_world_m  where the thing is now, in the world
[[nodiscard]] std::string move_words(const HandDrag& drag, const HandMove& move, const core::Vec3& place_world_m);

/// The same of a turn: "yaw 45°" and "Δ +15°".
/// @param name  of the angle
[[nodiscard]] std::string turn_words(const HandDrag& drag, const std::string& name, double from_rad, double by_rad);

}  // namespace sarsim::picture
