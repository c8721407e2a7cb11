#include "signal/sar/projection_tile.hpp"

#include "core/report/expect.hpp"

namespace sarsim::signal {

core::Vec3 StretchSurface::point_m(double row, double j) const {
  const double i = row - middle_row;
  core::Vec3 point_m;
  for (std::size_t a = 4; a-- > 0;) {
    const auto& t = terms[a];
    point_m = i * point_m + (t[0] + j * (t[1] + j * (t[2] + j * t[3])));
  }
  return point_m;
}

core::Vec3 ProjectionTile::point_m(std::size_t row, std::size_t column) const {
  if (!points_m.empty()) return points_m[row * columns + column];
  const auto i = static_cast<double>(row);
  if (surface.empty()) return corner_m + i * row_step_m + static_cast<double>(column) * column_step_m;
  const std::size_t stretch = columns / surface.size();
  const double j = static_cast<double>(column % stretch) - 0.5 * static_cast<double>(stretch);
  return surface[column / stretch].point_m(i, j);
}

Stretch stretch_for(double nearest_m, double column_step_m, double wavelength_m) {
  CORE_EXPECT(wavelength_m > 0.0);
  for (const Stretch stretch : {Stretch::of_64, Stretch::of_32, Stretch::of_16}) {
    const double reach_m = 0.5 * static_cast<double>(stretch) * column_step_m;
    if (reach_m > 0.1 * nearest_m) continue;
    const double x = reach_m / nearest_m;
    if (nearest_m * x * x * x * x / 8.0 < 1e-5 * 0.5 * wavelength_m) return stretch;
  }
  return Stretch::by_point;
}

}  // namespace sarsim::signal
