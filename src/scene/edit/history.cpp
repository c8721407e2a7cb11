#include "scene/edit/history.hpp"

#include <stdexcept>
#include <utility>

namespace sarsim::scene {

std::shared_ptr<const Edit> History::perform(Edit edit, Scene& scene) {
  auto step = std::make_shared<const Edit>(std::move(edit));
  if (changes_nothing(*step)) return step;
  apply(*step, scene);
  const bool merges =
      run_open_ && done_ > 0 && !step->merge_key.empty() && edits_[done_ - 1]->merge_key == step->merge_key;
  if (saved_ > done_) saved_reachable_ = false;
  edits_.resize(done_);
  run_open_ = !step->merge_key.empty();
  if (!merges) {
    edits_.push_back(step);
    ++done_;
    return step;
  }
  edits_.back() = std::make_shared<const Edit>(composed(*edits_.back(), *step));
  if (changes_nothing(*edits_.back())) {
    edits_.pop_back();
    --done_;
    run_open_ = false;
  }
  return step;
}

void History::end_run() { run_open_ = false; }

std::string History::undo_label() const { return can_undo() ? next_undo()->label : ""; }

std::string History::redo_label() const { return can_redo() ? next_redo()->label : ""; }

std::shared_ptr<const Edit> History::undo(Scene& scene) {
  if (!can_undo()) throw std::logic_error("history: nothing to undo");
  revert(*edits_[done_ - 1], scene);
  run_open_ = false;
  return edits_[--done_];
}

std::shared_ptr<const Edit> History::redo(Scene& scene) {
  if (!can_redo()) throw std::logic_error("history: nothing to redo");
  apply(*edits_[done_], scene);
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
