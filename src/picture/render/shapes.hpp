#pragma once

#include <cstddef>
#include <span>

#include "picture/render/mesh.hpp"

namespace sarsim::picture {

/// A colour as light from the north-west, 45 degrees above the horizon, shows it on a plane: the light of maps with
/// hill shading. Planes that face away from it are lit by the sky alone.
/// @param normal_world  of unit length; x east, y north, z up
[[nodiscard]] raster::Rgb shaded(raster::Rgb colour, const core::Vec3& normal_world);
/// The same by another direction of up; the light comes as far from it.
/// @param towards_light_world  of unit length
[[nodiscard]] raster::Rgb shaded(raster::Rgb colour, const core::Vec3& normal_world,
                                 const core::Vec3& towards_light_world);
/// The direction to the light of hill shading.
[[nodiscard]] core::Vec3 hill_light();

/// Heights above a plane on a grid of equal steps.
struct HeightField {
  core::Vec3 origin_world_m;  ///< Of the first height, at height 0.
  double step_x_m = 1.0;
  double step_y_m = 1.0;
  std::size_t columns = 0;           ///< Along x.
  std::span<const float> heights_m;  ///< Row by row along y: columns times rows.
};
/// The height field as two triangles a cell, with hill shading. Cells with a height that is not a finite number are
/// left out.
/// @throws std::invalid_argument  where there are fewer than two columns or rows, or the last row is not whole
[[nodiscard]] Mesh height_field_mesh(const HeightField& field, raster::Rgb colour);

/// What stands for a platform: solids that say which way it goes.
enum class Symbol { aircraft, satellite, vehicle };
/// The symbol about a place, one metre long before `length_m`, shaded.
/// @param world_from_symbol  columns: nose, left, up; of unit length
[[nodiscard]] Mesh symbol_mesh(Symbol symbol, const core::Vec3& at_world_m, const core::Mat3& world_from_symbol,
                               double length_m, raster::Rgb colour);

}  // namespace sarsim::picture
