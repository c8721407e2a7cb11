#include "scene/language/exact_names.hpp"

#include <gtest/gtest.h>

namespace sarsim::scene {

TEST(ExactNames, AreThoseOfWhatIsMeant) {
  Scene scene;
  scene.platforms.resize(2);
  scene.platforms[0].name = "Plane";
  scene.platforms[1].name = "Planet";
  scene.radars.resize(2);
  scene.radars[0].name = "Search";
  scene.radars[0].platform = "PLANE";
  scene.radars[1].name = "Map";
  scene.radars[1].platform = "planet";
  scene.targets.resize(4);
  scene.targets[0].platform = "plane";
  scene.targets[1].platform = "EARTH";
  scene.targets[2].platform = "Plan";  // of both
  scene.targets[3].platform = "Ship";
  scene.simulations.resize(1);
  scene.simulations[0].radar = "sea";
  const Scene exact = with_exact_names(scene);
  EXPECT_EQ(exact.radars[0].platform, "Plane");
  EXPECT_EQ(exact.radars[1].platform, "Planet");
  EXPECT_EQ(exact.targets[0].platform, "Plane");
  EXPECT_EQ(exact.targets[1].platform, "Earth");
  EXPECT_EQ(exact.targets[2].platform, "Plan");
  EXPECT_EQ(exact.targets[3].platform, "Ship");
  scene.targets[1].platform = "PLANE";
  const Scene alike = with_exact_names(scene);
  EXPECT_EQ(&*alike.targets[0].platform, &*alike.targets[1].platform);  // one name in memory
  EXPECT_EQ(exact.simulations[0].radar, "Search");
}

}  // namespace sarsim::scene
