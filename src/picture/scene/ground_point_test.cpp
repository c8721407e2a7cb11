#include "picture/scene/ground_point.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::picture {
namespace ground_point_test {

Camera camera_at(double azimuth_deg, double elevation_deg, bool perspective) {
  Camera camera = Camera::start(800.0, 600.0);
  camera.azimuth_rad = azimuth_deg * core::rad_per_deg;
  camera.elevation_rad = elevation_deg * core::rad_per_deg;
  camera.pixels_per_m = 0.5;
  camera.perspective = perspective;
  camera.focus_world_m = {100.0, 200.0, 50.0};
  return camera;
}

TEST(GroundPoint, IsWhereThePlaneIsSeen) {
  for (const bool perspective : {false, true}) {
    const Camera camera = camera_at(60.0, 30.0, perspective);
    const core::Vec3 place{320.0, -80.0, 0.0};
    const auto at = camera.project(place);
    ASSERT_TRUE(at);
    const auto found = ground_under(camera, at->x, at->y, std::nullopt);
    ASSERT_TRUE(found);
    EXPECT_LT(core::norm(*found - place), 1e-9);
  }
}

TEST(GroundPoint, IsNowhereAboveTheHorizon) {
  EXPECT_FALSE(ground_under(camera_at(0.0, 0.0, false), 400.0, 300.0, std::nullopt));
  EXPECT_FALSE(ground_under(camera_at(0.0, 2.0, true), 400.0, 0.0, std::nullopt));
  EXPECT_TRUE(ground_under(camera_at(0.0, 2.0, true), 400.0, 600.0, std::nullopt));
}

TEST(GroundPoint, IsTheNearSideOfTheEllipsoid) {
  const radar::EarthFrame earth({{0.9, 0.2, 0.0}, 0.3});
  for (const bool perspective : {false, true}) {
    const Camera camera = camera_at(200.0, 50.0, perspective);
    const core::Vec3 place = earth.world_of({0.90003, 0.20002, 0.0});
    const auto at = camera.project(place);
    ASSERT_TRUE(at);
    const auto found = ground_under(camera, at->x, at->y, earth);
    ASSERT_TRUE(found);
    EXPECT_LT(core::norm(*found - place), 1e-6);
    EXPECT_NEAR(earth.geodetic_of(*found).height_m, 0.0, 1e-6);
  }
  Camera beside = camera_at(0.0, 0.0, false);
  beside.focus_world_m.z = 100.0;
  EXPECT_FALSE(ground_under(beside, 400.0, 200.0, earth));
}

TEST(GroundPoint, OfALevelPlaneIsAtItsHeight) {
  const core::Vec3 place{10.0, 20.0, 300.0};
  const Camera camera = camera_at(60.0, 30.0, true);
  const auto at = camera.project(place);
  ASSERT_TRUE(at);
  const auto found = level_under(camera, at->x, at->y, {500.0, 500.0, 300.0});
  ASSERT_TRUE(found);
  EXPECT_LT(core::norm(*found - place), 1e-9);
  EXPECT_FALSE(level_under(camera_at(60.0, 4.0, false), 400.0, 300.0, place));
}

}  // namespace ground_point_test
}  // namespace sarsim::picture
