#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/maths/angle.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/fields.hpp"
#include "scene/schema/grammar.hpp"

/// How the tables behind scene/schema/fields.hpp are put together. Internal to the field_*.cpp and fields_*.cpp files.
namespace sarsim::scene::field_tables {

/// The number that a member holds, in the unit in which it is held.
[[nodiscard]] inline double held(double value) { return value; }
[[nodiscard]] inline double held(int value) { return value; }
[[nodiscard]] inline double held(const core::Angle& value) { return value.deg(); }
[[nodiscard]] inline double held(const core::PowerRatio& value) { return value.db(); }
inline void hold(double& member, double value) { member = value; }
inline void hold(int& member, double value) { member = static_cast<int>(value); }
inline void hold(core::Angle& member, double value) { member = core::Angle::from_deg(value); }
inline void hold(core::PowerRatio& member, double value) { member = core::PowerRatio::from_db(value); }

/// Reads a number for a field and holds it against the limits of the script language.
struct NumberReading {
  double value = 0.0;
  std::string failure;
};
[[nodiscard]] NumberReading read_number(const script::Field& grammar, Quantity quantity, std::string_view text);

/// Why a name cannot stand in a script; empty where it can.
[[nodiscard]] std::string name_failure(std::string_view words, std::string_view text);

/// Position of the choice that is meant, without regard to case, by its whole name or a beginning that only it has.
struct ChoiceReading {
  std::size_t index = 0;
  std::string failure;
};
[[nodiscard]] ChoiceReading read_choice(const std::vector<std::string>& choices, std::string_view text);

/// "yes" and "no" and what means the same.
struct CheckReading {
  bool value = false;
  std::string failure;
};
[[nodiscard]] CheckReading read_check(std::string_view text);

/// "3 points, cubic", "3, 2 and 1 points, linear", or the name of the file.
[[nodiscard]] std::string function_summary(const core::SampledFunction* parts, std::size_t count,
                                           const std::string& file);

/// ", 0 to 7" in the field's unit for the end of a tooltip; empty where anything goes.
[[nodiscard]] std::string limits_text(const script::Field& grammar, Quantity quantity);

/// One field with the means to show and set it.
template <class Object>
struct Entry {
  Field field;
  std::function<std::string(const Object&)> text;
  std::function<std::string(Object&, std::string_view)> set;  ///< Returns why not.
  std::function<void(Object&)> reset;                         ///< To the initial value.
  std::function<bool(const Object&)> applies;                 ///< Empty: always.
  bool switches = false;                                      ///< Others may lose their meaning with it.
};

/// The fields of one kind of object. Members are given as pointers to members or as functions of the object that return
/// a reference, const or not as the object is.
template <class Object>
class FieldTable {
 public:
  using Applies = std::function<bool(const Object&)>;

  /// What follows belongs to this group.
  FieldTable& group(std::string name) {
    group_ = std::move(name);
    return *this;
  }
  /// What follows, up to the next call, means something only where this holds.
  FieldTable& where(Applies applies) {
    applies_ = std::move(applies);
    return *this;
  }
  FieldTable& always() { return where({}); }
  /// What follows, up to the next call, is shown a level down.
  FieldTable& rare(bool rare = true) {
    rare_ = rare;
    return *this;
  }

  template <class Member>
  void number(const script::Field& grammar, std::string label, Quantity quantity, Member member, std::string tooltip) {
    number_named(std::string(grammar.member), grammar, std::move(label), quantity, member, std::move(tooltip));
  }

  /// Three fields, ".x", ".y" and ".z", of a vector or of three angles.
  template <class Member>
  void vector(const script::Field& grammar, const std::string& label, Quantity quantity, Member member,
              const std::string& tooltip) {
    vector_named(std::string(grammar.member), grammar, label, quantity, member, tooltip);
  }

  /// The same with a name of its own.
  template <class Member>
  void vector_named(const std::string& id, const script::Field& grammar, const std::string& label, Quantity quantity,
                    Member member, const std::string& tooltip) {
    static constexpr std::array<std::string_view, 3> small{".x", ".y", ".z"};
    static constexpr std::array<std::string_view, 3> capital{"X ", "Y ", "Z "};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto part = [ member, axis ](auto& object) -> auto& {
        return component(std::invoke(member, object), axis);
      };
      number_named(id + std::string(small[axis]), grammar, std::string(capital[axis]) + label, quantity, part, tooltip);
    }
  }

