#include "scene/check/check_names.hpp"

#include "scene/check/check_test_scene.hpp"

namespace sarsim::scene {
namespace check_names_test {

using testing::HasSubstr;

TEST(CheckNames, AcceptNamesInAnyCase) {
  Scene scene = sound_scene();
  scene.targets[0].platform = "EARTH";
  scene.radars[0].platform = "plane";
  scene.simulations[0].radar = "rAdAr1";
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckNames, SuggestTheNearestNameForAnUnknownPlatform) {
  Scene scene = sound_scene();
  scene.targets[0].platform = "Plnae";
  const core::Problem problem = expect_error(scene, {"target", 0, "platform"});
  EXPECT_EQ(problem.found, "Plnae");
  EXPECT_EQ(problem.hint, "Did you mean Plane?");
}

TEST(CheckNames, SuggestNothingWhereNothingIsNear) {
  Scene scene = sound_scene();
  scene.surfaces[0].platform = "Submarine";
  EXPECT_EQ(expect_error(scene, {"surface", 0, "platform"}).hint, "");
}

TEST(CheckNames, SuggestEarthAlthoughItIsNotDefined) {
  Scene scene = sound_scene();
  scene.platforms.erase(scene.platforms.begin());
  scene.surfaces.clear();
  scene.targets[0].platform = "Erath";
  EXPECT_EQ(expect_error(scene, {"target", 0, "platform"}).hint, "Did you mean Earth?");
}

TEST(CheckNames, SayThatThereIsNoRadarAtAll) {
  Scene scene = sound_scene();
  scene.radars.clear();
  scene.geometries.clear();
  EXPECT_EQ(expect_error(scene, {"simulation", 0, "radar"}).hint, "The scene defines no radar.");
}

TEST(CheckNames, RefuseAnUnknownRadarOfAGeometryTable) {
  Scene scene = sound_scene();
  scene.geometries[0].radar = "Radio1";
  EXPECT_EQ(expect_error(scene, {"geometry", 0, "radar"}).hint, "Did you mean Radar1?");
}

TEST(CheckNames, RefuseAnEmptyReference) {
  Scene scene = sound_scene();
  scene.targets[0].platform = "";
  expect_error(scene, {"target", 0, "platform"});
}

TEST(CheckNames, AcceptAnEarthThatIsNotDefined) {
  Scene scene = sound_scene();
  scene.platforms.erase(scene.platforms.begin());
  scene.targets.resize(3);
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckNames, WarnOfANameThatIsOnlyAPrefix) {
  Scene scene = sound_scene();
  scene.targets[0].platform = "Pla";
  const core::Problem problem = expect_warning(scene, {"target", 0, "platform"});
  EXPECT_EQ(problem.found, "Pla");
  EXPECT_EQ(problem.expected, "Plane");
}

TEST(CheckNames, WarnOfANameThatADefinedNameBegins) {
  Scene scene = sound_scene();
  scene.geometries[0].radar = "Radar1b";
  EXPECT_EQ(expect_warning(scene, {"geometry", 0, "radar"}).expected, "Radar1");
}

TEST(CheckNames, RefuseAPrefixOfSeveralNames) {
  Scene scene = sound_scene();
  scene.platforms.push_back(scene.platforms[1]);
  scene.platforms.back().name = "Planet";
  scene.targets[0].platform = "Plan";
  EXPECT_EQ(expect_error(scene, {"target", 0, "platform"}).expected, "one of Plane, Planet");
}

TEST(CheckNames, PreferTheExactNameToALongerOne) {
  Scene scene = sound_scene();
  scene.platforms.push_back(scene.platforms[1]);
  scene.platforms.back().name = "Planet";
  EXPECT_TRUE(check(scene).empty());
}

TEST(CheckNames, ListTheFirstOfManyNames) {
  Scene scene = sound_scene();
  for (int i = 0; i < 12; ++i) {
    scene.platforms.push_back(scene.platforms[1]);
    scene.platforms.back().name = "Ship" + std::to_string(i);
  }
  scene.targets[0].platform = "Shi";
  // The first nine by the alphabet decide; they are listed as they are defined.
  EXPECT_EQ(expect_error(scene, {"target", 0, "platform"}).expected,
            "one of Ship0, Ship1, Ship2, Ship3, Ship4, Ship5, Ship6, Ship10, ...");
}

TEST(CheckNames, WarnOfRepeatedDefinitions) {
  Scene platforms = sound_scene();
  platforms.platforms.push_back(platforms.platforms[0]);
  platforms.platforms.back().name = "EARTH";
  EXPECT_EQ(expect_warning(platforms, {"platform", 2, "name"}).found, "EARTH");

  Scene radars = sound_scene();
  radars.radars.push_back(radars.radars[0]);
  expect_warning(radars, {"radar", 1, "name"});
}

TEST(CheckNames, RefuseDefinitionsWithoutAName) {
  Scene scene = sound_scene();
  scene.platforms.emplace_back();
  scene.platforms.back().name = "";
  expect_error(scene, {"platform", 2, "name"});
}

}  // namespace check_names_test
}  // namespace sarsim::scene
