#include "picture/render/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::picture {
namespace {

TEST(Shading, FollowsTheAngleToALightFromTheNorthWest) {
  const raster::Rgb grey{200, 100, 50};
  EXPECT_EQ(shaded(grey, hill_light()), grey);
  const raster::Rgb flat = shaded(grey, {0, 0, 1});
  EXPECT_EQ(flat.red, std::lround(200 * (0.45 + 0.55 * std::sqrt(0.5))));
  const raster::Rgb away = shaded(grey, -hill_light());
  EXPECT_EQ(away.red, 90);
  EXPECT_EQ(away.green, 45);
  // A slope to the north-west is lighter than one to the south-east.
  const double h = std::sqrt(0.125);
  EXPECT_GT(shaded(grey, {-h, h, std::sqrt(0.75)}).red, flat.red);
  EXPECT_LT(shaded(grey, {h, -h, std::sqrt(0.75)}).red, flat.red);
}

TEST(HeightField, HasTwoTrianglesACellThroughItsHeights) {
  const std::vector<float> heights{0, 1, 2, 10, 11, 12};
  const Mesh mesh = height_field_mesh({{100, 200, 5}, 2.0, 3.0, 3, heights}, {200, 200, 200});
  ASSERT_EQ(mesh.points_world_m.size(), 6U);
  EXPECT_EQ(mesh.points_world_m[4], (core::Vec3{102, 203, 16}));
  ASSERT_EQ(mesh.triangles.size(), 4U);
  ASSERT_EQ(mesh.colours.size(), 4U);
  // One plane: z = 0.5 x + 10/3 y.
  const double length = std::sqrt(0.25 + 100.0 / 9.0 + 1.0);
  const raster::Rgb expected = shaded({200, 200, 200}, {-0.5 / length, -10.0 / 3.0 / length, 1.0 / length});
  for (const raster::Rgb colour : mesh.colours) EXPECT_EQ(colour, expected);
}

TEST(HeightField, LeavesOutCellsWithoutAHeight) {
  std::vector<float> heights(16, 1.0F);
  heights[5] = std::nanf("");
  const Mesh mesh = height_field_mesh({{}, 1.0, 1.0, 4, heights}, {200, 200, 200});
  EXPECT_EQ(mesh.triangles.size(), 18U - 6U);
}

TEST(HeightField, RefusesWhatIsNoGrid) {
  const std::vector<float> heights(5, 0.0F);
  for (const std::size_t columns : {0U, 1U, 2U, 3U, 5U})
    EXPECT_THROW(static_cast<void>(height_field_mesh({{}, 1.0, 1.0, columns, heights}, {})), std::invalid_argument);
}

TEST(Symbols, AreOneLengthLongAlongTheirNose) {
  const core::Mat3 nose_north{{core::Vec3{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
  for (const Symbol symbol : {Symbol::aircraft, Symbol::satellite, Symbol::vehicle}) {
    const Mesh mesh = symbol_mesh(symbol, {10, 20, 30}, nose_north, 8.0, {200, 200, 200});
    double longest = 0.0;
    for (const core::Vec3& point : mesh.points_world_m) {
      for (const core::Vec3& other : mesh.points_world_m) longest = std::max(longest, core::norm(point - other));
      EXPECT_LE(core::norm(point - core::Vec3{10, 20, 30}), 0.6 * 8.0);
    }
    EXPECT_NEAR(longest, 8.0, 0.6);
    ASSERT_EQ(mesh.colours.size(), mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) EXPECT_LT(std::max({a, b, c}), mesh.points_world_m.size());
  }
  // The nose of an aircraft is its northernmost point.
  const Mesh plane = symbol_mesh(Symbol::aircraft, {}, nose_north, 8.0, {200, 200, 200});
  EXPECT_NEAR(std::ranges::max(plane.points_world_m, {}, &core::Vec3::y).y, 4.0, 1e-12);
}

// Solids turn their outsides outwards: a plane on top is lighter than one below.
TEST(Symbols, AreLitFromAbove) {
  for (const Symbol symbol : {Symbol::satellite, Symbol::vehicle}) {
    const Mesh mesh = symbol_mesh(symbol, {}, core::Mat3{}, 1.0, {200, 200, 200});
    double above = 0.0;
    double below = 0.0;
    double highest = -1.0;
    double lowest = 1.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      const double z = (mesh.points_world_m[a].z + mesh.points_world_m[b].z + mesh.points_world_m[c].z) / 3.0;
      if (z > highest) highest = z, above = mesh.colours[i].red;
      if (z < lowest) lowest = z, below = mesh.colours[i].red;
    }
    EXPECT_GT(above, below + 50.0);
  }
}

}  // namespace
}  // namespace sarsim::picture