  /// A choice, shown by the words for its values, which count from 0.
  template <class Member>
  void choice(std::string id, std::string label, Member member, std::vector<std::string> choices, std::string tooltip) {
    Field field = described(std::move(id), std::move(label), FieldKind::choice, std::move(tooltip));
    field.choices = choices;
    Entry<Object>& entry = add(std::move(field), member);
    entry.switches = true;
    entry.text = [member, choices](const Object& object) {
      const auto chosen = static_cast<std::size_t>(std::invoke(member, object));
      return chosen < choices.size() ? choices[chosen] : std::to_string(static_cast<int>(chosen));
    };
    entry.set = [member, choices](Object& object, std::string_view text) {
      ChoiceReading reading = read_choice(choices, text);
      auto& value = std::invoke(member, object);
      if (reading.failure.empty()) value = static_cast<std::remove_reference_t<decltype(value)>>(reading.index);
      return reading.failure;
    };
  }

  /// A yes or no that is read and set by functions.
  template <class Get, class Put>
  void check_named(std::string id, std::string label, Get get, Put put, std::string tooltip) {
    Entry<Object> entry;
    entry.field = described(std::move(id), std::move(label), FieldKind::check, std::move(tooltip));
    entry.applies = applies_;
    entry.switches = true;
    entry.text = [get](const Object& object) { return std::string(get(object) ? "yes" : "no"); };
    entry.set = [put](Object& object, std::string_view text) {
      CheckReading reading = read_check(text);
      if (reading.failure.empty()) put(object, reading.value);
      return reading.failure;
    };
    entry.reset = [get, put](Object& object) { put(object, get(Object{})); };
    entries_.push_back(std::move(entry));
  }

  /// A yes or no.
  void check(std::string id, std::string label, bool Object::*member, std::string tooltip) {
    check_named(
        std::move(id), std::move(label), [member](const Object& object) { return object.*member; },
        [member](Object& object, bool value) { object.*member = value; }, std::move(tooltip));
  }

  /// A name: of the object itself, of a file, or of another object.
  void name(const script::Field& grammar, FieldKind kind, std::string label, std::string Object::*member,
            std::string tooltip) {
    Entry<Object>& entry =
        add(described(std::string(grammar.member), std::move(label), kind, std::move(tooltip)), member);
    entry.text = [member](const Object& object) { return object.*member; };
    entry.set = [member, words = grammar.words](Object& object, std::string_view text) {
      std::string failure = name_failure(words, text);
      if (failure.empty()) object.*member = text;
      return failure;
    };
  }

  /// A function: shown by its summary, edited elsewhere.
  template <class Member>
  void function(std::string id, std::string label, Member member, std::string tooltip) {
    Entry<Object>& entry =
        add(described(std::move(id), std::move(label), FieldKind::function, std::move(tooltip)), member);
    const auto summary = [member](const Object& object) {
      const auto& value = std::invoke(member, object);
      return function_summary(value.part.data(), value.part.size(), value.file);
    };
    entry.text = summary;
    entry.set = [summary](const Object& object, std::string_view text) {
      return text == summary(object) ? std::string() : std::string("a function is edited in the function editor");
    };
  }

  /// A field with means of its own.
  void special(Entry<Object> entry) {
    entry.field.group = group_;
    entry.field.rare = rare_;
    entry.applies = applies_;
    entries_.push_back(std::move(entry));
  }

  /// Called when a choice has changed: gives what becomes meaningful a beginning. The object as it was comes first.
  void on_switch(std::function<void(const Object&, Object&)> begin) { begin_ = std::move(begin); }

  /// All fields, in the order in which they were added.
  [[nodiscard]] std::vector<Field> fields() const {
    std::vector<Field> fields;
    for (const Entry<Object>& entry : entries_) fields.push_back(entry.field);
    return fields;
  }

  /// The field of an id; std::invalid_argument where there is none.
  [[nodiscard]] const Entry<Object>& entry(std::string_view id) const {
    for (const Entry<Object>& entry : entries_)
      if (entry.field.id == id) return entry;
    throw std::invalid_argument("there is no field '" + std::string(id) + "'");
  }

