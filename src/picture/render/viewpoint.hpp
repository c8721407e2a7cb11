#pragma once

#include "core/maths/vector.hpp"

namespace sarsim::picture {

/// Where a picture is seen from, as the rasteriser needs it. With p the place of a point from the focus in the axes of
/// the picture (right, up, towards the viewer) [m], it is seen scale * (p.x, -p.y) from the middle of the picture, and
/// its nearness is scale * p.z, all in pixels, where scale = pixels_per_m / (1 - p.z * inverse_viewer_m). Nearness is a
/// linear function of the place in the picture on every plane, in perspective as well.
struct Viewpoint {
  core::Mat3 picture_from_world;
  core::Vec3 focus_world_m;
  double pixels_per_m = 1.0;      ///< At the focus.
  double inverse_viewer_m = 0.0;  ///< One over the distance from the viewer to the focus; 0: orthographic.
  double width_px = 0.0;
  double height_px = 0.0;
};

/// Nothing is drawn nearer to the viewer of a perspective view than this part of the distance to the focus.
inline constexpr double nearest_seen_part = 1e-3;

}  // namespace sarsim::picture
