#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/edit/edit.hpp"
#include "scene/edit/edit_names.hpp"
#include "scene/model/object.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

namespace {

std::string counted(std::string_view verb, const std::set<ObjectId>& ids) {
  if (ids.size() != 1) return fmt::format("{} {} objects", verb, ids.size());
  return fmt::format("{} {}", verb, name_of(ids.begin()->kind));
}

// What stands on platforms among the objects, in one pass for all of them.
void add_standing(const Scene& scene, std::set<ObjectId>& all) {
  std::vector<bool> gone(scene.platforms.size(), false);
  for (const ObjectId id : all)
    if (id.kind == ObjectKind::platform) gone[id.index] = true;
  if (std::ranges::find(gone, true) == gone.end()) return;
  SceneIndex names(scene);
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if constexpr (Kind<Object>::stands_on_platform) {
      const std::vector<Object>& list = scene.*kind.list;
      for (std::size_t i = 0; i < list.size(); ++i)
        if (const std::size_t platform = names.platform(*carrier_in(list[i])); platform < gone.size() && gone[platform])
          all.insert({kind.kind, i});
    }
  });
}

// The objects together with what goes where they go: what stands on platforms and, where wanted, what radars record.
std::set<ObjectId> with_dependents(const Scene& scene, const std::vector<ObjectId>& ids, bool with_recordings) {
  std::set<ObjectId> all;
  for (const ObjectId id : ids) {
    if (!has_object(scene, id)) throw std::out_of_range("edit: the scene has no such object");
    all.insert(id);
  }
  add_standing(scene, all);
  const bool radars = std::ranges::any_of(all, [](ObjectId id) { return id.kind == ObjectKind::radar; });
  if (!with_recordings || !radars) return all;
  SceneIndex names(scene);
  const auto add_recordings = [&]<class Object>(const Kind<Object>& kind) {
    if constexpr (Kind<Object>::belongs_to_radar) {
      const std::vector<Object>& list = scene.*kind.list;
      for (std::size_t i = 0; i < list.size(); ++i)
        if (const std::size_t radar = names.radar(list[i].radar);
            radar != not_found && all.contains({ObjectKind::radar, radar}))
          all.insert({kind.kind, i});
    }
  };
  for_each_kind(add_recordings);
  return all;
}

// @param places  ascending, each once
template <class Object>
void erase_places(std::vector<Object>& list, const std::vector<std::size_t>& places) {
  auto next = places.begin();
  std::size_t kept = places.front();
  for (std::size_t at = kept; at < list.size(); ++at) {
    if (next != places.end() && *next == at)
      ++next;
    else
      list[kept++] = std::move(list[at]);
  }
  list.resize(kept);
}

bool has_control_characters(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; });
}

// The names that are taken while an edit gives out new ones.
struct TakenNames {
  explicit TakenNames(const Scene& scene)
      : platforms(names_of(scene, ObjectKind::platform)),
        radars(names_of(scene, ObjectKind::radar)),
        files(file_names_of(scene)) {}

  std::vector<std::string>& of(ObjectKind kind) { return kind == ObjectKind::platform ? platforms : radars; }

  std::vector<std::string> platforms;
  std::vector<std::string> radars;
  std::vector<std::string> files;
};

std::string* output_file_in(AnyObject& any) {
  if (auto* const simulation = std::get_if<Simulation>(&any)) return &simulation->file;
  if (auto* const table = std::get_if<GeometryTable>(&any)) return &table->file;
  return nullptr;
}

void append_object(Edit& edit, ObjectId id, AnyObject object, TakenNames& taken) {
  if (std::string* const name = name_in(object)) {
    if (name->empty()) *name = id.kind == ObjectKind::platform ? "Platform" : "Radar";
    *name = free_name(taken.of(id.kind), *name);
    taken.of(id.kind).push_back(*name);
  }
  if (std::string* const file = output_file_in(object)) {
    *file = free_file_name(taken.files, *file);
    taken.files.push_back(*file);
  }
  edit.changes.push_back({id, std::nullopt, std::move(object)});
}

ObjectId meant_carrier(SceneIndex& names, const AnyObject& object, const std::string& name) {
  const ObjectKind kind = carrier_kind(kind_of(object));
  return {kind, kind == ObjectKind::platform ? names.platform(name) : names.radar(name)};
}

}  // namespace

std::string name_objection(const Scene& scene, ObjectId id, const std::string& name) {
  if (name.empty()) return "a name needs at least one character";
  if (has_control_characters(name)) return "a name must not contain line ends or control characters";
  const std::vector<std::string> names = names_of(scene, id.kind);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != id.index && core::equal_ignoring_case(names[i], name))
      return fmt::format("another {} has this name", name_of(id.kind));
  return {};
}

