#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/object.hpp"
#include "scene/model/scene.hpp"
#include "scene/schema/field_form.hpp"

namespace sarsim::scene {

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
