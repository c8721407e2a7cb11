#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/maths/angle.hpp"
#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_spec.hpp"

/// How members of the scene's structures and values of fields become each other. Internal to field_table.hpp.
namespace sarsim::scene::field_values {

/// See `OwnerOf`.
template <class Pointer>
struct Owner;
/// See `OwnerOf`.
template <class Object, class Member>
struct Owner<Member Object::*> {
  using Type = Object;
};
/// The structure that a pointer to a member belongs to.
template <class Pointer>
using OwnerOf = typename Owner<Pointer>::Type;

/// The member at the end of a path of pointers to members and positions in arrays; through values that objects share,
/// of which one that is to be changed becomes the object's own.
template <auto First, auto... Rest>
auto& member(auto&& object) {
  if constexpr (is_shared<std::remove_cvref_t<decltype(object)>>) {
    if constexpr (std::is_const_v<std::remove_reference_t<decltype(object)>>)
      return member<First, Rest...>(*object);
    else
      return member<First, Rest...>(object.edit());
  } else {
    auto& found = [&]() -> auto& {
      if constexpr (std::integral<decltype(First)>)
        return object[First];
      else
        return object.*First;
    }
    ();
    if constexpr (sizeof...(Rest) == 0)
      return found;
    else
      return member<Rest...>(found);
  }
}

template <class Member>
inline constexpr bool is_function = false;
template <std::size_t N>
inline constexpr bool is_function<UserFunction<N>> = true;

template <class Member>
inline constexpr ListKind list_kind = ListKind::none;
template <>
inline constexpr ListKind list_kind<std::vector<Leg>> = ListKind::legs;
template <>
inline constexpr ListKind list_kind<std::vector<Waypoint>> = ListKind::waypoints;
template <>
inline constexpr ListKind list_kind<std::vector<Oscillation>> = ListKind::sines;

/// Whether the member at the end of a path stands in a value that objects share.
template <class Object, auto First, auto... Rest>
constexpr bool stands_in_shared() {
  if constexpr (is_shared<Object>)
    return true;
  else if constexpr (sizeof...(Rest) == 0)
    return false;
  else
    return stands_in_shared<std::remove_cvref_t<decltype(member<First>(std::declval<Object&>()))>, Rest...>();
}

/// The type of a field whose member is a `Member`.
template <class Member>
FieldType type_of(const FieldSpec& spec) {
  if constexpr (is_function<Member>) return FieldType::function;
  if constexpr (list_kind<Member> != ListKind::none) return FieldType::list;
  if constexpr (std::same_as<Member, std::string> || std::same_as<Member, SharedName>)
    return spec.refers.empty() ? FieldType::text : FieldType::name;
  if constexpr (std::same_as<Member, bool>) return FieldType::check;
  if constexpr (std::is_enum_v<Member>) return FieldType::choice;
  if constexpr (std::same_as<Member, std::uint64_t>) return FieldType::seed;
  if constexpr (std::same_as<Member, core::Vec3> || std::same_as<Member, std::array<core::Angle, 3>>)
    return FieldType::vector;
  if (!spec.choices.empty()) return FieldType::choice;
  return spec.flags.empty() ? FieldType::number : FieldType::flags;
}

/// @name The value of a member.
/// @{
inline FieldValue held(double value) { return value; }
inline FieldValue held(int value) { return static_cast<double>(value); }
inline FieldValue held(std::uint64_t value) { return value; }
inline FieldValue held(bool value) { return value; }
inline FieldValue held(const core::Angle& value) { return value.deg(); }
inline FieldValue held(const core::PowerRatio& value) { return value.db(); }
inline FieldValue held(const core::Vec3& value) { return value; }
inline FieldValue held(const std::array<core::Angle, 3>& value) {
  return core::Vec3{value[0].deg(), value[1].deg(), value[2].deg()};
}
inline FieldValue held(const std::string& value) { return value; }
inline FieldValue held(const SharedName& value) { return *value; }
/// See above.
template <std::size_t N>
FieldValue held(const UserFunction<N>& value) {
  return ConstFunctionRef{value.part, &value.file};
}
/// See above.
template <class Element>
FieldValue held(const std::vector<Element>& value) {
  return ConstListRef{&value, list_kind<std::vector<Element>>};
}
/// See above.
template <class Enum>
FieldValue held(Enum value) requires std::is_enum_v<Enum> {
  return static_cast<int>(value);
}

/// @}

/// @name Gives a member a value; nothing to functions and lists, which are edited in place.
/// @{
inline void hold(double& member, const FieldValue& value) { member = std::get<double>(value); }
inline void hold(int& member, const FieldValue& value) { member = static_cast<int>(std::get<double>(value)); }
inline void hold(std::uint64_t& member, const FieldValue& value) { member = std::get<std::uint64_t>(value); }
inline void hold(bool& member, const FieldValue& value) { member = std::get<bool>(value); }
inline void hold(core::Angle& member, const FieldValue& value) {
  member = core::Angle::from_deg(std::get<double>(value));
}
inline void hold(core::PowerRatio& member, const FieldValue& value) {
  member = core::PowerRatio::from_db(std::get<double>(value));
}
inline void hold(core::Vec3& member, const FieldValue& value) { member = std::get<core::Vec3>(value); }
inline void hold(std::array<core::Angle, 3>& member, const FieldValue& value) {
  const auto& degrees = std::get<core::Vec3>(value);
  member = {core::Angle::from_deg(degrees.x), core::Angle::from_deg(degrees.y), core::Angle::from_deg(degrees.z)};
}
inline void hold(std::string& member, const FieldValue& value) { member = std::get<std::string>(value); }
inline void hold(SharedName& member, const FieldValue& value) { member = std::get<std::string>(value); }
/// See above.
template <std::size_t N>
void hold(UserFunction<N>&, const FieldValue&) {}
/// See above.
template <class Element>
void hold(std::vector<Element>&, const FieldValue&) {}
/// See above.
template <class Enum>
void hold(Enum& member, const FieldValue& value) requires std::is_enum_v<Enum> {
  member = static_cast<Enum>(std::get<int>(value));
}
/// @}

}  // namespace sarsim::scene::field_values