Edit replace_object(const Scene& scene, ObjectId id, AnyObject with, std::string label, std::string merge_key) {
  AnyObject before = object_of(scene, id);
  if (kind_of(with) != id.kind) throw std::invalid_argument("edit: an object cannot become one of another kind");
  if (std::string* const name = name_in(with); name != nullptr && *name != *name_in(before)) {
    std::vector<std::string> others = names_of(scene, id.kind);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(id.index));
    *name = free_name(others, *name);
  }
  Edit edit;
  edit.label = std::move(label);
  edit.merge_key = std::move(merge_key);
  edit.changes.push_back({id, std::move(before), std::move(with)});
  keep_references(scene, edit);
  return edit;
}

Edit add_object(const Scene& scene, AnyObject object) {
  Edit edit;
  const ObjectKind kind = kind_of(object);
  edit.label = fmt::format("Add {}", name_of(kind));
  TakenNames taken(scene);
  append_object(edit, {kind, count_of(scene, kind)}, std::move(object), taken);
  keep_references(scene, edit);
  return edit;
}

Edit remove_objects(const Scene& scene, std::vector<ObjectId> ids) {
  const std::set<ObjectId> all = with_dependents(scene, ids, true);
  Edit edit;
  edit.label = counted("Delete", {ids.begin(), ids.end()});
  // From the back, so that every index is that of the scene as it is.
  for (auto id = all.rbegin(); id != all.rend(); ++id)
    edit.changes.push_back({*id, object_of(scene, *id), std::nullopt});
  return edit;
}

void erase_objects(Scene& scene, const std::vector<ObjectId>& ids) {
  std::array<std::vector<std::size_t>, kind_count> places;  // of each kind, ascending
  for (const ObjectId id : with_dependents(scene, ids, true))
    places[static_cast<std::size_t>(id.kind)].push_back(id.index);
  for (const ObjectKind kind : all_object_kinds)
    if (const auto& of_kind = places[static_cast<std::size_t>(kind)]; !of_kind.empty())
      visit_list(scene, kind, [&](auto& list) { erase_places(list, of_kind); });
}

Edit duplicate_objects(const Scene& scene, const std::vector<ObjectId>& ids) {
  Edit edit;
  edit.label = counted("Duplicate", {ids.begin(), ids.end()});
  TakenNames taken(scene);
  SceneIndex meanings(scene);
  std::map<ObjectId, std::string> new_names;
  std::map<ObjectKind, std::size_t> counts;
  // Platforms come first, radars before what records them: by the order of the kinds.
  for (const ObjectId id : with_dependents(scene, ids, false)) {
    AnyObject copy = object_of(scene, id);
    if (const std::string* const carrier = carrier_in(copy))
      if (const auto renamed = new_names.find(meant_carrier(meanings, copy, *carrier)); renamed != new_names.end())
        set_carrier(copy, renamed->second);
    const ObjectId place{id.kind, count_of(scene, id.kind) + counts[id.kind]++};
    append_object(edit, place, std::move(copy), taken);
    AnyObject made = *edit.changes.back().after;
    if (const std::string* const name = name_in(made)) new_names[id] = *name;
  }
  keep_references(scene, edit);
  return edit;
}

Edit rename_object(const Scene& scene, ObjectId id, const std::string& name) {
  AnyObject with = object_of(scene, id);
  std::string* const member = name_in(with);
  if (member == nullptr) throw std::invalid_argument("edit: only platforms and radars have names");
  *member = name;
  return replace_object(scene, id, std::move(with), fmt::format("Rename {}", name_of(id.kind)));
}

Edit carry_objects(const Scene& scene, const std::vector<ObjectId>& ids, const std::string& platform) {
  Edit edit;
  edit.label = fmt::format("Move to {}", platform);
  for (const ObjectId id : std::set<ObjectId>(ids.begin(), ids.end())) {
    AnyObject before = object_of(scene, id);
    if (id.kind == ObjectKind::platform || carrier_kind(id.kind) != ObjectKind::platform) continue;
    AnyObject after = before;
    set_carrier(after, platform);
    if (after != before) edit.changes.push_back({id, std::move(before), std::move(after)});
  }
  return edit;
}

Edit add_targets(const Scene& scene, std::vector<Target> targets) {
  Edit edit;
  edit.label = targets.size() == 1 ? "Add target" : fmt::format("Add {} targets", targets.size());
  edit.changes.reserve(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
    edit.changes.push_back({{ObjectKind::target, scene.targets.size() + i}, std::nullopt, std::move(targets[i])});
  return edit;
}

Edit change_options(const Scene& scene, RunOptions options) {
  Edit edit;
  edit.label = "Change options";
  edit.options_before = scene.options;
  edit.options_after = options;
  return edit;
}

Edit change_atmosphere(const Scene& scene, Atmosphere atmosphere) {
  Edit edit;
  edit.label = "Change atmosphere";
  edit.air_before = scene.atmosphere;
  edit.air_after = std::move(atmosphere);
  return edit;
}

Edit change_world(const Scene& scene, World world) {
  Edit edit;
  edit.label = "Change world";
  edit.world_before = scene.world;
  edit.world_after = std::move(world);
  return edit;
}

}  // namespace sarsim::scene
