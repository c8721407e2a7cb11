#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "picture/colour/theme.hpp"
#include "picture/scene/camera.hpp"

namespace sarsim::picture {

class Pen;

/// Handles at a thing by which it is moved and turned: arrows along its axes, squares between two of them, rings about
/// axes. They keep their size on the screen.
struct Gizmo {
  /// A ring that turns the thing about an axis.
  struct Ring {
    core::Vec3 axis_world;  ///< Unit.
    Role role = Role::z_axis;
  };
  core::Vec3 place_world_m;
  /// Unit, at right angles: those of the world, or of what carries the thing.
  std::array<core::Vec3, 3> axes_world{core::Vec3{1.0, 0.0, 0.0}, core::Vec3{0.0, 1.0, 0.0}, core::Vec3{0.0, 0.0, 1.0}};
  bool moves = true;  ///< It has arrows and squares.
  std::vector<Ring> rings;
};

/// One handle of a gizmo.
struct GizmoHandle {
  /// Moves along an axis, on the plane across an axis, turns.
  enum class Kind { arrow, square, ring };
  Kind kind = Kind::arrow;
  std::size_t index = 0;  ///< Of the axis along which it moves or that stands on its plane, or of the ring.

  friend bool operator==(const GizmoHandle&, const GizmoHandle&) = default;
};

/// What a drag shows: the handle that is held, or the axis that a key locked.
struct GizmoGuide {
  core::Vec3 through_world_m;
  core::Vec3 axis_world;
  Role role = Role::x_axis;
};

/// The handle under a point of the picture: the nearest within 6 pixels of the screen, squares before arrows before
/// rings. Arrows that are seen end on, squares seen from their edge, and the far halves of rings are none.
/// @param pixel_scale  device pixels per pixel of the screen
[[nodiscard]] std::optional<GizmoHandle> gizmo_handle_at(const Gizmo& gizmo, const Camera& camera, double pixel_scale,
                                                         double x_px, double y_px);

/// A point of the picture at the middle of a handle, for those who take hold of it; nothing where there is none.
[[nodiscard]] std::optional<PicturePoint> handle_point(const Gizmo& gizmo, const GizmoHandle& handle,
                                                       const Camera& camera, double pixel_scale);

/// Draws the handles that `gizmo_handle_at` finds; one of them apart.
void draw_gizmo(Pen& pen, const Gizmo& gizmo, const std::optional<GizmoHandle>& hovered);
/// A dotted line across the picture.
void draw_guide(Pen& pen, const GizmoGuide& guide);

}  // namespace sarsim::picture
