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
[[nodiscard]] auto* carrier_member(Object& object) {
  if constexpr (Kind<std::remove_const_t<Object>>::stands_on_platform)
    return &object.platform;
  else if constexpr (Kind<std::remove_const_t<Object>>::belongs_to_radar)
    return &object.radar;
  else
    return static_cast<std::string*>(nullptr);
}
[[nodiscard]] inline std::string* carrier_in(AnyObject& any) {
  return std::visit([](auto& object) { return carrier_member(object); }, any);
}

}  // namespace sarsim::scene
