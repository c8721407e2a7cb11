#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// A triangle as point scatterers (decision 23).
struct SurfaceLattice {
  std::vector<core::Vec3> points_m;  ///< In the frame of the corners.
  core::Vec3 normal;                 ///< Unit vector to the front: along (corner 2 - corner 1) x (corner 3 - corner 1).
  double point_rcs_m2 = 0.0;         ///< Of each point facing the radar; all of them together have the triangle's area.
};

/// Points that `fill_triangle` would make, about (area times density); 0 for a triangle without area.
[[nodiscard]] double expected_points(const std::array<core::Vec3, 3>& corners_m, double points_per_m2);

/// Fills a triangle with a staggered (triangular) lattice: rows parallel to the side from corner 1 to corner 3, at
/// distance D sin 60 deg (stretched or squeezed so that whole rows fill the height), points D apart,
/// D = 1/sqrt(density sin 60 deg), every other row shifted by D/2. Rows stand in the middle of equal strips, so that
/// the points' centre is the triangle's to about half a spacing. At least one point, at the centroid.
[[nodiscard]] SurfaceLattice fill_triangle(const std::array<core::Vec3, 3>& corners_m, double points_per_m2);

}  // namespace sarsim::radar
