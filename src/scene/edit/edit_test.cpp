#include "scene/edit/edit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "scene/edit/edit_test_support.hpp"

namespace sarsim::scene {

namespace edit_test {

Scene fleet() {
  Scene scene;
  for (const char* name : {"Earth", "Ship", "Plane"}) scene.platforms.emplace_back().name = name;
  for (const char* carrier : {"Ship", "sh", "Plane", "Earth", "Ship"}) {
    Target& target = scene.targets.emplace_back();
    target.platform = carrier;
    target.position_m.x = static_cast<double>(scene.targets.size());
  }
  scene.surfaces.resize(2);
  scene.surfaces[1].platform = "Ship";
  for (const char* name : {"X-band", "L-band"}) scene.radars.emplace_back().name = name;
  scene.radars[0].platform = "Ship";
  scene.radars[1].platform = "Plane";
  for (const char* radar : {"X-band", "L-band", "X"}) scene.simulations.emplace_back().radar = radar;
  scene.simulations[1].file = "sim2.bin";
  scene.simulations[2].file = "sim3.bin";
  scene.geometries.emplace_back().radar = "L-band";
  return scene;
}

// Applies an edit and checks that undoing it gives the same scene and doing it again the same result.
Scene done(const Scene& scene, const Edit& edit) {
  Scene after = scene;
  apply(edit, after);
  Scene again = after;
  revert(edit, again);
  EXPECT_TRUE(again == scene) << edit.label;
  apply(edit, again);
  EXPECT_TRUE(again == after) << edit.label;
  return after;
}

ObjectId platform(std::size_t index) { return {ObjectKind::platform, index}; }
ObjectId target(std::size_t index) { return {ObjectKind::target, index}; }
ObjectId radar(std::size_t index) { return {ObjectKind::radar, index}; }

TEST(Edit, RefusesAnotherSceneAndLeavesItAlone) {
  const Scene scene = fleet();
  Edit edit = remove_objects(scene, {target(1), platform(1)});
  Scene other = scene;
  other.platforms[1].position_m.x = 5.0;  // the last thing to be removed
  const Scene before = other;
  EXPECT_THROW(apply(edit, other), std::logic_error);
  EXPECT_TRUE(other == before);
  Scene empty;
  EXPECT_THROW(apply(edit, empty), std::logic_error);
}

TEST(Edit, RefusesAMalformedChange) {
  Scene scene = fleet();
  Edit wrong_kind;
  wrong_kind.changes.push_back({target(0), std::nullopt, AnyObject(Radar{})});
  EXPECT_THROW(apply(wrong_kind, scene), std::logic_error);
  Edit nothing;
  nothing.changes.push_back({target(0), std::nullopt, std::nullopt});
  EXPECT_THROW(apply(nothing, scene), std::logic_error);
  Edit one_sided;
  one_sided.options_after = RunOptions{};
  EXPECT_THROW(apply(one_sided, scene), std::logic_error);
  EXPECT_TRUE(scene == fleet());
}

TEST(Edit, HoldsNumbersThatAreNone) {
  Scene scene = fleet();
  Target faulty;
  faulty.rcs_m2 = std::numeric_limits<double>::quiet_NaN();
  const Edit edit = replace_object(scene, target(0), faulty, "Change target");
  apply(edit, scene);
  EXPECT_NE(scene.targets[0].rcs_m2, scene.targets[0].rcs_m2);
  revert(edit, scene);
  EXPECT_TRUE(scene == fleet());
}

TEST(Moved, FollowsInsertionsAndRemovalsBothWays) {
  const Scene scene = fleet();
  const Edit edit = remove_objects(scene, {target(1), target(3)});
  EXPECT_EQ(moved(target(0), edit), target(0));
  EXPECT_EQ(moved(target(1), edit), std::nullopt);
  EXPECT_EQ(moved(target(2), edit), target(1));
  EXPECT_EQ(moved(target(4), edit), target(2));
  EXPECT_EQ(moved(target(2), edit, false), target(4));
  EXPECT_EQ(moved(target(1), edit, false), target(2));
  EXPECT_EQ(moved(radar(1), edit), radar(1));
  EXPECT_EQ(moved(target(5), add_object(scene, Target{}), false), std::nullopt);
}

TEST(EraseObjects, LeavesWhatTheEditLeaves) {
  const Scene scene = fleet();
  const std::vector<std::vector<ObjectId>> choices{
      {target(0)}, {target(4)},   {target(3), target(1), target(3)},
      {radar(0)},  {platform(1)}, {platform(1), platform(0), target(2), radar(1)},
      {}};
  for (const std::vector<ObjectId>& ids : choices) {
    Scene expected = scene;
    apply(remove_objects(scene, ids), expected);
    Scene erased = scene;
    erase_objects(erased, ids);
    EXPECT_TRUE(erased == expected) << ids.size();
  }
}

TEST(EraseObjects, LeavesTheSceneWhereAnObjectIsMissing) {
  Scene scene = fleet();
  EXPECT_THROW(erase_objects(scene, {target(0), target(99)}), std::out_of_range);
  EXPECT_TRUE(scene == fleet());
}

// One pass over what stands on platforms, and not one for each of them.
TEST(EraseObjects, TakesManyPlatformsAtOnce) {
  Scene scene;
  std::vector<ObjectId> ids;
  for (std::size_t i = 0; i < 20'000; ++i) {
    scene.platforms.emplace_back().name = fmt::format("P{}", i);
    scene.targets.emplace_back().platform = scene.platforms.back().name;
    if (i % 2 == 0) ids.push_back(platform(i));
  }
  erase_objects(scene, ids);
  ASSERT_EQ(scene.platforms.size(), 10'000U);
  ASSERT_EQ(scene.targets.size(), 10'000U);
  EXPECT_EQ(scene.platforms[0].name, "P1");
  EXPECT_EQ(*scene.targets[9'999].platform, "P19999");
}

TEST(ReplaceObject, KeepsThePlaceInTheList) {
  const Scene scene = fleet();
  Target moved_target = scene.targets[2];
  moved_target.position_m.z = 7.0;
  Scene expected = scene;
  expected.targets[2] = moved_target;
  const Edit edit = replace_object(scene, target(2), moved_target, "Move target", "drag");
  EXPECT_TRUE(done(scene, edit) == expected);
  EXPECT_EQ(edit.label, "Move target");
  EXPECT_EQ(edit.merge_key, "drag");
}

TEST(ReplaceObject, RefusesAnotherKindAndAnUnknownId) {
  const Scene scene = fleet();
  EXPECT_THROW(static_cast<void>(replace_object(scene, target(0), Radar{}, "")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(replace_object(scene, target(5), Target{}, "")), std::out_of_range);
}

TEST(RenameObject, RepointsWhateverRefersToIt) {
  const Scene scene = fleet();
  const Scene after = done(scene, rename_object(scene, platform(1), "Ferry"));
  EXPECT_EQ(after.platforms[1].name, "Ferry");
  EXPECT_EQ(after.targets[0].platform, "Ferry");
  EXPECT_EQ(after.targets[1].platform, "Ferry");  // was found by the beginning of the name
  EXPECT_EQ(after.targets[2].platform, "Plane");
  EXPECT_EQ(after.surfaces[1].platform, "Ferry");
  EXPECT_EQ(after.radars[0].platform, "Ferry");
  const Scene radar_after = done(scene, rename_object(scene, radar(0), "C-band"));
  EXPECT_EQ(radar_after.simulations[0].radar, "C-band");
  EXPECT_EQ(radar_after.simulations[1].radar, "L-band");
  EXPECT_EQ(radar_after.simulations[2].radar, "C-band");
}

TEST(RenameObject, LeavesReferencesThatStillMeanIt) {
  const Scene scene = fleet();
  const Scene after = done(scene, rename_object(scene, platform(1), "SHIP"));
  EXPECT_EQ(after.targets[0].platform, "Ship");
  EXPECT_EQ(after.targets[1].platform, "sh");
}

TEST(RenameObject, DoesNotDrawOtherReferencesAway) {
  Scene scene = fleet();
  scene.targets[0].platform = "Pl";  // the plane
  const Scene after = done(scene, rename_object(scene, platform(1), "Pl"));
  EXPECT_EQ(after.targets[0].platform, "Plane");
  EXPECT_EQ(after.targets[4].platform, "Pl");
}

TEST(RenameObject, TakesANumberWhereTheNameIsTaken) {
  const Scene scene = fleet();
  const Scene after = done(scene, rename_object(scene, platform(1), "plane"));
  EXPECT_EQ(after.platforms[1].name, "plane2");
  EXPECT_EQ(after.targets[0].platform, "plane2");
  EXPECT_EQ(after.targets[2].platform, "Plane");
  EXPECT_THROW(static_cast<void>(rename_object(scene, target(0), "x")), std::invalid_argument);
}

TEST(NameObjection, SaysWhyANameCannotBe) {
  const Scene scene = fleet();
  EXPECT_EQ(name_objection(scene, platform(1), "Ferry boat, \"old\""), "");
  EXPECT_EQ(name_objection(scene, platform(1), "SHIP"), "");
  EXPECT_NE(name_objection(scene, platform(1), ""), "");
  EXPECT_NE(name_objection(scene, platform(1), "two\nlines"), "");
  EXPECT_EQ(name_objection(scene, platform(1), "EARTH"), "another platform has this name");
  EXPECT_EQ(name_objection(scene, radar(0), "EARTH"), "");
}

TEST(AddObject, AppendsWithAFreeName) {
  const Scene scene = fleet();
  EXPECT_EQ(done(scene, add_object(scene, Platform{})).platforms.back().name, "Platform2");
  Platform ship;
  ship.name = "ship";
  EXPECT_EQ(done(scene, add_object(scene, ship)).platforms.back().name, "ship2");
  EXPECT_EQ(done(scene, add_object(scene, Radar{})).radars.back().name, "Radar1");
  EXPECT_EQ(done(scene, add_object(scene, Simulation{})).simulations.back().file, "sim4.bin");
  EXPECT_EQ(add_object(scene, Surface{}).label, "Add surface");
}

TEST(AddObject, KeepsShortenedReferencesMeaningWhatTheyDid) {
  const Scene scene = fleet();
  Platform shoal;
  shoal.name = "Shoal";
  const Scene after = done(scene, add_object(scene, shoal));
  EXPECT_EQ(after.targets[1].platform, "Ship");
  EXPECT_EQ(after.targets[0].platform, "Ship");
}

TEST(RemoveObjects, TakesWhatStandsOnAPlatformAndWhatARadarRecords) {
  const Scene scene = fleet();
  const Edit edit = remove_objects(scene, {platform(1)});
  const Scene after = done(scene, edit);
  EXPECT_EQ(edit.label, "Delete platform");
  ASSERT_EQ(after.targets.size(), 2U);
  EXPECT_EQ(after.targets[0].platform, "Plane");
  EXPECT_EQ(after.targets[1].platform, "Earth");
  EXPECT_EQ(after.surfaces.size(), 1U);
  ASSERT_EQ(after.radars.size(), 1U);
  EXPECT_EQ(after.radars[0].name, "L-band");
  ASSERT_EQ(after.simulations.size(), 1U);
  EXPECT_EQ(after.simulations[0].radar, "L-band");
  EXPECT_EQ(after.geometries.size(), 1U);
}

TEST(RemoveObjects, TakesEachOnceAndIsOneStep) {
  const Scene scene = fleet();
  const Edit edit = remove_objects(scene, {target(0), platform(1), target(0), target(2)});
  EXPECT_EQ(done(scene, edit).targets.size(), 1U);
  EXPECT_EQ(edit.label, "Delete 3 objects");
  EXPECT_THROW(static_cast<void>(remove_objects(scene, {target(5)})), std::out_of_range);
}

TEST(DuplicateObjects, CopiesWhatStandsOnAPlatformWithIt) {
  const Scene scene = fleet();
  const Scene after = done(scene, duplicate_objects(scene, {platform(1)}));
  ASSERT_EQ(after.platforms.size(), 4U);
  EXPECT_EQ(after.platforms[3].name, "Ship2");
  ASSERT_EQ(after.targets.size(), 8U);
  for (std::size_t i = 5; i < 8; ++i) EXPECT_EQ(after.targets[i].platform, "Ship2");
  EXPECT_EQ(after.targets[6].position_m.x, 2.0);
  EXPECT_EQ(after.targets[0].platform, "Ship");
  EXPECT_EQ(after.targets[1].platform, "Ship");  // "sh" would mean either now
  ASSERT_EQ(after.radars.size(), 3U);
  EXPECT_EQ(after.radars[2].name, "X-band2");
  EXPECT_EQ(after.radars[2].platform, "Ship2");
  EXPECT_EQ(after.simulations.size(), 3U);
}

TEST(DuplicateObjects, CopiesOfThingsThatBelongTogetherBelongToEachOther) {
  const Scene scene = fleet();
  const Scene after = done(scene, duplicate_objects(scene, {{ObjectKind::simulation, 0}, radar(0), radar(0)}));
  ASSERT_EQ(after.radars.size(), 3U);
  ASSERT_EQ(after.simulations.size(), 4U);
  EXPECT_EQ(after.simulations[3].radar, after.radars[2].name);
  EXPECT_EQ(after.simulations[3].file, "sim4.bin");
  EXPECT_EQ(after.radars[2].platform, "Ship");
}

TEST(CarryObjects, ChangesThePlatformOnly) {
  const Scene scene = fleet();
  const Edit edit =
      carry_objects(scene, {target(0), target(2), radar(0), platform(0), {ObjectKind::geometry, 0}}, "Plane");
  EXPECT_EQ(edit.changes.size(), 2U);  // target 2 is there already
  Scene expected = scene;
  expected.targets[0].platform = "Plane";
  expected.radars[0].platform = "Plane";
  EXPECT_TRUE(done(scene, edit) == expected);
}

TEST(AddTargets, AppendsThemAllInOneStep) {
  const Scene scene = fleet();
  const Edit edit = add_targets(scene, std::vector<Target>(1000, scene.targets[0]));
  EXPECT_EQ(edit.label, "Add 1000 targets");
  EXPECT_EQ(done(scene, edit).targets.size(), 1005U);
}

TEST(ChangeOptions, ChangesTheOptions) {
  const Scene scene = fleet();
  RunOptions options;
  options.seed = 9;
  EXPECT_EQ(done(scene, change_options(scene, options)).options.seed, 9U);
}

TEST(Edit, IsQuickForListsOfATenThousand) {
  Scene scene;
  scene.targets.resize(200'000);
  for (std::size_t i = 0; i < scene.targets.size(); ++i) scene.targets[i].position_m.x = static_cast<double>(i);
  std::vector<ObjectId> even;
  for (std::size_t i = 0; i < scene.targets.size(); i += 2) even.push_back(target(i));
  const Scene after = done(scene, remove_objects(scene, even));
  ASSERT_EQ(after.targets.size(), 100'000U);
  EXPECT_EQ(after.targets[70'000].position_m.x, 140'001.0);
}

TEST(Difference, OfEqualScenesIsEmpty) {
  const Edit edit = difference(fleet(), fleet(), "Edit script");
  EXPECT_TRUE(edit.changes.empty());
  EXPECT_FALSE(edit.options_before || edit.options_after);
  EXPECT_TRUE(changes_nothing(edit));
}

TEST(Difference, OfOneObjectIsThatObject) {
  const Scene from = fleet();
  Scene to = from;
  to.targets[2].position_m.y = 4.0;
  to.options.seed = 3;
  const Edit edit = difference(from, to, "");
  ASSERT_EQ(edit.changes.size(), 1U);
  EXPECT_EQ(edit.changes[0].id, target(2));
  EXPECT_TRUE(done(from, edit) == to);
}

TEST(Difference, FindsAnInsertionAmongEqualObjects) {
  const Scene from = fleet();
  Scene to = from;
  to.targets.insert(to.targets.begin() + 1, Target{});
  to.targets.back().rcs_m2 = 5.0;
  const Edit edit = difference(from, to, "");
  EXPECT_EQ(edit.changes.size(), 2U);
  EXPECT_TRUE(done(from, edit) == to);
}

TEST(Difference, ComparesFunctionsFromFilesByTheirPoints) {
  Scene from = fleet();
  from.platforms[1].trajectory_m.file = "track.dat";
  from.platforms[1].trajectory_m.part[0].knots = {{0.0, 1.0}};
  Scene to = from;
  to.platforms[1].trajectory_m.part[0].knots[0].y = 2.0;
  EXPECT_EQ(difference(from, to, "").changes.size(), 1U);
}

TEST(Difference, IsExactAndNoLongerThanTheEditsThatMadeIt) {
  std::mt19937_64 engine(5);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(engine() % limit); };
  for (int round = 0; round < 300; ++round) {
    Scene from;
    from.targets.resize(below(40));
    for (Target& t : from.targets) t.rcs_m2 = static_cast<double>(below(4));
    Scene to = from;
    const std::size_t edits = below(6);
    for (std::size_t i = 0; i < edits; ++i) {
      const auto at = to.targets.begin() + static_cast<std::ptrdiff_t>(below(to.targets.size() + 1));
      Target fresh;
      fresh.rcs_m2 = static_cast<double>(below(6));
      if (at == to.targets.end() || below(3) == 0)
        to.targets.insert(at, fresh);
      else if (below(2) == 0)
        to.targets.erase(at);
      else
        *at = fresh;
    }
    const Edit edit = difference(from, to, "");
    EXPECT_LE(edit.changes.size(), edits);
    EXPECT_TRUE(done(from, edit) == to);
  }
}

TEST(Difference, IsExactBetweenRandomScenesAndForLongLists) {
  test::RandomScenes scenes(8);
  Scene from = scenes.scene();
  for (int i = 0; i < 100; ++i) {
    const Scene to = scenes.scene();
    EXPECT_TRUE(done(from, difference(from, to, "")) == to);
    from = to;
  }
  Scene longer;
  longer.targets.resize(20'000);
  for (std::size_t i = 0; i < longer.targets.size(); ++i) longer.targets[i].rcs_m2 = static_cast<double>(i);
  Scene shifted = longer;
  shifted.targets.erase(shifted.targets.begin());
  shifted.targets.emplace_back();
  EXPECT_EQ(difference(longer, shifted, "").changes.size(), 2U);
  for (Target& t : shifted.targets) t.position_m.x = 1.0;
  EXPECT_TRUE(done(longer, difference(longer, shifted, "")) == shifted);
}

TEST(ComposedEdits, DoWhatBothDoInTurn) {
  constexpr std::uint64_t seed = 77;
  test::RandomEdits edits(seed);
  test::RandomScenes scenes(seed);
  for (int round = 0; round < 200; ++round) {
    const Scene scene = scenes.scene();
    Scene after = scene;
    Edit all;
    for (int i = 0; i < 4; ++i) {
      const Edit next = edits.edit(after);
      apply(next, after);
      all = composed(std::move(all), next);
    }
    Scene at_once = scene;
    apply(all, at_once);
    ASSERT_TRUE(at_once == after) << "round " << round << " of seed " << seed;
    revert(all, at_once);
    ASSERT_TRUE(at_once == scene) << "round " << round << " of seed " << seed;
  }
}

}  // namespace edit_test
}  // namespace sarsim::scene
