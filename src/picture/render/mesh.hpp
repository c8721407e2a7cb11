#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/maths/vector.hpp"
#include "raster/table/rgb.hpp"
#include "scene/model/object_id.hpp"

namespace sarsim::picture {

/// Triangles in space: what the rasteriser draws. Light and shade are in the colours already (`shaded`).
struct Mesh {
  std::vector<core::Vec3> points_world_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Numbers of points; seen from either side.
  std::vector<raster::Rgb> colours;                     ///< One for each triangle, or one for all.
  /// Below 255 it is a veil: one layer over what is behind it, however many of its triangles lie upon each other.
  std::uint8_t opacity = 255;
  std::vector<scene::ObjectId> objects;  ///< What is picked: one for each triangle, or one for all; empty: nothing.
};

/// Meshes, of which those that stay the same from picture to picture are shared.
using MeshList = std::vector<std::shared_ptr<const Mesh>>;

}  // namespace sarsim::picture
