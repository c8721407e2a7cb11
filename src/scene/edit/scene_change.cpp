#include "scene/edit/scene_change.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "scene/edit/edit_runs.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

using Places = std::vector<std::size_t>;  // in a list, ascending

// Puts the second into the first; both ascending.
void merge_places(Places& first, const Places& second) {
  const auto middle = static_cast<std::ptrdiff_t>(first.size());
  first.insert(first.end(), second.begin(), second.end());
  std::inplace_merge(first.begin(), first.begin() + middle, first.end());
}

// What became of one list, run by run.
class ListStory {
 public:
  void follow(std::span<const ListChange> run) {
    if (run.front().removes()) note_removed(run);
    move_places(inserted_, run);
    move_changed(run);
    if (run.front().inserts()) {
      Places added;
      for (const ListChange& change : run) added.push_back(change.id.index);
      merge_places(inserted_, added);
    } else if (!run.front().removes()) {
      note_changed(run);
    }
  }

  void tell(ObjectKind kind, SceneChange& story) {
    for (const std::size_t place : removed_) story.removed.push_back({kind, place});
    for (const std::size_t place : inserted_) story.inserted.push_back({kind, place});
    for (const ChangedObject& object : changed_)
      if (!std::ranges::binary_search(inserted_, object.id.index)) story.changed.push_back(object);
  }

 private:
  // Those that were there before, by their places then.
  void note_removed(std::span<const ListChange> run) {
    Places before;
    std::size_t added = 0;  // since, before a place
    std::size_t gone = 0;
    for (auto change = run.rbegin(); change != run.rend(); ++change) {
      const std::size_t place = change->id.index;
      while (added < inserted_.size() && inserted_[added] < place) ++added;
      if (added < inserted_.size() && inserted_[added] == place) continue;  // came and went
      while (gone < removed_.size() && removed_[gone] <= place - added + gone) ++gone;
      before.push_back(place - added + gone);
    }
    merge_places(removed_, before);
  }

  void move_changed(std::span<const ListChange> run) {
    if (run.front().removes())
      std::erase_if(changed_, [&](const ChangedObject& object) {
        return std::ranges::binary_search(run, object.id, std::ranges::greater{}, &ListChange::id);
      });
    Places places;
    for (const ChangedObject& object : changed_) places.push_back(object.id.index);
    move_places(places, run);
    for (std::size_t i = 0; i < places.size(); ++i) changed_[i].id.index = places[i];
  }

  void note_changed(std::span<const ListChange> run) {
    std::vector<ChangedObject> now;
    for (const ListChange& change : run) now.push_back(compared(change));
    if (now.front().id > now.back().id) std::ranges::reverse(now);  // as an undo goes
    const auto middle = static_cast<std::ptrdiff_t>(changed_.size());
    changed_.insert(changed_.end(), now.begin(), now.end());
    std::ranges::inplace_merge(changed_, changed_.begin() + middle, {}, &ChangedObject::id);
    join_twins();
  }

  // What was replaced twice is told once.
  void join_twins() {
    std::size_t kept = 0;
    for (const ChangedObject& object : changed_) {
      if (kept > 0 && changed_[kept - 1].id == object.id) {
        changed_[kept - 1].name |= object.name;
        changed_[kept - 1].carrier |= object.carrier;
      } else {
        changed_[kept++] = object;
      }
    }
    changed_.resize(kept);
  }

  static ChangedObject compared(const ListChange& change) {
    ChangedObject object{change.id};
    change.out->visit([&]<class Object>(const Object& before) {
      const Object* const after = change.in->get_if<Object>();
      if (after == nullptr) return;
      if constexpr (Kind<Object>::is_named) object.name = before.name != after->name;
      if constexpr (Kind<Object>::stands_on_platform || Kind<Object>::belongs_to_radar)
        object.carrier = *carrier_in(before) != *carrier_in(*after);
    });
    return object;
  }

  Places removed_;  // as they were numbered before
  Places inserted_;
  std::vector<ChangedObject> changed_;
};

}  // namespace

bool SceneChange::concerns(ObjectKind kind) const {
  const auto is_one = [&](ObjectId id) { return id.kind == kind; };
  return everything || std::ranges::any_of(removed, is_one) || std::ranges::any_of(inserted, is_one) ||
         std::ranges::any_of(changed, is_one, &ChangedObject::id);
}

bool SceneChange::concerns(ObjectId id) const {
  return everything || std::ranges::binary_search(inserted, id) ||
         std::ranges::binary_search(changed, id, {}, &ChangedObject::id);
}

std::optional<ObjectId> SceneChange::moved(ObjectId before) const {
  if (everything || std::ranges::binary_search(removed, before)) return std::nullopt;
  ObjectId now = before;
  for (const ObjectId gone : removed)
    if (gone.kind == before.kind && gone.index < before.index) --now.index;
  for (const ObjectId added : inserted)
    if (added.kind == before.kind && added.index <= now.index) ++now.index;
  return now;
}

bool SceneChange::concerns_names() const {
  return !same_objects() ||
         std::ranges::any_of(changed, [](const ChangedObject& object) { return object.name || object.carrier; });
}

bool keeps_objects(const Edit& edit) {
  return !edit.world_after && !edit.air_after && std::ranges::all_of(edit.changes, [](const ObjectChange& change) {
    return change.before.has_value() && change.after.has_value();
  });
}

SceneChange change_of(const Edit& edit, bool forwards) {
  std::array<ListStory, std::size(all_object_kinds)> stories;
  const std::vector<ListChange> changes = list_changes(edit, forwards);
  for (std::span<const ListChange> rest = changes; !rest.empty();) {
    const std::span<const ListChange> run = rest.first(run_length(rest));
    stories[static_cast<std::size_t>(run.front().id.kind)].follow(run);
    rest = rest.subspan(run.size());
  }
  SceneChange story;
  story.options = edit.options_after.has_value();
  story.everything = story.everything || edit.world_after.has_value() || edit.air_after.has_value();
  for (const ObjectKind kind : all_object_kinds) stories[static_cast<std::size_t>(kind)].tell(kind, story);
  return story;
}

}  // namespace sarsim::scene
