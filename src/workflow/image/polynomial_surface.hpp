#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::workflow {

/// A value at a place.
struct SurfacePoint {
  double x = 0.0;
  double y = 0.0;
  double value = 0.0;
};

/// The polynomial c[i][j] x^i y^j of degrees `degree_x` and `degree_y` that comes closest to points in the least
/// squares. Coordinates are scaled to 1 while it is found, so that no power is lost to rounding. Where the points do
/// not determine it, as along a single line, coefficients of high powers are 0.
[[nodiscard]] std::vector<std::vector<double>> polynomial_surface(std::span<const SurfacePoint> points,
                                                                  std::size_t degree_x, std::size_t degree_y);

/// The value of such a polynomial.
[[nodiscard]] double surface_value(const std::vector<std::vector<double>>& polynomial, double x, double y);

}  // namespace sarsim::workflow
