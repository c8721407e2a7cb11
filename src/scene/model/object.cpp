#include "scene/model/object.hpp"

#include <fmt/format.h>

#include "scene/model/object_lists.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

namespace {

std::string or_number(const std::string& text, const char* kind, std::size_t index) {
  return text.empty() ? fmt::format("{} {}", kind, index + 1) : text;
}

// Appends those objects of a list whose name means the platform.
template <class Object>
void append_standing(std::vector<ObjectId>& found, ObjectKind kind, const std::vector<Object>& objects,
                     SceneIndex& index, std::size_t platform) {
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (index.platform(objects[i].platform) == platform) found.push_back({kind, i});
}

}  // namespace

std::string_view name_of(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::platform: return "platform";
    case ObjectKind::target: return "target";
    case ObjectKind::surface: return "surface";
    case ObjectKind::radar: return "radar";
    case ObjectKind::simulation: return "simulation";
    case ObjectKind::geometry: return "geometry";
  }
  return "";
}

std::size_t count_of(const Scene& scene, ObjectKind kind) {
  return visit_list(scene, kind, [](const auto& list) { return list.size(); });
}

bool has_object(const Scene& scene, ObjectId id) { return id.index < count_of(scene, id.kind); }

AnyObject object_of(const Scene& scene, ObjectId id) {
  return visit_list(scene, id.kind, [&](const auto& list) { return AnyObject(list.at(id.index)); });
}

std::string label_of(const Scene& scene, ObjectId id) {
  switch (id.kind) {
    case ObjectKind::platform: return or_number(scene.platforms.at(id.index).name, "Platform", id.index);
    case ObjectKind::radar: return or_number(scene.radars.at(id.index).name, "Radar", id.index);
    case ObjectKind::simulation: return or_number(scene.simulations.at(id.index).file, "Simulation", id.index);
    case ObjectKind::geometry: return or_number(scene.geometries.at(id.index).file, "Geometry table", id.index);
    case ObjectKind::surface: return fmt::format("Surface {}", id.index + 1);
    case ObjectKind::target: break;
  }
  const core::Vec3& at = scene.targets.at(id.index).position_m;
  return fmt::format("Target {} ({:.6g}, {:.6g}, {:.6g}) m", id.index + 1, at.x, at.y, at.z);
}

std::string carrier_of(const Scene& scene, ObjectId id) {
  return visit_list(scene, id.kind, [&](const auto& list) {
    const std::string* const name = carrier_member(list.at(id.index));
    return name != nullptr ? *name : std::string();
  });
}

std::vector<ObjectId> objects_on(const Scene& scene, std::size_t platform) {
  std::vector<ObjectId> found;
  SceneIndex index(scene);
  append_standing(found, ObjectKind::target, scene.targets, index, platform);
  append_standing(found, ObjectKind::surface, scene.surfaces, index, platform);
  append_standing(found, ObjectKind::radar, scene.radars, index, platform);
  return found;
}

}  // namespace sarsim::scene
