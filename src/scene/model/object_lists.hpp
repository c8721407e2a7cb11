#pragma once

#include <type_traits>
#include <utility>

#include "scene/model/object.hpp"

/// The members that objects of different kinds share, for code that treats all kinds alike.
namespace sarsim::scene {

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
