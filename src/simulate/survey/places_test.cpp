#include "simulate/survey/places.hpp"
#include "scene/model/scene.hpp"

#include <gtest/gtest.h>

namespace sarsim::simulate {
namespace places_test {

// Two targets 8 m apart on a platform that leaves (300, 0, 0) m at 50 m/s, and one on the world.
scene::Scene moving_scene() {
  scene::Platform moving;
  moving.name = "Moving";
  moving.path = scene::Platform::Path::trajectory;
  moving.trajectory_m.part[0].knots = {{0.0, 300.0}, {1.0, 350.0}};
  moving.trajectory_m.part[1].knots = {{0.0, 0.0}};
  moving.trajectory_m.part[2].knots = {{0.0, 0.0}};
  scene::Scene scene;
  scene.platforms = {scene::Platform{}, moving};
  for (const double x_m : {0.0, 8.0}) {
    scene::Target target;
    target.platform = "Moving";
    target.position_m = {x_m, 1.0, 2.0};
    scene.targets.push_back(target);
  }
  scene.targets.emplace_back().position_m = {5.0, 6.0, 7.0};
  return scene;
}

TEST(Places, ArePlacesOfTheTime) {
  const ResolvedScene scene = resolve(moving_scene());
  const auto platforms = platform_places_m(scene, 2.0, 2);
  ASSERT_EQ(platforms.size(), 2U);
  EXPECT_EQ(platforms[1], (core::Vec3{400.0, 0.0, 0.0}));
  const auto targets = target_places_m(scene, 2.0, 10);
  ASSERT_EQ(targets.size(), 3U);
  EXPECT_EQ(targets[0], (core::Vec3{400.0, 1.0, 2.0}));
  EXPECT_EQ(targets[1], (core::Vec3{408.0, 1.0, 2.0}));
  EXPECT_EQ(targets[2], (core::Vec3{5.0, 6.0, 7.0}));
}

TEST(Places, AreNoMoreThanAskedFor) {
  const ResolvedScene scene = resolve(moving_scene());
  EXPECT_EQ(platform_places_m(scene, 0.0, 1).size(), 1U);
  EXPECT_EQ(target_places_m(scene, 0.0, 2).size(), 2U);
  EXPECT_TRUE(target_places_m(scene, 0.0, 0).empty());
}

}  // namespace places_test
}  // namespace sarsim::simulate
