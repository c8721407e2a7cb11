#include "picture/scene/scene_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::picture {
namespace scene_map_test {

scene::World earth_at(double latitude_deg, double longitude_deg) {
  scene::World world;
  world.frame = scene::World::Frame::earth;
  world.latitude = core::Angle::from_deg(latitude_deg);
  world.longitude = core::Angle::from_deg(longitude_deg);
  return world;
}

TEST(SceneMap, OfAFlatWorldIsItsPlane) {
  const SceneMap map({}, {{0.0, 0.0, 10.0}, {5.0, 0.0, 30.0}});
  EXPECT_EQ(map.ground_height_m(), 20.0);
  const auto point = map.met_by({1.0, 2.0, 120.0}, {3.0, 0.0, -4.0});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->x, 76.0, 1e-9);
  EXPECT_NEAR(point->z, 20.0, 1e-9);
  EXPECT_FALSE(map.met_by({0.0, 0.0, 120.0}, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(map.met_by({0.0, 0.0, 120.0}, {1.0, 0.0, 0.1}));
  EXPECT_FALSE(map.met_by({0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}));
  EXPECT_EQ(map.place_of({1.0, 2.0, 3.0}).y, 2.0);
  EXPECT_EQ(map.ground_words(), "the plane z = 20 m");
}

TEST(SceneMap, MeetsTheEllipsoidAtItsHeight) {
  const scene::World world = earth_at(50.0, 10.0);
  const auto earth = scene::earth_of(world);
  for (const double height_m : {-100.0, 0.0, 3000.0}) {
    const SceneMap map(world, {earth->world_of({core::rad_per_deg * 50.0, core::rad_per_deg * 10.0, height_m})});
    for (const core::Vec3& direction : {core::Vec3{0.0, 0.0, -1.0}, {1.0, 0.5, -1.0}, {0.0, 2.0, -1.0}}) {
      const auto point = map.met_by({1e4, -2e4, 7e5}, direction);
      ASSERT_TRUE(point);
      EXPECT_NEAR(map.place_of(*point).height_m, height_m, 1e-3);
      EXPECT_NEAR(core::norm(core::cross(*point - core::Vec3{1e4, -2e4, 7e5}, direction)), 0.0, 1e-3);
      EXPECT_LT(core::norm(*point - core::Vec3{1e4, -2e4, 7e5}), 3e6);  // this side of the Earth
    }
    EXPECT_FALSE(map.met_by({1e4, -2e4, 7e5}, {1.0, 0.0, -0.1}));
    EXPECT_FALSE(map.met_by({1e4, -2e4, 7e5}, {0.0, 0.0, 1.0}));
    EXPECT_FALSE(map.met_by({0.0, 0.0, -5e3}, {0.0, 0.0, -1.0}));
  }
}

TEST(SceneMap, LongitudesGoOnBeyondTheDateLine) {
  const scene::World world = earth_at(0.0, 179.9);
  const SceneMap map(world, {});
  const double metres_per_deg = 6378137.0 * core::rad_per_deg;
  EXPECT_NEAR(map.place_of({0.5 * metres_per_deg, 0.0, 0.0}).x, 180.4, 1e-4);
  EXPECT_NEAR(map.place_of({-0.5 * metres_per_deg, 0.0, 0.0}).x, 179.4, 1e-4);
}

TEST(SceneMap, NamesAxesAndTimes) {
  scene::World world = earth_at(60.0, 10.0);
  world.epoch = "2020-07-28T22:59:42.5Z";
  FigurePanel panel;
  const SceneMap map(world, {});
  map.name_axes(panel);
  EXPECT_EQ(panel.x.label, "Longitude");
  EXPECT_NEAR(panel.y_per_x, 0.5, 0.003);  // cos 60 deg, and the flattening
  EXPECT_EQ(map.time_axis(-1.0, 1.0).label, "UTC on 2020-07-28");
  EXPECT_EQ(map.time_axis(-1.0, 1.0).clock_s, 22 * 3600 + 59 * 60 + 42.5);
  EXPECT_EQ(map.time_words(-1.0), "22:59:41.5Z");
  const SceneMap flat({}, {});
  flat.name_axes(panel);
  EXPECT_EQ(panel.y_per_x, 1.0);
  EXPECT_FALSE(flat.time_axis(-1.0, 1.0).clock_s);
  EXPECT_EQ(flat.time_words(-1.0), "-1 s");
}

}  // namespace scene_map_test
}  // namespace sarsim::picture
