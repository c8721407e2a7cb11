#include "radar/target/surface.hpp"

#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

double area_m2(const std::array<core::Vec3, 3>& c) { return 0.5 * core::norm(core::cross(c[1] - c[0], c[2] - c[0])); }

}  // namespace

double expected_points(const std::array<core::Vec3, 3>& corners_m, double points_per_m2) {
  CORE_EXPECT(points_per_m2 > 0.0);
  return area_m2(corners_m) * points_per_m2;
}

SurfaceLattice fill_triangle(const std::array<core::Vec3, 3>& corners_m, double points_per_m2) {
  CORE_EXPECT(points_per_m2 > 0.0);
  SurfaceLattice lattice;
  const double area = area_m2(corners_m);
  if (!(area > 0.0)) return lattice;
  const core::Vec3 side = corners_m[2] - corners_m[0];
  const double base = core::norm(side);
  const core::Vec3 along = (1.0 / base) * side;
  const core::Vec3 scaled_normal = core::cross(corners_m[1] - corners_m[0], side);
  lattice.normal = (1.0 / core::norm(scaled_normal)) * scaled_normal;
  const core::Vec3 across = core::cross(along, lattice.normal);  // in the plane, from the side towards corner 2
  const double height = 2.0 * area / base;
  const double apex = core::dot(corners_m[1] - corners_m[0], along);

  const double spacing = 1.0 / std::sqrt(points_per_m2 * std::sqrt(0.75));
  const double row_step = spacing * std::sqrt(0.75);
  const auto rows = static_cast<std::size_t>(std::max(1.0, std::round(height / row_step)));
  for (std::size_t k = 0; k < rows; ++k) {
    // Rows stand in the middle of equal strips; within a row, points on one common staggered grid.
    const double up = height * (static_cast<double>(k) + 0.5) / static_cast<double>(rows);
    const double left = apex * up / height;
    const double right = left + base * (1.0 - up / height);
    const double shift = k % 2 == 0 ? 0.25 : 0.75;
    for (double m = std::ceil(left / spacing - shift); (m + shift) * spacing < right; m += 1.0)
      lattice.points_m.push_back(corners_m[0] + (m + shift) * spacing * along + up * across);
  }
  if (lattice.points_m.empty()) lattice.points_m.push_back((1.0 / 3.0) * (corners_m[0] + corners_m[1] + corners_m[2]));
  lattice.point_rcs_m2 = area / static_cast<double>(lattice.points_m.size());
  return lattice;
}

}  // namespace sarsim::radar
