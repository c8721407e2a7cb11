#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "scene/edit/edit.hpp"
#include "scene/model/object.hpp"
#include "scene/script/random_scene_test_support.hpp"

namespace sarsim::scene::test {

/// Random edits of a scene, each by one of the makers; the same seed gives the same edits for the same scenes.
class RandomEdits {
 public:
  explicit RandomEdits(std::uint64_t seed) : engine_(seed), scenes_(seed) {}

  Edit edit(const Scene& scene) {
    const std::vector<ObjectId> ids = some_of(scene);
    switch (ids.empty() ? 5 : below(10)) {
      case 0: return replace_object(scene, ids[0], random_object(ids[0].kind), "replace");
      case 1:
      case 2: return replace_object(scene, ids[0], nudged(object_of(scene, ids[0])), "nudge");
      case 3: return below(3) == 0 ? remove_objects(scene, {ids[0]}) : add_object(scene, random_object(any_kind()));
      case 4: return duplicate_objects(scene, {ids[0]});
      case 5: return add_object(scene, random_object(any_kind()));
      case 6: return rename_any(scene);
      case 7: return carry_objects(scene, ids, scene.platforms.empty() ? "Earth" : scene.platforms[0].name);
      case 8: return change_options(scene, scenes_.scene().options);
      default: return several(scene, ids);
    }
  }

  std::uint64_t below(std::uint64_t limit) { return engine_() % limit; }

  AnyObject random_object(ObjectKind kind) {
    for (;;) {
      const Scene scene = scenes_.scene();
      if (count_of(scene, kind) > 0) return object_of(scene, {kind, 0});
    }
  }

 private:
  ObjectKind any_kind() { return static_cast<ObjectKind>(below(kind_count)); }

  std::vector<ObjectId> some_of(const Scene& scene) {
    std::vector<ObjectId> all;
    for (const ObjectKind kind : all_object_kinds)
      for (std::size_t i = 0; i < count_of(scene, kind); ++i) all.push_back({kind, i});
    std::shuffle(all.begin(), all.end(), engine_);
    if (all.size() > 3) all.resize(1 + below(3));
    return all;
  }

  // A small change of a number or a choice, as people make them.
  AnyObject nudged(AnyObject object) {
    const double number = scenes_.number();
    if (auto* const platform = std::get_if<Platform>(&object))
      platform->rotation_rate[1] = core::Angle::from_deg(number);
    if (auto* const target = std::get_if<Target>(&object)) target->position_m.y = number;
    if (auto* const surface = std::get_if<Surface>(&object)) surface->corner_m[below(3)].z = number;
    if (auto* const radar = std::get_if<Radar>(&object)) {
      if (below(2) == 0)
        radar->power_w = std::abs(number);
      else
        radar->beam = radar->beam == Radar::Beam::spot ? Radar::Beam::fixed : Radar::Beam::spot;
      if (radar->beam == Radar::Beam::spot) radar->beam_elevation = radar->beam_azimuth = core::Angle{};
      if (radar->beam == Radar::Beam::spot) radar->beam_rate = core::Angle{}, radar->beam_target_world_m = {};
      if (radar->beam != Radar::Beam::spot) radar->spot_world_m = {};
    }
    if (auto* const simulation = std::get_if<Simulation>(&object)) simulation->range_end_m = number;
    if (auto* const table = std::get_if<GeometryTable>(&object)) table->columns = static_cast<int>(below(256));
    return object;
  }

  Edit rename_any(const Scene& scene) {
    const ObjectKind kind = scene.radars.empty() || below(2) == 0 ? ObjectKind::platform : ObjectKind::radar;
    if (count_of(scene, kind) == 0) return add_object(scene, random_object(kind));
    AnyObject donor = random_object(kind);
    return rename_object(scene, {kind, below(count_of(scene, kind))}, *name_in(donor));
  }

  // Removals, insertions in the middle and replacements in one edit.
  Edit several(const Scene& scene, const std::vector<ObjectId>& ids) {
    Edit edit = remove_objects(scene, {ids[0]});
    Scene after = scene;
    apply(edit, after);
    for (int i = 0; i < 3; ++i) {
      const ObjectKind kind = any_kind();
      const ObjectId place{kind, below(count_of(after, kind) + 1)};
      Edit insertion;
      insertion.changes.push_back({place, std::nullopt, random_object(kind)});
      apply(insertion, after);
      edit.changes.push_back(std::move(insertion.changes[0]));
    }
    for (const ObjectId id : some_of(after)) {
      edit.changes.push_back({id, object_of(after, id), nudged(object_of(after, id))});
    }
    return edit;
  }

  std::mt19937_64 engine_;
  RandomScenes scenes_;
};

}  // namespace sarsim::scene::test
