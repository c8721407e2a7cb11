#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "scene/schema/fields.hpp"
#include "scene/schema/function_block.hpp"

namespace sarsim::scene {

/// A field that was named in words: one field of one or several objects of a kind, of the atmosphere or of the options.
struct NamedField {
  std::vector<ObjectId> objects;  ///< Of one kind; empty: the field is of the atmosphere or the options.
  const Field* field =
      nullptr;                 ///< An element of `fields_of`, `atmosphere_fields` or `option_fields`; null: not found.
  std::string failure;         ///< Why not, in words: "Radar1 has no field 'bandwith'; did you mean bandwidth?".
  bool of_atmosphere = false;  ///< Of a field without objects; else it is one of `option_fields`.
};

/// Finds the field that a name such as "Radar1.bandwidth", "Target3.position.x", "Simulation*.bits" or "seed" means.
///
/// An object is called by its name (platforms and radars), by its output file (simulations and geometry tables), or by
/// its kind and number in the script, from 1 ("Target3", "Recording1"); a kind alone is the only object of that kind,
/// and with a star all of them. A field is called by its id, by its id without units ("bandwidth" for "bandwidth_hz",
/// "corner2.x"), by its path in format 2 ("pulse.bandwidth"), by its label in the workbench, or, for the position of a
/// platform or target, by "x", "y" or "z". Capitals, blanks and underscores do not matter. Words without an object are
/// options. "Atmosphere.rain.rate" is a field of the atmosphere. Those of the world have no name: the places in a text
/// are read with them.
///
/// @param value  that is to be set; tells the number "carrier" (Hz) from the kind of carrier of the same name
[[nodiscard]] NamedField find_named_field(const Scene& scene, std::string_view name, std::string_view value = {});

/// The shortest name of a field that `find_named_field` understands for any value.
[[nodiscard]] std::string short_name(const std::vector<Field>& fields, const Field& field);

/// What precedes the point in the shortest name of an object's fields: a platform's or radar's name where it has one
/// that no other object has and that holds neither blanks nor '=', else its kind and number.
[[nodiscard]] std::string address_of(const Scene& scene, ObjectId id);

/// The points of a data file for each function of a block, or why there are none, in words.
struct NamedPoints {
  std::vector<std::vector<core::Knot>> functions;
  std::string failure;
};

/// Reads the data file of a name, as a script gives it.
using PointsLoader = std::function<NamedPoints(const std::string& name, const FunctionBlock& block)>;

/// Sets the field of every one of its objects as `set_field` does; words of both languages are taken for choices,
/// too ("MATCHED_FILTER", "matched-filter"). Of a user-defined function the text is the name of a data file; its method
/// of interpolation stays.
/// @param load  reads data files; without it functions cannot be set
/// @returns empty, or why not, in words; the scene is then half changed where several objects are concerned
[[nodiscard]] std::string set_named_field(Scene& scene, const NamedField& named, std::string_view text,
                                          const PointsLoader& load = {});

/// The value as text, of the first object.
[[nodiscard]] std::string named_field_text(const Scene& scene, const NamedField& named);

}  // namespace sarsim::scene
