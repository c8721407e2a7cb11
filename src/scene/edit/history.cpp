#include "scene/edit/history.hpp"

#include <stdexcept>
#include <utility>

namespace sarsim::scene {

void History::perform(Edit edit, Scene& scene) {
  if (changes_nothing(edit)) return;
  apply(edit, scene);
  const bool merges =
      run_open_ && done_ > 0 && !edit.merge_key.empty() && edits_[done_ - 1].merge_key == edit.merge_key;
  if (saved_ > done_) saved_reachable_ = false;
  edits_.resize(done_);
  run_open_ = !edit.merge_key.empty();
  if (!merges) {
    edits_.push_back(std::move(edit));
    ++done_;
    return;
  }
  edits_.back() = composed(std::move(edits_.back()), edit);
  if (changes_nothing(edits_.back())) {
    edits_.pop_back();
    --done_;
    run_open_ = false;
  }
}

void History::end_run() { run_open_ = false; }

std::string History::undo_label() const { return can_undo() ? edits_[done_ - 1].label : ""; }

std::string History::redo_label() const { return can_redo() ? edits_[done_].label : ""; }

const Edit& History::undo(Scene& scene) {
  if (!can_undo()) throw std::logic_error("history: nothing to undo");
  revert(edits_[done_ - 1], scene);
  run_open_ = false;
  return edits_[--done_];
}

const Edit& History::redo(Scene& scene) {
  if (!can_redo()) throw std::logic_error("history: nothing to redo");
  apply(edits_[done_], scene);
  run_open_ = false;
  return edits_[done_++];
}

void History::forget_undone() {
  if (saved_ > done_) saved_reachable_ = false;
  edits_.resize(done_);
}

void History::mark_saved() {
  run_open_ = false;
  saved_ = done_;
  saved_reachable_ = true;
}

bool History::changed() const { return !saved_reachable_ || saved_ != done_; }

}  // namespace sarsim::scene
