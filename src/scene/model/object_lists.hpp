#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

#include "scene/model/object.hpp"

/// The members that objects of different kinds share, for code that treats all kinds alike.
namespace sarsim::scene {

inline constexpr ObjectKind all_object_kinds[] = {ObjectKind::platform, ObjectKind::target,     ObjectKind::surface,
                                                  ObjectKind::radar,    ObjectKind::simulation, ObjectKind::geometry};

/// Calls `visit` with the scene's list of a kind and returns what it returns.
template <class SceneType, class Visit>
decltype(auto) visit_list(SceneType& scene, ObjectKind kind, Visit&& visit) {
  switch (kind) {
    case ObjectKind::platform: return visit(scene.platforms);
    case ObjectKind::target: return visit(scene.targets);
    case ObjectKind::surface: return visit(scene.surfaces);
    case ObjectKind::radar: return visit(scene.radars);
    case ObjectKind::simulation: return visit(scene.simulations);
    case ObjectKind::geometry: return visit(scene.geometries);
  }
  throw std::logic_error("no such kind of object");
}

template <class Object>
inline constexpr bool has_name = std::is_same_v<Object, Platform> || std::is_same_v<Object, Radar>;
template <class Object>
inline constexpr bool stands_on_platform =
    std::is_same_v<Object, Target> || std::is_same_v<Object, Surface> || std::is_same_v<Object, Radar>;
template <class Object>
inline constexpr bool belongs_to_radar = std::is_same_v<Object, Simulation> || std::is_same_v<Object, GeometryTable>;

/// The name that others refer to an object by; null where it has none.
[[nodiscard]] inline std::string* name_in(AnyObject& any) {
  return std::visit(
      [](auto& object) -> std::string* {
        if constexpr (has_name<std::remove_cvref_t<decltype(object)>>)
          return &object.name;
        else
          return nullptr;
      },
      any);
}

/// The name of the platform or radar that an object refers to; null where it refers to none.
template <class Object>
[[nodiscard]] auto* carrier_member(Object& object) {
  if constexpr (stands_on_platform<std::remove_const_t<Object>>)
    return &object.platform;
  else if constexpr (belongs_to_radar<std::remove_const_t<Object>>)
    return &object.radar;
  else
    return static_cast<std::string*>(nullptr);
}
[[nodiscard]] inline std::string* carrier_in(AnyObject& any) {
  return std::visit([](auto& object) { return carrier_member(object); }, any);
}

/// The kind of object that a kind refers to by name: a radar for simulations and geometry tables, else a platform.
[[nodiscard]] inline ObjectKind carrier_kind(ObjectKind kind) {
  return kind == ObjectKind::simulation || kind == ObjectKind::geometry ? ObjectKind::radar : ObjectKind::platform;
}

}  // namespace sarsim::scene
