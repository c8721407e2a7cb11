#include "workflow/image/polynomial_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::workflow {
namespace polynomial_surface_test {

double wanted(double x, double y) { return 3.0 - 2e-3 * x + 5e-7 * x * x * y - 4e-4 * y * y; }

std::vector<SurfacePoint> points(std::size_t across, std::size_t along) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < across; ++i)
    for (std::size_t j = 0; j < along; ++j) {
      const double x = 400.0 * static_cast<double>(i) - 900.0;
      const double y = 150.0 * static_cast<double>(j) - 300.0;
      points.push_back({x, y, wanted(x, y)});
    }
  return points;
}

TEST(PolynomialSurface, FindsWhatItWasMadeOf) {
  const auto surface = polynomial_surface(points(5, 6), 2, 3);
  ASSERT_EQ(surface.size(), 3U);
  ASSERT_EQ(surface[0].size(), 4U);
  EXPECT_NEAR(surface[0][0], 3.0, 1e-9);
  EXPECT_NEAR(surface[1][0], -2e-3, 1e-12);
  EXPECT_NEAR(surface[2][1], 5e-7, 1e-15);
  EXPECT_NEAR(surface[0][2], -4e-4, 1e-12);
  for (const SurfacePoint& point : points(9, 9))
    EXPECT_NEAR(surface_value(surface, point.x, point.y), point.value, 1e-9 * std::abs(point.value) + 1e-9);
}

// Of a single row nothing is known of the other direction.
TEST(PolynomialSurface, LeavesOutWhatPointsDoNotTell) {
  const auto surface = polynomial_surface(points(1, 6), 2, 2);
  EXPECT_EQ(surface[1][0], 0.0);
  EXPECT_EQ(surface[2][2], 0.0);
  for (const SurfacePoint& point : points(1, 6))
    EXPECT_NEAR(surface_value(surface, point.x, point.y), point.value, 1e-9);
}

}  // namespace polynomial_surface_test
}  // namespace sarsim::workflow
