#include "radar/target/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sarsim::radar {
namespace surface_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
using Triangle = std::array<core::Vec3, 3>;

const Triangle right_angled{core::Vec3{0, 0, 0}, core::Vec3{0, 30, 0}, core::Vec3{40, 0, 0}};
const Triangle tilted{core::Vec3{100, 10, 5}, core::Vec3{80, -20, 30}, core::Vec3{130, -10, 50}};
const Triangle obtuse{core::Vec3{0, 0, 0}, core::Vec3{-25, 12, 0}, core::Vec3{30, 0, 0}};
const Triangle triangles[]{right_angled, tilted, obtuse};

double area(const Triangle& t) { return 0.5 * core::norm(core::cross(t[1] - t[0], t[2] - t[0])); }
core::Vec3 centroid(const Triangle& t) { return (1.0 / 3.0) * (t[0] + t[1] + t[2]); }

TEST(SurfaceLattice, HasTheAreaOfTheTriangleAsItsCrossSection) {
  for (const Triangle& t : triangles)
    for (const double density : {0.3, 1.0, 7.0}) {
      const SurfaceLattice lattice = fill_triangle(t, density);
      const auto count = static_cast<double>(lattice.points_m.size());
      EXPECT_NEAR(lattice.point_rcs_m2 * count, area(t), 1e3 * epsilon * area(t));
    }
}

// A row of mean length l holds l/D points to within one; there are height/(D sin 60) rows to within a half: the count
// differs from area times density by half a point a row and half a row, generously.
TEST(SurfaceLattice, HasAboutAsManyPointsAsAreaTimesDensity) {
  for (const Triangle& t : triangles)
    for (const double density : {1.0, 7.0}) {
      const double expected = expected_points(t, density);
      EXPECT_NEAR(expected, area(t) * density, 1e-12 * expected);
      const double side = core::norm(t[2] - t[0]) * std::sqrt(density);
      const double rows = 2.0 * area(t) * density / side;
      EXPECT_NEAR(static_cast<double>(fill_triangle(t, density).points_m.size()), expected, side + rows);
    }
}

TEST(SurfaceLattice, LiesInsideTheTriangle) {
  for (const Triangle& t : triangles) {
    const SurfaceLattice lattice = fill_triangle(t, 2.0);
    for (const core::Vec3& p : lattice.points_m)
      for (std::size_t i = 0; i < 3; ++i) {
        const core::Vec3 &a = t[i], &b = t[(i + 1) % 3];
        // Left of each edge, seen from the front: (corner 2 - corner 1) x (corner 3 - corner 1) makes them run that
        // way.
        EXPECT_GE(core::dot(core::cross(b - a, p - a), lattice.normal), -1e-9);
        EXPECT_NEAR(core::dot(p - t[0], lattice.normal), 0.0, 1e-12);
      }
  }
}

TEST(SurfaceLattice, HasItsFrontWhereTheCornersRunCounterclockwise) {
  const SurfaceLattice down = fill_triangle(right_angled, 1.0);  // (0,1,0) x (1,0,0) points down
  EXPECT_LT(core::norm(down.normal - core::Vec3{0, 0, -1}), 4.0 * epsilon);
  const SurfaceLattice up = fill_triangle({right_angled[0], right_angled[2], right_angled[1]}, 1.0);
  EXPECT_LT(core::norm(up.normal - core::Vec3{0, 0, 1}), 4.0 * epsilon);
}

TEST(SurfaceLattice, HasItsCentreAtTheTriangles) {
  for (const Triangle& t : triangles)
    for (const double density : {1.0, 4.0}) {
      const SurfaceLattice lattice = fill_triangle(t, density);
      core::Vec3 sum;
      for (const core::Vec3& p : lattice.points_m) sum = sum + p;
      const core::Vec3 mean = (1.0 / static_cast<double>(lattice.points_m.size())) * sum;
      // Each end of a row is off by up to one spacing, and the rows are independent of each other: half a spacing.
      EXPECT_LT(core::norm(mean - centroid(t)), 0.5 / std::sqrt(density));
    }
}

// Every point in the middle has six neighbours at the distance D, within what fitting whole rows changes.
TEST(SurfaceLattice, IsTriangularWithTheSpacingOfItsDensity) {
  const Triangle large{core::Vec3{0, 0, 0}, core::Vec3{0, 100, 0}, core::Vec3{100, 0, 0}};
  const SurfaceLattice lattice = fill_triangle(large, 1.0);
  const double spacing = 1.0 / std::sqrt(std::sqrt(0.75));
  const auto middle = std::ranges::min_element(lattice.points_m, {}, [](const core::Vec3& p) {
    return core::norm(p - core::Vec3{30, 30, 0});
  });
  const auto neighbours = std::ranges::count_if(lattice.points_m, [&](const core::Vec3& p) {
    const double distance = core::norm(p - *middle);
    // 107 rows share the height: each is off by less than 1/200.
    return distance > 0.0 && std::abs(distance - spacing) < 0.01 * spacing;
  });
  EXPECT_EQ(neighbours, 6);
}

TEST(SurfaceLattice, OfASmallTriangleIsOnePointAtTheCentroid) {
  const Triangle small{core::Vec3{0, 0, 1}, core::Vec3{0, 0.1, 1}, core::Vec3{0.1, 0, 1}};
  const SurfaceLattice lattice = fill_triangle(small, 1.0);
  ASSERT_EQ(lattice.points_m.size(), 1u);
  EXPECT_LT(core::norm(lattice.points_m[0] - centroid(small)), 4.0 * epsilon);
  EXPECT_NEAR(lattice.point_rcs_m2, 0.005, 1e-15);
}

TEST(SurfaceLattice, OfATriangleWithoutAreaIsEmpty) {
  EXPECT_TRUE(fill_triangle({core::Vec3{0, 0, 0}, core::Vec3{1, 1, 1}, core::Vec3{2, 2, 2}}, 1.0).points_m.empty());
  EXPECT_TRUE(fill_triangle({core::Vec3{}, core::Vec3{}, core::Vec3{}}, 1.0).points_m.empty());
  EXPECT_EQ(expected_points({core::Vec3{}, core::Vec3{}, core::Vec3{}}, 1.0), 0.0);
}

}  // namespace surface_test
}  // namespace sarsim::radar