  /// Whether a field means something for the object as it is.
  [[nodiscard]] bool applies(const Object& object, std::string_view id) const {
    const Entry<Object>& found = entry(id);
    return !found.applies || found.applies(object);
  }
  [[nodiscard]] std::string text(const Object& object, std::string_view id) const { return entry(id).text(object); }

  /// Sets a field from a text; says why not, and leaves the object as it is, where it cannot.
  [[nodiscard]] std::string set(Object& object, std::string_view id, std::string_view text) const {
    const Entry<Object>& found = entry(id);
    const bool applies = !found.applies || found.applies(object);
    if (!found.switches && applies) return found.set(object, text);
    Object changed = object;
    if (std::string failure = found.set(changed, text); !failure.empty()) return failure;
    if (found.text(changed) == found.text(object)) return {};
    if (!applies) return found.field.label + " means nothing with what is chosen elsewhere; change that choice first";
    if (begin_) begin_(object, changed);
    reset_meaningless(changed);
    object = std::move(changed);
    return {};
  }

 private:
  static double& component(core::Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
  static const double& component(const core::Vec3& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  }
  static core::Angle& component(std::array<core::Angle, 3>& angles, std::size_t axis) { return angles[axis]; }
  static const core::Angle& component(const std::array<core::Angle, 3>& angles, std::size_t axis) {
    return angles[axis];
  }

  [[nodiscard]] Field described(std::string id, std::string label, FieldKind kind, std::string tooltip) const {
    Field field;
    field.id = std::move(id);
    field.label = std::move(label);
    field.group = group_;
    field.tooltip = std::move(tooltip);
    field.kind = kind;
    field.rare = rare_;
    return field;
  }

  template <class Member>
  Entry<Object>& add(Field field, Member member) {
    Entry<Object> entry;
    entry.field = std::move(field);
    entry.applies = applies_;
    entry.reset = [member](Object& object) {
      const Object initial{};
      std::invoke(member, object) = std::invoke(member, initial);
    };
    entries_.push_back(std::move(entry));
    return entries_.back();
  }

  template <class Member>
  void number_named(std::string id, const script::Field& grammar, std::string label, Quantity quantity, Member member,
                    std::string tooltip) {
    tooltip += limits_text(grammar, quantity);
    Field field = described(std::move(id), std::move(label), FieldKind::quantity, std::move(tooltip));
    field.quantity = quantity;
    Entry<Object>& entry = add(std::move(field), member);
    entry.text = [member, quantity](const Object& object) {
      return quantity_text(held(std::invoke(member, object)), quantity);
    };
    entry.set = [member, quantity, grammar](Object& object, std::string_view text) {
      NumberReading reading = read_number(grammar, quantity, text);
      if (reading.failure.empty()) hold(std::invoke(member, object), reading.value);
      return reading.failure;
    };
  }

  // A choice stands before what depends on it, so that one pass is enough.
  void reset_meaningless(Object& object) const {
    for (const Entry<Object>& entry : entries_)
      if (entry.applies && !entry.applies(object)) entry.reset(object);
  }

  std::vector<Entry<Object>> entries_;
  std::string group_;
  Applies applies_;
  bool rare_ = false;
  std::function<void(const Object&, Object&)> begin_;
};

/// A function that is `value` throughout, for one that has no points yet.
void begin_constant(core::SampledFunction& function, double value);

/// The tables, made at first use.
[[nodiscard]] const FieldTable<Platform>& platform_table();
[[nodiscard]] const FieldTable<Target>& target_table();
[[nodiscard]] const FieldTable<Surface>& surface_table();
[[nodiscard]] const FieldTable<Radar>& radar_table();
[[nodiscard]] const FieldTable<Simulation>& simulation_table();
[[nodiscard]] const FieldTable<GeometryTable>& geometry_table();
[[nodiscard]] const FieldTable<RunOptions>& options_table();

/// The second page of the radar's dialog: antennas, direction, filter window, STC.
void add_antenna_fields(FieldTable<Radar>& table);

}  // namespace sarsim::scene::field_tables
