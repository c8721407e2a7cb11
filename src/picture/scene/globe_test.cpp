#include "picture/scene/globe.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/colour/theme.hpp"
#include "picture/scene/draw_scene.hpp"
#include "picture/scene/drawing.hpp"

namespace sarsim::picture {
namespace globe_test {

const radar::EarthFrame earth({{0.5, -1.2, 0.0}, 0.0});

Snapshot empty_earth() {
  Snapshot snapshot;
  snapshot.earth = earth;
  snapshot.globe = {std::make_shared<const Mesh>(globe_mesh(earth, false)),
                    std::make_shared<const Mesh>(globe_mesh(earth, true))};
  return snapshot;
}

// 100 km a pixel: the whole globe, 128 pixels across.
Camera far_away() {
  Camera camera = Camera::start(400.0, 300.0);
  camera.pixels_per_m = 1e-5;
  camera.focus_world_m = earth.world_from_ecef({});
  return camera;
}

DrawingOptions grid_alone() {
  DrawingOptions options;
  options.coordinate_systems = options.corner_triad = options.labels = false;
  options.ground_grid = true;
  return options;
}

double length_px(const Drawing::Line& line) {
  return std::hypot(static_cast<double>(line.x1 - line.x0), static_cast<double>(line.y1 - line.y0));
}

TEST(Globe, IsClosedAndTwoKilometresBelowTheEllipsoid) {
  const Mesh mesh = globe_mesh(earth, false);
  for (std::size_t i = 0; i < mesh.points_world_m.size(); i += 97)
    EXPECT_NEAR(earth.geodetic_of(mesh.points_world_m[i]).height_m, -2000.0, 1e-3);
  // Nowhere above the ellipsoid, and its triangles not much below their corners.
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 41) {
    const auto& [a, b, c] = mesh.triangles[i];
    const core::Vec3 middle = (1.0 / 3.0) * (mesh.points_world_m[a] + mesh.points_world_m[b] + mesh.points_world_m[c]);
    const double height_m = earth.geodetic_of(middle).height_m;
    EXPECT_LT(height_m, -1999.0);
    EXPECT_GT(height_m, -3800.0);  // R (2 deg)^2 2/9 = 1.73 km at the middle of one
  }
  // V - E + F = 2 with 3 F = 2 E, but for the doubled points at both poles.
  EXPECT_EQ(mesh.triangles.size(), 2U * 180U * 89U);
}

TEST(Globe, CoversADiscOfTheEarthsRadius) {
  Drawing drawing;
  draw_scene(empty_earth(), far_away(), grid_alone(), drawing);
  const auto covered = std::ranges::count_if(drawing.solids.argb, [](std::uint32_t argb) { return argb != 0; });
  const double radius_px = 6.37e6 * 1e-5;
  EXPECT_NEAR(static_cast<double>(covered), 3.14159 * radius_px * radius_px, 0.01 * 3.14159 * radius_px * radius_px);
}

TEST(Globe, HidesMeridiansOfTheOtherSide) {
  Drawing drawing;
  draw_scene(empty_earth(), far_away(), grid_alone(), drawing);
  ASSERT_GT(drawing.lines.size(), 20U);
  const Camera camera = far_away();
  // A line on the near side is within the disc; none of the far side is drawn: half of the length at most.
  double drawn_px = 0.0;
  for (const Drawing::Line& line : drawing.lines) {
    drawn_px += length_px(line);
    EXPECT_LE(std::hypot(line.x0 - 200.0F, line.y0 - 150.0F), 64.5F);
  }
  Snapshot without = empty_earth();
  without.globe = {};
  draw_scene(without, camera, grid_alone(), drawing);
  double all_px = 0.0;
  for (const Drawing::Line& line : drawing.lines) all_px += length_px(line);
  EXPECT_GT(drawn_px, 0.4 * all_px);
  EXPECT_LT(drawn_px, 0.65 * all_px);
}

TEST(Globe, IsAPlaneFromNear) {
  Camera camera = Camera::start(400.0, 300.0);
  camera.pixels_per_m = 0.1;
  EXPECT_FALSE(shows_curvature(camera));
  Drawing drawing;
  draw_scene(empty_earth(), camera, grid_alone(), drawing);
  EXPECT_TRUE(drawing.solids.empty());
  EXPECT_GT(drawing.lines.size(), 10U);
  camera.pixels_per_m = 1e-4;
  EXPECT_TRUE(shows_curvature(camera));
  // Far from the anchor the plane is far from the ground, however near one looks.
  camera.pixels_per_m = 0.1;
  camera.focus_world_m = {3e5, 0.0, 0.0};
  EXPECT_TRUE(shows_curvature(camera));
}

TEST(Globe, SaysDegreesWithTheirSides) {
  DrawingOptions options = grid_alone();
  options.labels = true;
  Camera camera = far_away();
  camera.focus_world_m = {};
  camera.pixels_per_m = 1e-4;
  Drawing drawing;
  draw_scene(empty_earth(), camera, options, drawing);
  std::set<std::string> words;
  for (const Drawing::Text& text : drawing.texts) words.insert(text.text);
  EXPECT_TRUE(words.contains("30° N"));
  EXPECT_TRUE(words.contains("80° W"));
}

}  // namespace globe_test
}  // namespace sarsim::picture
