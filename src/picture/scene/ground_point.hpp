#pragma once

#include <optional>

#include "core/maths/vector.hpp"
#include "picture/scene/camera.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::picture {

/// What is seen at a point of the picture lies on this line.
struct SightLine {
  core::Vec3 from_m;  ///< Any point of it; of a perspective view the viewer's eye.
  core::Vec3 along;   ///< Unit, away from the viewer.
  double first_m;     ///< Nothing before it is seen; of an orthographic view nothing is behind the viewer.
};
[[nodiscard]] SightLine sight_line(const Camera& camera, double x_px, double y_px);

/// The point of the ground that is seen at a point of the picture, in the world: of the ellipsoid, where the world has
/// an Earth, otherwise of the plane z = 0. Nothing where the line of sight passes it by, or runs along the plane.
///
/// @param x_px  device pixels to the right of the picture's left edge; y_px below its upper edge
[[nodiscard]] std::optional<core::Vec3> ground_under(const Camera& camera, double x_px, double y_px,
                                                     const std::optional<radar::EarthFrame>& earth);

/// Where a line meets the ground first, as `ground_under`.
[[nodiscard]] std::optional<core::Vec3> ground_along(const SightLine& line,
                                                     const std::optional<radar::EarthFrame>& earth);

/// The point of the level plane through `world_m` that is seen at a point of the picture; nothing where the plane is
/// seen within 5 degrees of its edge.
[[nodiscard]] std::optional<core::Vec3> level_under(const Camera& camera, double x_px, double y_px,
                                                    const core::Vec3& world_m);

}  // namespace sarsim::picture
