#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/model/kinds.hpp"
#include "scene/schema/field_spec.hpp"
#include "scene/schema/field_value.hpp"
#include "scene/schema/grammar.hpp"

/// The table of the fields of one kind of object, which is put together once (fields_*.cpp) and asked by all others.
namespace sarsim::scene {

/// A field with the means to reach it in an object.
template <class Object>
struct FieldOf {
  FieldSpec spec;
  script::Field in_script;                     ///< What the script language needs of it.
  FieldValue (*get)(const Object&) = nullptr;  ///< The value in an object.
  void (*put)(Object&,
              const FieldValue&) = nullptr;         ///< Nothing for functions; std::bad_variant_access for other types.
  void (*reset)(Object&) = nullptr;                 ///< To the initial value.
  FunctionRef (*function)(Object&) = nullptr;       ///< FieldType::function only.
  const void* (*address)(const Object&) = nullptr;  ///< Of the member: which one it is.
  // Ways past FieldValue, for scripts with a million targets; null where the member is something else.
  const double& (*number)(const Object&) = nullptr;  ///< FieldType::number only.
  void (*set_number)(Object&, double) = nullptr;
  const core::Vec3& (*vector)(const Object&) = nullptr;
  void (*set_vector)(Object&, const core::Vec3&) = nullptr;
  int (*alternative)(const Object&) = nullptr;  ///< Of an enumeration or a bool.
  void* (*list)(Object&) = nullptr;             ///< FieldType::list only: its vector.
};

/// The fields of a kind of object, in the order of its form. Members are named by the path to them: a pointer to a
/// member, then further ones or positions in arrays: `<&Radar::transmit_antenna, &Antenna::pattern>`.
template <class Object>
class FieldTable {
 public:
  /// What follows belongs to this group of the form.
  FieldTable& group(std::string_view name) {
    group_ = name;
    return always();
  }
  /// What follows, up to the next call, means something only where a choice is one of these.
  template <auto... Path, class... Values>
  FieldTable& when(Values... values) {
    when_ = {position<Path...>(), {static_cast<int>(values)...}};
    return *this;
  }
  /// What follows, up to the next call, always means something.
  FieldTable& always() {
    when_ = {};
    return *this;
  }

  /// Adds the field of a member. Its type follows from the member's.
  template <auto... Path>
  FieldTable& add(FieldSpec spec) {
    using Member = std::remove_cvref_t<decltype(field_values::member<Path...>(std::declval<Object&>()))>;
    spec.type = field_values::type_of<Member>(spec);
    spec.likely = both(both(spec.likely, likely_range(spec.quantity)), spec.range);
    spec.group = group_;
    spec.when = when_;
    FieldOf<Object> field{spec,
                          script::parameter_of(spec),
                          [](const Object& o) { return field_values::held(field_values::member<Path...>(o)); },
                          put<Path...>,
                          [](Object& o) { replace<Path...>(o, field_values::member<Path...>(initial_object())); },
                          nullptr,
                          [](const Object& o) -> const void* { return &field_values::member<Path...>(o); }};
    if constexpr (field_values::is_function<Member>)
      field.function = [](Object& o) {
        auto& f = field_values::member<Path...>(o);
        return FunctionRef{f.part, &f.file};
      };
    if constexpr (field_values::list_kind<Member> != ListKind::none) {
      field.spec.list = field_values::list_kind<Member>;
      field.list = [](Object& o) -> void* { return &field_values::member<Path...>(o); };
    }
    if constexpr (std::is_same_v<Member, double>)
      if (spec.type == FieldType::number) {
        field.number = [](const Object& o) -> const double& { return field_values::member<Path...>(o); };
        field.set_number = [](Object& o, double value) { replace<Path...>(o, value); };
      }
    if constexpr (std::is_same_v<Member, core::Vec3>) {
      field.vector = [](const Object& o) -> const core::Vec3& { return field_values::member<Path...>(o); };
      field.set_vector = [](Object& o, const core::Vec3& value) { replace<Path...>(o, value); };
    }
    if constexpr (std::is_enum_v<Member> || std::is_same_v<Member, bool>)
      field.alternative = [](const Object& o) { return static_cast<int>(field_values::member<Path...>(o)); };
    fields_.push_back(std::move(field));
    return *this;
  }

  /// Called when a choice has changed: gives what becomes meaningful a beginning. The object as it was comes first.
  FieldTable& on_switch(void (*begin)(const Object& before, Object& after)) {
    begin_ = begin;
    return *this;
  }

  [[nodiscard]] const std::vector<FieldOf<Object>>& fields() const { return fields_; }

  /// The field of a member; std::logic_error where it has none.
  template <auto... Path>
  [[nodiscard]] const FieldOf<Object>& field() const {
    return fields_[position<Path...>()];
  }

