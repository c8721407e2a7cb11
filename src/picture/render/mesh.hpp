#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "raster/table/rgb.hpp"
#include "scene/model/object.hpp"

namespace sarsim::picture {

/// Triangles in space with colours: what the rasteriser draws.
struct Mesh {
  std::vector<core::Vec3> points_world_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Three points each; seen from either side.
  std::vector<raster::Rgb> colours;                     ///< One for each point, or one for all.
  std::uint8_t opacity = 255;  ///< Below 255 it is laid over what is behind it, in the order of the meshes.
  bool lit = true;             ///< Shaded by a light from above left of the viewer; otherwise the colours as they are.
  std::optional<scene::ObjectId> object;  ///< What is picked at its pixels.
};

}  // namespace sarsim::picture
