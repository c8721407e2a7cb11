#include "scene/model/scene_index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sarsim::scene {
namespace scene_index_test {

// The table exists only for speed and for better messages: it must mean what find_platform means.
TEST(NameTable, AgreesWithFindPlatform) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> letter('a', 'c');
  std::uniform_int_distribution<int> length(0, 4);
  std::uniform_int_distribution<int> upper(0, 1);
  const auto word = [&] {
    std::string text(static_cast<std::size_t>(length(random)), ' ');
    for (char& c : text) c = static_cast<char>(letter(random) - (upper(random) == 1 ? 'a' - 'A' : 0));
    return text;
  };
  int found = 0;
  for (int round = 0; round < 2000; ++round) {
    Scene scene;
    for (int i = 0; i < 4; ++i) scene.platforms.emplace_back().name = word();
    std::vector<std::string_view> names;
    for (const Platform& platform : scene.platforms) names.emplace_back(platform.name);
    const std::string name = word();
    const std::size_t expected = find_platform(scene, name);
    EXPECT_EQ(NameTable(names).find(name).index, expected) << name;
    EXPECT_EQ(SceneIndex(scene).platform(name), expected) << name;
    found += expected == not_found ? 0 : 1;
  }
  EXPECT_GT(found, 500);
}

Scene named_scene() {
  Scene scene;
  for (const char* name : {"Earth2", "Plane", "Planet", "Ship"}) scene.platforms.emplace_back().name = name;
  for (const char* name : {"Earth1", "Radar"}) scene.radars.emplace_back().name = name;
  return scene;
}

TEST(SceneIndex, MeansTheWorldByEarthAmongPlatformsOnly) {
  const Scene scene = named_scene();
  SceneIndex index(scene);
  EXPECT_EQ(index.platform("earth"), not_found);
  EXPECT_EQ(index.platform("Earth2"), 0U);
  EXPECT_EQ(index.platform("Eart"), 0U);
  EXPECT_EQ(index.radar("Earth"), 0U);
}

TEST(SceneIndex, SaysTheSameHoweverOftenAndInWhateverOrderItIsAsked) {
  const Scene scene = named_scene();
  SceneIndex index(scene);
  std::mt19937 random(3);
  const std::vector<std::string> asked{"Ship",    "SHIP",  "sh", "Ships", "Pl", "Plane",
                                       "planets", "Earth", "",   "Radar", "x"};
  for (int i = 0; i < 500; ++i) {
    const std::string& name = asked[random() % asked.size()];
    EXPECT_EQ(index.platform(name), find_platform(scene, name)) << name;
    EXPECT_EQ(index.radar(name), find_radar(scene, name)) << name;
  }
}

}  // namespace scene_index_test
}  // namespace sarsim::scene
