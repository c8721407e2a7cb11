// The generator and the comparison themselves: that they draw what there is and find what is wrong.

#include <gtest/gtest.h>

#include <algorithm>

#include "random_scenes/comparison.hpp"
#include "random_scenes/engine_errors.hpp"
#include "random_scenes/field_cover.hpp"
#include "random_scenes/scene_maker.hpp"
#include "random_scenes/shrink.hpp"
#include "scene/check/check.hpp"
#include "scene/script/writer.hpp"
#include "simulate/survey/survey.hpp"

namespace sarsim::test {
namespace random_scenes_test {

TEST(RandomScenes, SameSeedSameScene) {
  EXPECT_EQ(random_scene(7), random_scene(7));
  EXPECT_NE(random_scene(7), random_scene(8));
}

TEST(RandomScenes, UseEveryFieldKeywordAndKindOfFunctionOfTheLanguage) {
  FieldCover cover;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) cover.note(random_scene(seed));
  EXPECT_GT(cover.fields(), 70U);
  EXPECT_GE(cover.keywords(), 55U);
  for (const std::string& name : cover.missing()) ADD_FAILURE() << name << " is never used";
}

TEST(RandomScenes, FieldsThatNoSceneUsesAreMissed) {
  FieldCover cover;
  const std::size_t all = cover.missing().size();
  cover.note(random_scene(1));
  EXPECT_LT(cover.missing().size(), all);
  EXPECT_GT(cover.missing().size(), 20U);
}

TEST(RandomScenes, AreSeldomRefused) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const scene::Scene scene = random_scene(seed);
    refused += core::has_errors(scene::check(scene)) || core::has_errors(simulate::survey(scene)) ? 1 : 0;
  }
  EXPECT_LT(refused, 30);
}

TEST(RandomScenes, EnginesThatAreLessExactThanPromisedAreFound) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    scene::Scene scene = random_scene(seed);
    scene.options.tolerance = 1e-3;
    if (core::has_errors(scene::check(scene)) || core::has_errors(simulate::survey(scene))) continue;
    const simulate::Plan fast = simulate::make_plan(scene, 0, nullptr, simulate::Engine::spectral);
    const simulate::Plan reference = simulate::make_plan(scene, 0, nullptr, simulate::Engine::reference);
    EXPECT_LE(compare_rows(fast, reference, 1e-3).worst_share, 1.0) << seed;
    found += compare_rows(fast, reference, 1e-9).worst_share > 1.0 ? 1 : 0;
  }
  EXPECT_GT(found, 5);
}

TEST(RandomScenes, AFailureIsShownByAPlainerScene) {
  scene::Scene scene;
  for (std::uint64_t seed = 1; scene.targets.size() < 5 || scene.surfaces.empty(); ++seed) scene = random_scene(seed);
  scene.targets[3].rcs_m2 = 17.0;
  const scene::Scene plain = shrunk(scene, [](const scene::Scene& s) {
    return std::ranges::any_of(s.targets, [](const scene::Target& target) { return target.rcs_m2 == 17.0; });
  });
  EXPECT_EQ(plain.targets.size(), 1U);
  EXPECT_TRUE(plain.surfaces.empty());
  EXPECT_TRUE(plain.radars.empty());
}

}  // namespace random_scenes_test
}  // namespace sarsim::test
