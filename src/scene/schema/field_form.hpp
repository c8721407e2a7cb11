#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema/field_spec.hpp"

namespace sarsim::scene {

class LetNames;

/// What a field holds, and so how it is edited.
enum class FieldKind {
  quantity,  ///< A number with a unit.
  text,      ///< A name or file name.
  choice,    ///< One of `choices`.
  check,     ///< "yes" or "no".
  platform,  ///< The name of a platform of the scene.
  radar,     ///< The name of a radar of the scene.
  list,      ///< Legs, waypoints and the like; edited entry by entry (scene/schema/list_fields.hpp).
  function,  ///< A user-defined function; edited by the function editor (scene/edit/function_model.hpp).
};

/// One field of one kind of object: everything a panel needs to show and edit it.
struct Field {
  std::string id;       ///< Member of the scene structure, with ".x", ".deg"... below: "position_m.x", "pulse_width_s".
  std::string label;    ///< As the thesis's dialogs have it: "Pulse width".
  std::string group;    ///< "Pulse"; groups appear in the order of their first field.
  std::string tooltip;  ///< Meaning, formula and limits in a sentence or two.
  FieldKind kind = FieldKind::quantity;
  Quantity quantity = Quantity::number;
  std::vector<std::string> choices;  ///< FieldKind::choice, as shown.
  bool rare = false;                 ///< Shown a level down.
  const FieldSpec* spec = nullptr;   ///< The field that this is, or is a part of.
  std::size_t part = 0;              ///< Which part: of a vector 0 to 2, of flags their position.
};

}  // namespace sarsim::scene

/// Fields as forms show them: a vector as three, flags as one for each. Internal to fields.cpp and field_names.cpp.
namespace sarsim::scene::field_forms {

/// The fields of a form that stand for a field.
[[nodiscard]] std::vector<Field> form_fields(const FieldSpec& spec);

/// The number of one of the three fields that stand for a vector.
[[nodiscard]] double& component(core::Vec3& vector, std::size_t part);

/// The names that a form shows for the values of a choice, which count from 0.
[[nodiscard]] std::vector<std::string> shown_choices(const FieldSpec& spec);

/// Says that a text is none of the choices, named as its reader knows them, and which may be meant.
[[nodiscard]] std::string none_of(const FieldSpec& spec, std::string_view text,
                                  const std::vector<std::string>& choices);

/// The value of one of `form_fields` as text.
[[nodiscard]] std::string form_text(const FieldSpec& spec, const FieldValue& value, std::size_t part);
/// Whether two values are equal in what a form shows of them: of vectors, one component. Quicker than their texts, and
/// stricter: values that differ may have the same text.
[[nodiscard]] bool same_part(const FieldSpec& spec, const FieldValue& a, const FieldValue& b, std::size_t part);

/// Sets the value of one of `form_fields` from what was typed; says why not, and leaves it as it is, where it cannot.
/// @param names  of [let], for numbers that are expressions; null: they may not be
[[nodiscard]] std::string set_value(const FieldSpec& spec, FieldValue& value, std::size_t part, std::string_view text,
                                    const LetNames* names);

}  // namespace sarsim::scene::field_forms
