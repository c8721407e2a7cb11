#include "scene/edit/scene_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/edit/edit_runs.hpp"
#include "scene/edit/edit_test_support.hpp"
#include "support/processor_time.hpp"

namespace sarsim::scene {

namespace scene_change_test {

Scene three_targets() {
  Scene scene;
  scene.platforms.resize(2);
  scene.platforms[1].name = "Ship";
  scene.targets.resize(3);
  return scene;
}

ObjectId target_id(std::size_t index) { return {ObjectKind::target, index}; }

std::vector<ObjectId> all_ids(const Scene& scene) {
  std::vector<ObjectId> ids;
  for (const ObjectKind kind : all_object_kinds)
    for (std::size_t i = 0; i < count_of(scene, kind); ++i) ids.push_back({kind, i});
  return ids;
}

// The change by its definition: each object of either scene is looked at.
void expect_true(const SceneChange& change, const Edit& edit, bool forwards, const Scene& before, const Scene& after) {
  std::vector<ObjectId> removed;
  std::vector<ObjectId> there;
  for (const ObjectId id : all_ids(before)) {
    const auto now = moved(id, edit, forwards);
    EXPECT_EQ(change.moved(id), now);
    if (!now) {
      removed.push_back(id);
      continue;
    }
    there.push_back(*now);
    AnyObject was = object_of(before, id);
    AnyObject is = object_of(after, *now);
    const auto told = std::ranges::find(change.changed, *now, &ChangedObject::id);
    if (!(was == is)) {
      EXPECT_NE(told, change.changed.end());
    }
    if (told == change.changed.end()) continue;
    if (name_in(was) != nullptr && *name_in(was) != *name_in(is)) {
      EXPECT_TRUE(told->name);
    }
    if (carrier_in(was) != nullptr && *carrier_in(was) != *carrier_in(is)) {
      EXPECT_TRUE(told->carrier);
    }
  }
  std::vector<ObjectId> inserted = all_ids(after);
  std::erase_if(inserted, [&](ObjectId id) { return std::ranges::find(there, id) != there.end(); });
  EXPECT_EQ(change.removed, removed);
  EXPECT_EQ(change.inserted, inserted);
  for (const ChangedObject& object : change.changed) EXPECT_NE(std::ranges::find(there, object.id), there.end());
}

TEST(SceneChange, TellsTheObjectThatMoved) {
  const Scene scene = three_targets();
  Target target;
  target.position_m.x = 5.0;
  const SceneChange change = change_of(replace_object(scene, target_id(1), target, "Move target"));
  SceneChange expected;
  expected.changed = {{target_id(1)}};
  EXPECT_EQ(change, expected);
  EXPECT_TRUE(change.same_objects());
  EXPECT_FALSE(change.concerns_names());
  EXPECT_TRUE(change.concerns(ObjectKind::target));
  EXPECT_FALSE(change.concerns(ObjectKind::platform));
  EXPECT_TRUE(change.concerns(target_id(1)));
  EXPECT_FALSE(change.concerns(target_id(2)));
}

TEST(SceneChange, TellsWhichNamesChanged) {
  Scene scene = three_targets();
  scene.targets[2].platform = "Ship";
  const SceneChange renamed = change_of(rename_object(scene, {ObjectKind::platform, 1}, "Boat"));
  const std::vector<ChangedObject> expected{{{ObjectKind::platform, 1}, true, false}, {target_id(2), false, true}};
  EXPECT_EQ(renamed.changed, expected);
  EXPECT_TRUE(renamed.concerns_names());
  EXPECT_TRUE(change_of(carry_objects(scene, {target_id(0)}, "Ship")).changed.at(0).carrier);
}

TEST(SceneChange, NumbersTheRemovedAsBeforeAndTheInsertedAsNow) {
  const Scene scene = three_targets();
  const Edit edit = remove_objects(scene, {target_id(0), target_id(2)});
  const SceneChange forwards = change_of(edit);
  EXPECT_EQ(forwards.removed, (std::vector{target_id(0), target_id(2)}));
  EXPECT_TRUE(forwards.inserted.empty());
  EXPECT_FALSE(forwards.same_objects());
  const SceneChange backwards = change_of(edit, false);
  EXPECT_EQ(backwards.inserted, (std::vector{target_id(0), target_id(2)}));
  EXPECT_TRUE(backwards.removed.empty());
}

TEST(SceneChange, OfManyReplacementsIsOnePassBothWays) {
  constexpr std::size_t count = 100'000;
  Edit edit;
  Target after;
  after.rcs_m2 = 3.0;
  for (std::size_t i = 0; i < count; ++i) edit.changes.push_back({target_id(i), Target(), after});
  for (const bool forwards : {true, false}) EXPECT_EQ(run_length(list_changes(edit, forwards)), count) << forwards;
  const sarsim::test::ProcessorTime time;
  const SceneChange undone = change_of(edit, false);
  EXPECT_EQ(undone, change_of(edit));
  EXPECT_EQ(undone.changed.size(), count);
  EXPECT_LT(time.seconds(), 2.0);  // 20 ms; one after the other they took 12 s
}

TEST(SceneChange, OfWhatIsReplacedTwiceOnTheWayBackIsToldOnce) {
  Scene scene = three_targets();
  Edit edit;
  const auto replace = [&](std::size_t index, double x_m) {
    Target target = scene.targets[index];
    target.position_m.x = x_m;
    const Edit one = replace_object(scene, target_id(index), target, "Move target");
    apply(one, scene);
    edit.changes.push_back(one.changes.front());
  };
  const Scene first = scene;
  for (const std::size_t index : {2U, 1U, 0U, 1U, 1U, 2U})
    replace(index, 10.0 * static_cast<double>(edit.changes.size()));
  const std::vector<ChangedObject> expected{{target_id(0)}, {target_id(1)}, {target_id(2)}};
  for (const bool forwards : {true, false}) EXPECT_EQ(change_of(edit, forwards).changed, expected) << forwards;
  revert(edit, scene);
  EXPECT_EQ(scene, first);
}

TEST(SceneChange, TellsOfOptions) {
  const Scene scene = three_targets();
  RunOptions options;
  options.seed = 7;
  const SceneChange change = change_of(change_options(scene, options));
  EXPECT_TRUE(change.options);
  EXPECT_TRUE(change.changed.empty());
  EXPECT_TRUE(keeps_objects(change_options(scene, options)));
  World world;
  world.frame = World::Frame::earth;
  EXPECT_FALSE(keeps_objects(change_world(scene, world)));
}

TEST(SceneChange, IsTrueOfRandomEditsAndOfRunsOfThem) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomEdits edits(seed);
    const Scene first = three_targets();
    Scene scene = first;
    Edit run;
    for (int i = 0; i < 5; ++i) {
      const Edit edit = edits.edit(scene);
      const Scene before = scene;
      apply(edit, scene);
      expect_true(change_of(edit), edit, true, before, scene);
      expect_true(change_of(edit, false), edit, false, scene, before);
      EXPECT_EQ(keeps_objects(edit), change_of(edit).same_objects());
      run = i == 0 ? edit : composed(std::move(run), edit);
    }
    expect_true(change_of(run), run, true, first, scene);
    expect_true(change_of(run, false), run, false, scene, first);
  }
}

}  // namespace scene_change_test
}  // namespace sarsim::scene
