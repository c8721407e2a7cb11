#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"
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

/// The fields of a kind of object, in the order of the thesis's dialogs (4.2 to 4.5, 4.10).
[[nodiscard]] const std::vector<Field>& fields_of(ObjectKind kind);
/// The fields of `[world]`.
[[nodiscard]] const std::vector<Field>& world_fields();
/// The fields of `[atmosphere]`.
[[nodiscard]] const std::vector<Field>& atmosphere_fields();
/// The fields of `$OPTIONS`.
[[nodiscard]] const std::vector<Field>& option_fields();

/// The field at which a problem is shown: the one that `Problem::subject.field` names, or the first of its components
/// ("position_m" is shown at "position_m.x"); empty where the problem is about the whole object.
[[nodiscard]] std::string_view field_of_problem(ObjectKind kind, std::string_view problem_field);
[[nodiscard]] std::string_view option_field_of_problem(std::string_view problem_field);

/// The functions below throw std::invalid_argument for an id that is none of the object's fields.

/// Whether a field means something for an object as it is: the bandwidth of a chirp but not of a monochrome pulse.
[[nodiscard]] bool field_applies(const AnyObject& object, std::string_view id);
[[nodiscard]] bool field_applies(const Atmosphere& atmosphere, std::string_view id);
[[nodiscard]] bool field_applies(const World& world, std::string_view id);
/// The same for an object of a scene, which is not copied; std::out_of_range where the scene has none there.
[[nodiscard]] bool field_applies(const Scene& scene, ObjectId object, std::string_view id);

/// The same for all objects of a kind in a scene; true where there is none.
[[nodiscard]] bool field_applies(const Scene& scene, ObjectKind kind, std::string_view id);

/// The value as text: numbers with a unit, the shown name of a choice, "yes"/"no", a name; for functions a summary
/// ("3 points, cubic" or the file's name).
[[nodiscard]] std::string field_text(const AnyObject& object, std::string_view id);
[[nodiscard]] std::string field_text(const RunOptions& options, std::string_view id);
[[nodiscard]] std::string field_text(const Atmosphere& atmosphere, std::string_view id);
[[nodiscard]] std::string field_text(const World& world, std::string_view id);
/// What all objects of a kind in a scene show; nothing where they differ and where there is none.
[[nodiscard]] std::optional<std::string> common_field_text(const Scene& scene, ObjectKind kind, std::string_view id);

/// Sets a field from what was typed. Choosing another alternative gives the members that become meaningless their
/// initial values, as the script writer wants it, and a user-defined function that becomes meaningful one point to
/// begin with. Choices are matched without regard to case, by their whole name or a beginning that only one has. What a
/// script cannot say is refused; what only `check` judges is taken, so that an object can be half-typed. A function
/// takes only the text that it shows.
/// @param names  those of [let]: numbers may then be expressions, as in a text of format 2; null: they may not
/// @returns empty, or why not, in words; the object is then unchanged
[[nodiscard]] std::string set_field(AnyObject& object, std::string_view id, std::string_view text,
                                    const LetNames* names = nullptr);
[[nodiscard]] std::string set_field(RunOptions& options, std::string_view id, std::string_view text,
                                    const LetNames* names = nullptr);
[[nodiscard]] std::string set_field(Atmosphere& atmosphere, std::string_view id, std::string_view text,
                                    const LetNames* names = nullptr);
[[nodiscard]] std::string set_field(World& world, std::string_view id, std::string_view text,
                                    const LetNames* names = nullptr);

/// Gives a field the value that a new object has, also one that `set_field` refuses; of flags all of them.
void reset_field(AnyObject& object, std::string_view id);
void reset_field(RunOptions& options, std::string_view id);
void reset_field(Atmosphere& atmosphere, std::string_view id);
void reset_field(World& world, std::string_view id);

}  // namespace sarsim::scene
