#pragma once

#include <array>
#include <vector>

#include "picture/render/raster_kernels.hpp"

namespace sarsim::picture {

/// What is seen of a triangle that reaches behind the viewer or farther than `guard_px` from the picture, as triangles
/// that do not; none where nothing is seen. Computed in double precision.
[[nodiscard]] std::vector<std::array<Corner, 3>> cut_triangle(const Viewpoint& view,
                                                              const std::array<core::Vec3, 3>& corners_world_m);

}  // namespace sarsim::picture
