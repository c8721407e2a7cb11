#include "scene/model/object.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/model/scene_index.hpp"

namespace sarsim::scene {

namespace {

// What rounding leaves of a place given by latitude is none.
double without_dust(double coordinate_m) {
  constexpr double dust_m = 1e-8;
  return std::abs(coordinate_m) < dust_m ? 0.0 : coordinate_m;
}

std::string position_text(const core::Vec3& at_m) {
  return fmt::format(" ({:.6g}, {:.6g}, {:.6g}) m", without_dust(at_m.x), without_dust(at_m.y), without_dust(at_m.z));
}

}  // namespace

std::string_view name_of(ObjectKind kind) {
  return visit_kind(kind, [](const auto& known) { return known.name; });
}

std::optional<ObjectKind> kind_called(std::string_view word) {
  for (const ObjectKind kind : all_object_kinds)
    if (core::equal_ignoring_case(name_of(kind), word)) return kind;
  return std::nullopt;
}

std::size_t count_of(const Scene& scene, ObjectKind kind) {
  return visit_list(scene, kind, [](const auto& list) { return list.size(); });
}

bool has_object(const Scene& scene, ObjectId id) { return id.index < count_of(scene, id.kind); }

AnyObject object_of(const Scene& scene, ObjectId id) {
  return visit_list(scene, id.kind, [&](const auto& list) { return AnyObject(list.at(id.index)); });
}

std::string label_of(const Scene& scene, ObjectId id) {
  return visit_kind(id.kind, [&]<class Object>(const Kind<Object>& kind) {
    const Object& object = (scene.*kind.list).at(id.index);
    const std::string number = fmt::format("{} {}", kind.title, id.index + 1);
    if constexpr (requires { object.name; })
      return object.name.empty() ? number : object.name;
    else if constexpr (requires { object.file; })
      return object.file.empty() ? number : object.file;
    else if constexpr (requires { object.position_m; })
      return number + position_text(object.position_m);
    else
      return number;
  });
}

std::string carrier_of(const Scene& scene, ObjectId id) {
  return visit_list(scene, id.kind, [&](const auto& list) {
    const std::string* const name = carrier_in(list.at(id.index));
    return name != nullptr ? *name : std::string();
  });
}

std::vector<ObjectId> objects_on(const Scene& scene, std::size_t platform) {
  std::vector<ObjectId> found;
  SceneIndex index(scene);
  for_each_kind([&]<class Object>(const Kind<Object>& kind) {
    if constexpr (Kind<Object>::stands_on_platform) {
      const std::vector<Object>& objects = scene.*kind.list;
      for (std::size_t i = 0; i < objects.size(); ++i)
        if (index.platform(*carrier_in(objects[i])) == platform) found.push_back({kind.kind, i});
    }
  });
  return found;
}

}  // namespace sarsim::scene
