#include "scene/edit/history.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/edit/edit_test_support.hpp"

namespace sarsim::scene {

namespace history_test {

Scene two_targets() {
  Scene scene;
  scene.targets.resize(2);
  return scene;
}

Edit move_to(const Scene& scene, double x, std::string key = "", std::size_t index = 0) {
  Target target = scene.targets[index];
  target.position_m.x = x;
  return replace_object(scene, {ObjectKind::target, index}, target, "Move target", std::move(key));
}

TEST(History, UndoesAndRedoesStepByStep) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  history.perform(add_object(scene, Radar{}), scene);
  EXPECT_EQ(history.undo_label(), "Add radar");
  EXPECT_EQ(history.undo(scene)->label, "Add radar");
  EXPECT_TRUE(scene.radars.empty());
  EXPECT_EQ(history.redo_label(), "Add radar");
  EXPECT_EQ(history.undo_label(), "Move target");
  history.undo(scene);
  EXPECT_TRUE(scene == two_targets());
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.undo_label(), "");
  history.redo(scene);
  history.redo(scene);
  EXPECT_EQ(scene.targets[0].position_m.x, 1.0);
  EXPECT_EQ(scene.radars.size(), 1U);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, ForgetsWhatWasUndone) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  history.mark_saved();
  history.perform(add_object(scene, Radar{}), scene);
  history.undo(scene);
  history.forget_undone();
  EXPECT_FALSE(history.can_redo());
  EXPECT_FALSE(history.changed());
  history.undo(scene);
  history.forget_undone();
  EXPECT_TRUE(history.changed());  // What is on disk is out of reach.
  EXPECT_FALSE(history.can_undo());
}

TEST(History, RefusesStepsThatAreNotThere) {
  Scene scene;
  History history;
  EXPECT_THROW(history.undo(scene), std::logic_error);
  EXPECT_THROW(history.redo(scene), std::logic_error);
}

TEST(History, MergesARunOfEditsWithOneKey) {
  Scene scene = two_targets();
  History history;
  for (int i = 1; i <= 100; ++i) history.perform(move_to(scene, i, "drag"), scene);
  EXPECT_EQ(history.undo(scene)->changes.size(), 1U);
  EXPECT_TRUE(scene == two_targets());
  EXPECT_FALSE(history.can_undo());
  history.redo(scene);
  EXPECT_EQ(scene.targets[0].position_m.x, 100.0);
}

TEST(History, MergesADragThatGainsAnObject) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0, "drag"), scene);
  history.perform(move_to(scene, 2.0, "drag", 1), scene);
  history.perform(move_to(scene, 3.0, "drag"), scene);
  EXPECT_EQ(history.undo(scene)->changes.size(), 2U);
  EXPECT_TRUE(scene == two_targets());
}

TEST(History, BeginsAStepWhereTheKeyOrTheRunEnds) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0, "a"), scene);
  history.perform(move_to(scene, 2.0, "b"), scene);
  history.end_run();
  history.perform(move_to(scene, 3.0, "b"), scene);
  history.perform(move_to(scene, 4.0), scene);
  history.perform(move_to(scene, 5.0), scene);
  for (const double x : {4.0, 3.0, 2.0, 1.0, 0.0}) {
    history.undo(scene);
    EXPECT_EQ(scene.targets[0].position_m.x, x);
  }
  EXPECT_FALSE(history.can_undo());
}

TEST(History, DoesNotMergeAcrossAnUndoOrASave) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0, "a"), scene);
  history.perform(move_to(scene, 2.0), scene);
  history.undo(scene);
  history.perform(move_to(scene, 3.0, "a"), scene);
  history.mark_saved();
  history.perform(move_to(scene, 4.0, "a"), scene);
  EXPECT_TRUE(history.changed());
  history.undo(scene);
  EXPECT_EQ(scene.targets[0].position_m.x, 3.0);
  EXPECT_FALSE(history.changed());
  history.undo(scene);
  EXPECT_EQ(scene.targets[0].position_m.x, 1.0);
}

TEST(History, ForgetsADragThatCameBack) {
  Scene scene = two_targets();
  History history;
  history.mark_saved();
  history.perform(move_to(scene, 1.0, "drag"), scene);
  history.perform(move_to(scene, 0.0, "drag"), scene);
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.changed());
}

TEST(History, DoesNotRememberWhatChangesNothing) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  history.undo(scene);
  history.perform(move_to(scene, 0.0), scene);
  history.perform(change_options(scene, scene.options), scene);
  EXPECT_FALSE(history.can_undo());
  EXPECT_TRUE(history.can_redo());
}

TEST(History, ForgetsWhatWasUndoneOnceSomethingElseIsDone) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  history.undo(scene);
  history.perform(move_to(scene, 2.0), scene);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, KnowsTheSavedStateAcrossUndoAndRedo) {
  Scene scene = two_targets();
  History history;
  EXPECT_FALSE(history.changed());
  history.perform(move_to(scene, 1.0), scene);
  EXPECT_TRUE(history.changed());
  history.mark_saved();
  EXPECT_FALSE(history.changed());
  history.undo(scene);
  EXPECT_TRUE(history.changed());
  history.redo(scene);
  EXPECT_FALSE(history.changed());
}

TEST(History, LosesTheSavedStateOnAnotherBranch) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  history.mark_saved();
  history.undo(scene);
  history.perform(move_to(scene, 2.0), scene);
  EXPECT_TRUE(history.changed());
  history.undo(scene);
  EXPECT_TRUE(history.changed());
  history.mark_saved();
  EXPECT_FALSE(history.changed());
}

TEST(History, LeavesSceneAndStepsAloneWhereAnEditDoesNotFit) {
  Scene scene = two_targets();
  History history;
  history.perform(move_to(scene, 1.0), scene);
  const Edit stale = move_to(two_targets(), 2.0);
  EXPECT_THROW(history.perform(stale, scene), std::logic_error);
  EXPECT_EQ(scene.targets[0].position_m.x, 1.0);
  history.undo(scene);
  EXPECT_FALSE(history.can_undo());
}

TEST(History, TakesAThousandRandomEditsBackAndForth) {
  constexpr std::uint64_t seed = 31;
  test::RandomEdits edits(seed);
  Scene scene;
  std::vector<Scene> states{scene};
  History history;
  while (states.size() <= 1000) {
    // Scenes that grow without end make a slow test and no better one.
    const bool large = scene.platforms.size() + scene.radars.size() > 40;
    Edit edit = large ? remove_objects(scene, {{ObjectKind::radar, 0}, {ObjectKind::platform, 0}}) : edits.edit(scene);
    if (changes_nothing(edit)) continue;
    history.perform(std::move(edit), scene);
    states.push_back(scene);
  }
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    history.undo(scene);
    ASSERT_TRUE(scene == states[i - 1]) << "undo " << i << " of seed " << seed;
  }
  EXPECT_FALSE(history.can_undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    history.redo(scene);
    ASSERT_TRUE(scene == states[i]) << "redo " << i << " of seed " << seed;
  }
  EXPECT_FALSE(history.can_redo());
}

}  // namespace history_test
}  // namespace sarsim::scene
