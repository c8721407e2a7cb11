#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "scene/edit/edit.hpp"

namespace sarsim::scene {

/// What was done to a scene, step by step, without limit. Copies share their steps, which never change.
class History {
 public:
  /// Applies an edit and remembers it; what was undone before is forgotten. Merges with the last step where the keys
  /// agree. An edit that changes nothing is not remembered.
  /// @return the edit, which a step without others shares
  std::shared_ptr<const Edit> perform(Edit edit, Scene& scene);
  /// The next edit starts a step of its own, whatever its key.
  void end_run();

  [[nodiscard]] bool can_undo() const { return done_ > 0; }
  [[nodiscard]] bool can_redo() const { return done_ < edits_.size(); }
  /// The steps that undo and redo would take; null where there is none.
  [[nodiscard]] const Edit* next_undo() const { return can_undo() ? edits_[done_ - 1].get() : nullptr; }
  [[nodiscard]] const Edit* next_redo() const { return can_redo() ? edits_[done_].get() : nullptr; }
  /// Labels of the steps that undo and redo would take; empty where there is none.
  [[nodiscard]] std::string undo_label() const;
  /// The label of the step that redo would make.
  [[nodiscard]] std::string redo_label() const;
  /// Take one step; returns the edit. std::logic_error where there is none.
  std::shared_ptr<const Edit> undo(Scene& scene);
  /// The same forwards.
  std::shared_ptr<const Edit> redo(Scene& scene);

  /// What was undone cannot be made again.
  void forget_undone();

  /// Remembers the present state as the one on disk.
  void mark_saved();
  /// True where the state is not the one that was saved (at first: the beginning).
  [[nodiscard]] bool changed() const;

 private:
  std::vector<std::shared_ptr<const Edit>> edits_;
  std::size_t done_ = 0;
  std::size_t saved_ = 0;
  bool saved_reachable_ = true;
  bool run_open_ = false;
};

}  // namespace sarsim::scene
