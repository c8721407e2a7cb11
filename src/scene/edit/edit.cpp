#include "scene/edit/edit.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "scene/edit/edit_runs.hpp"
#include "scene/model/object.hpp"

namespace sarsim::scene {

namespace {

// A half-typed object may hold numbers that are none and then differs from itself.
template <class Object>
bool same(const Object& a, const Object& b) {
  return a == b || (!(a == a) && !(b == b));
}

template <class Object>
void change_objects(std::vector<Object>& list, std::span<const ListChange> run) {
  for (const ListChange& change : run)
    for (const SharedObject* object : {change.out, change.in})
      if (object != nullptr && object->get_if<Object>() == nullptr)
        throw std::logic_error("edit: an object is of another kind than its id");
  change_list(
      list, run,
      [](const Object& object, const ListChange& change) { return same(object, *change.out->get_if<Object>()); },
      [](Object& object, const ListChange& change) { object = *change.in->get_if<Object>(); },
      [](Object&&, const ListChange&) {}, [](const ListChange& change) { return *change.in->get_if<Object>(); });
}

void change_scene(std::span<const ListChange> changes, Scene& scene) {
  while (!changes.empty()) {
    const std::size_t count = run_length(changes);
    visit_list(scene, changes.front().id.kind, [&](auto& list) { change_objects(list, changes.first(count)); });
    changes = changes.subspan(count);
  }
}

// Makes the changes or, where one does not fit, none of them.
void change_scene_or_nothing(const Edit& edit, bool forwards, Scene& scene) {
  const std::vector<ListChange> changes = list_changes(edit, forwards);
  for (std::span<const ListChange> rest = changes; !rest.empty();) {
    const std::size_t count = run_length(rest);
    try {
      change_scene(rest.first(count), scene);
    } catch (...) {
      std::vector<ListChange> undo(changes.begin(), changes.end() - static_cast<std::ptrdiff_t>(rest.size()));
      std::ranges::reverse(undo);
      for (ListChange& change : undo) std::swap(change.out, change.in);
      change_scene(undo, scene);
      throw;
    }
    rest = rest.subspan(count);
  }
}

void make(const Edit& edit, bool forwards, Scene& scene) {
  if (edit.options_before.has_value() != edit.options_after.has_value())
    throw std::logic_error("edit: options are given for one side only");
  const auto& options_out = forwards ? edit.options_before : edit.options_after;
  const auto& options_in = forwards ? edit.options_after : edit.options_before;
  if (options_out && !same(*options_out, scene.options)) throw_foreign_edit();
  const auto& world_out = forwards ? edit.world_before : edit.world_after;
  const auto& world_in = forwards ? edit.world_after : edit.world_before;
  if (world_out && !(*world_out == scene.world)) throw_foreign_edit();
  const auto& air_out = forwards ? edit.air_before : edit.air_after;
  const auto& air_in = forwards ? edit.air_after : edit.air_before;
  if (air_out && !(*air_out == scene.atmosphere)) throw_foreign_edit();
  change_scene_or_nothing(edit, forwards, scene);
  if (options_in) scene.options = *options_in;
  if (world_in) scene.world = *world_in;
  if (air_in) scene.atmosphere = *air_in;
}

}  // namespace

std::vector<ListChange> list_changes(const Edit& edit, bool forwards) {
  std::vector<ListChange> changes;
  changes.reserve(edit.changes.size());
  for (const ObjectChange& change : edit.changes) {
    if (!change.before && !change.after) throw std::logic_error("edit: a change without an object");
    const SharedObject* const before = change.before ? &change.before : nullptr;
    const SharedObject* const after = change.after ? &change.after : nullptr;
    changes.push_back(forwards ? ListChange{change.id, before, after} : ListChange{change.id, after, before});
  }
  if (!forwards) std::ranges::reverse(changes);
  return changes;
}

std::size_t run_length(std::span<const ListChange> changes) {
  std::size_t length = 1;
  for (; length < changes.size(); ++length) {
    const ListChange& last = changes[length - 1];
    const ListChange& next = changes[length];
    if (next.id.kind != last.id.kind || next.inserts() != last.inserts() || next.removes() != last.removes()) break;
    if (next.inserts() && next.id.index <= last.id.index) break;
    if (next.removes() && next.id.index >= last.id.index) break;
    // One way all through. The same object replaced twice: the second expects what the first leaves.
    const bool replaces = !next.inserts() && !next.removes();
    const bool upwards = changes[1].id.index > changes[0].id.index;
    if (replaces && (next.id.index == last.id.index || (next.id.index > last.id.index) != upwards)) break;
  }
  return length;
}

void move_places(std::vector<std::size_t>& places, std::span<const ListChange> run) {
  if (run.front().inserts()) {
    std::size_t before = 0;  // insertions that come before the place
    for (std::size_t& place : places) {
      while (before < run.size() && run[before].id.index <= place + before) ++before;
      place += before;
    }
  } else if (run.front().removes()) {
    std::size_t left = run.size();  // removals of what stands further on; the run descends
    std::erase_if(places, [&](std::size_t place) {
      while (left > 0 && run[left - 1].id.index < place) --left;
      return left > 0 && run[left - 1].id.index == place;
    });
    left = run.size();
    for (std::size_t& place : places) {
      while (left > 0 && run[left - 1].id.index < place) --left;
      place -= run.size() - left;
    }
  }
}

void apply(const Edit& edit, Scene& scene) { make(edit, true, scene); }

void revert(const Edit& edit, Scene& scene) { make(edit, false, scene); }

bool changes_nothing(const Edit& edit) {
  return edit.script.changes.empty() && edit.script.broken_before == edit.script.broken_after &&
         edit.options_before == edit.options_after && edit.world_before == edit.world_after &&
         edit.air_before == edit.air_after && std::ranges::all_of(edit.changes, [](const ObjectChange& change) {
           return change.before && change.before == change.after;
         });
}

Edit composed(Edit first, const Edit& second) {
  // Where the last change of each object is that no insertion or removal in its list has come after.
  std::map<ObjectId, std::size_t> latest;
  const auto note = [&](std::size_t at) {
    const ObjectChange& change = first.changes[at];
    if (!change.before || !change.after)
      std::erase_if(latest, [&](const auto& entry) { return entry.first.kind == change.id.kind; });
    if (change.after) latest[change.id] = at;
  };
  for (std::size_t i = 0; i < first.changes.size(); ++i) note(i);
  for (const ObjectChange& change : second.changes) {
    const auto known = latest.find(change.id);
    if (change.before && change.after && known != latest.end()) {
      first.changes[known->second].after = change.after;
      continue;
    }
    first.changes.push_back(change);
    note(first.changes.size() - 1);
  }
  std::erase_if(first.changes,
                [](const ObjectChange& change) { return change.before && change.before == change.after; });
  if (second.options_after) {
    if (!first.options_before) first.options_before = second.options_before;
    first.options_after = second.options_after;
  }
  if (second.world_after) {
    if (!first.world_before) first.world_before = second.world_before;
    first.world_after = second.world_after;
  }
  if (second.air_after) {
    if (!first.air_before) first.air_before = second.air_before;
    first.air_after = second.air_after;
  }
  first.script.changes = composed(first.script.changes, second.script.changes);
  for (const auto& [name, changes] : second.script.included)
    first.script.included[name] = composed(first.script.included[name], changes);
  first.script.broken_after = second.script.broken_after;
  return first;
}

std::optional<ObjectId> moved(ObjectId id, const Edit& edit, bool forwards) {
  const std::set<ObjectId> there = moved(std::set{id}, edit, forwards);
  return there.empty() ? std::nullopt : std::optional(*there.begin());
}

std::set<ObjectId> moved(const std::set<ObjectId>& ids, const Edit& edit, bool forwards) {
  std::array<std::vector<std::size_t>, kind_count> places;  // of each kind, ascending
  for (const ObjectId id : ids) places[static_cast<std::size_t>(id.kind)].push_back(id.index);
  const std::vector<ListChange> changes = list_changes(edit, forwards);
  for (std::span<const ListChange> rest = changes; !rest.empty();) {
    const std::span<const ListChange> run = rest.first(run_length(rest));
    move_places(places[static_cast<std::size_t>(run.front().id.kind)], run);
    rest = rest.subspan(run.size());
  }
  std::set<ObjectId> there;
  for (const ObjectKind kind : all_object_kinds)
    for (const std::size_t place : places[static_cast<std::size_t>(kind)]) there.insert(there.end(), {kind, place});
  return there;
}

}  // namespace sarsim::scene