  /// Whether a field means something for the object as it is.
  [[nodiscard]] bool applies(const Object& object, const FieldOf<Object>& field) const {
    const Condition* when = &field.spec.when;
    while (!when->among.empty()) {
      const FieldOf<Object>& choice = fields_[when->field];
      const bool is_one = choice.alternative != nullptr
                              ? std::ranges::find(when->among, choice.alternative(object)) != when->among.end()
                              : is_among(choice.get(object), when->among);
      if (!is_one) return false;
      when = &choice.spec.when;
    }
    return true;
  }

  /// To be called when a choice has changed: what becomes meaningful gets a beginning, the rest its initial value.
  void settle(const Object& before, Object& after) const {
    if (begin_ != nullptr) begin_(before, after);
    // A choice stands before what depends on it, so that one pass is enough.
    for (const FieldOf<Object>& field : fields_)
      if (!applies(after, field)) field.reset(after);
  }

 private:
  static const Object& initial_object() {
    static const Object made{};
    return made;
  }

  template <auto... Path>
  static void put(Object& object, const FieldValue& value) {
    if constexpr (field_values::stands_in_shared<Object, Path...>()) {
      auto changed = field_values::member<Path...>(std::as_const(object));
      field_values::hold(changed, value);
      replace<Path...>(object, changed);
    } else {
      field_values::hold(field_values::member<Path...>(object), value);
    }
  }

  // What is shared with other objects stays so where nothing changes.
  template <auto... Path, class Member>
  static void replace(Object& object, const Member& value) {
    if constexpr (field_values::stands_in_shared<Object, Path...>())
      if (identical(field_values::member<Path...>(std::as_const(object)), value)) return;
    field_values::member<Path...>(object) = value;
  }

  template <auto... Path>
  [[nodiscard]] std::size_t position() const {
    const void* const wanted = &field_values::member<Path...>(initial_object());
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (fields_[i].address(initial_object()) == wanted) return i;
    throw std::logic_error("a member of a scene's object has no field");
  }

  std::vector<FieldOf<Object>> fields_;
  std::string_view group_;
  Condition when_;
  void (*begin_)(const Object&, Object&) = nullptr;
};

/// A function that is `value` throughout, for one that has no points yet.
void begin_constant(core::SampledFunction& function, double value);

/// The table of a kind of object, made at first use.
template <class Object>
[[nodiscard]] const FieldTable<Object>& table_of();
template <>
const FieldTable<Platform>& table_of<Platform>();
template <>
const FieldTable<Target>& table_of<Target>();
template <>
const FieldTable<Cloud>& table_of<Cloud>();
template <>
const FieldTable<Surface>& table_of<Surface>();
template <>
const FieldTable<Radar>& table_of<Radar>();
template <>
const FieldTable<Simulation>& table_of<Simulation>();
template <>
const FieldTable<GeometryTable>& table_of<GeometryTable>();
template <>
const FieldTable<RunOptions>& table_of<RunOptions>();
template <>
const FieldTable<World>& table_of<World>();
template <>
const FieldTable<Atmosphere>& table_of<Atmosphere>();
template <>
const FieldTable<Leg>& table_of<Leg>();
template <>
const FieldTable<Waypoint>& table_of<Waypoint>();
template <>
const FieldTable<Oscillation>& table_of<Oscillation>();

/// Calls `visit` with the vector that a list is and returns what it returns.
/// @param list  a `void*` or `const void*`, of `FieldOf::list` or `ConstListRef`
template <class Pointer, class Visit>
decltype(auto) visit_elements(ListKind kind, Pointer list, Visit&& visit) {
  const auto as = [&]<class Element>(std::type_identity<Element>) -> decltype(auto) {
    using List = std::conditional_t<std::is_const_v<std::remove_pointer_t<Pointer>>, const std::vector<Element>,
                                    std::vector<Element>>;
    return visit(*static_cast<List*>(list));
  };
  switch (kind) {
    case ListKind::legs: return as(std::type_identity<Leg>{});
    case ListKind::waypoints: return as(std::type_identity<Waypoint>{});
    case ListKind::sines: return as(std::type_identity<Oscillation>{});
    case ListKind::none: break;
  }
  throw std::logic_error("a field is no list");
}

/// The same, for loops over the kinds.
template <class Object>
[[nodiscard]] const FieldTable<Object>& table_of(const Kind<Object>&) {
  return table_of<Object>();
}

/// The field of a member, found once: `field_of<&Radar::prf_hz>()`.
template <auto First, auto... Rest>
[[nodiscard]] const auto& field_of() {
  using Object = field_values::OwnerOf<decltype(First)>;
  static const FieldOf<Object>& found = table_of<Object>().template field<First, Rest...>();
  return found;
}

}  // namespace sarsim::scene
