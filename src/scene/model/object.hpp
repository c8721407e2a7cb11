#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/kinds.hpp"

namespace sarsim::scene {

[[nodiscard]] inline ObjectKind kind_of(const AnyObject& object) { return static_cast<ObjectKind>(object.index()); }

/// "platform", "target", ... as in Subject::kind (core/report/problem.hpp).
[[nodiscard]] std::string_view name_of(ObjectKind kind);
/// The kind of that name, ignoring case; nothing for another word.
[[nodiscard]] std::optional<ObjectKind> kind_called(std::string_view word);

/// Number of objects of a kind.
[[nodiscard]] std::size_t count_of(const Scene& scene, ObjectKind kind);

/// True where the scene has this object.
[[nodiscard]] bool has_object(const Scene& scene, ObjectId id);

/// A copy of an object; throws std::out_of_range where there is none.
[[nodiscard]] AnyObject object_of(const Scene& scene, ObjectId id);

/// What a list calls an object: a platform's or radar's name; "Target 3 (0, 0, 10) m"; "Surface 1"; the file of a
/// simulation or geometry table.
[[nodiscard]] std::string label_of(const Scene& scene, ObjectId id);

/// Name of the platform that carries a target, surface or radar; the radar of a simulation or geometry table; empty for
/// a platform.
[[nodiscard]] std::string carrier_of(const Scene& scene, ObjectId id);

/// The objects that stand on a platform: those whose name means it (`find_platform`), in order of kind and index. For
/// index `not_found` those that stand on the world itself, because no platform has their name.
[[nodiscard]] std::vector<ObjectId> objects_on(const Scene& scene, std::size_t platform);

/// The name that others refer to an object by; null where it has none.
[[nodiscard]] inline std::string* name_in(AnyObject& any) {
  return std::visit(
      [](auto& object) -> std::string* {
        if constexpr (Kind<std::remove_cvref_t<decltype(object)>>::is_named)
          return &object.name;
        else
          return nullptr;
      },
      any);
}

/// The name of the platform or radar that an object refers to; null where it refers to none.
template <class Object>
[[nodiscard]] const std::string* carrier_in(const Object& object) {
  if constexpr (std::is_same_v<Object, AnyObject>)
    return std::visit([](const auto& any) { return carrier_in(any); }, object);
  else if constexpr (std::is_same_v<Object, Target>)
    return &*object.platform;
  else if constexpr (Kind<Object>::stands_on_platform)
    return &object.platform;
  else if constexpr (Kind<Object>::belongs_to_radar)
    return &object.radar;
  else
    return nullptr;
}

/// Makes an object refer to another platform or radar; nothing where it refers to none.
template <class Object>
void set_carrier(Object& object, const std::string& name) {
  if constexpr (std::is_same_v<Object, AnyObject>)
    std::visit([&](auto& any) { set_carrier(any, name); }, object);
  else if constexpr (Kind<Object>::stands_on_platform)
    object.platform = name;
  else if constexpr (Kind<Object>::belongs_to_radar)
    object.radar = name;
}

/// Lets an object take no memory of its own for what it has in common with another: to be called for the next one of a
/// list that may be long.
template <class Object>
void share_equal(Object& object, const Object& other) {
  if constexpr (std::is_same_v<Object, Target>) {
    object.platform.share(other.platform);
    object.traits.share(other.traits);
  }
}

}  // namespace sarsim::scene
