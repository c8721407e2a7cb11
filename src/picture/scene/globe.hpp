#pragma once

#include "picture/render/mesh.hpp"
#include "picture/scene/camera.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::picture {

/// The ellipsoid, 2 km below itself so that what lies on it is seen: 2 degrees to a cell, a little lighter where the
/// anchor's sun is high.
[[nodiscard]] Mesh globe_mesh(const radar::EarthFrame& earth, bool dark);

/// True where the ellipsoid leaves the plane tangent at the anchor by more than 3 pixels within the picture: the ground
/// is then shown as a globe with meridians and parallels, otherwise as that plane.
[[nodiscard]] bool shows_curvature(const Camera& camera);

}  // namespace sarsim::picture
