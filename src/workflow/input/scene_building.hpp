#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/maths/sampled_function.hpp"
#include "scene/model/object_id.hpp"
#include "workflow/input/scene_input.hpp"

/// Scenes that programs put together, object by object (src/capi).
namespace sarsim::workflow {

/// A scene without objects, in format 2.
/// @param name  of a file that need not be there: files that the scene names are looked for beside it
[[nodiscard]] SceneInput empty_scene(const std::string& name);

/// Adds an object of a kind with the values that a new one has, at the end of its list.
/// @param name  of a platform or radar, or the file of a simulation or geometry table; empty: one that is free
/// @return its position
/// @throws core::InvalidRequest for a name that cannot be given
std::size_t add_object(SceneInput& input, scene::ObjectKind kind, const std::string& name);

/// Removes an object; with a platform goes what stands on it, with a radar what it records.
void remove_object(SceneInput& input, scene::ObjectId id);

/// Adds targets on a platform. Takes a time that does not grow with those that are there.
/// @param positions_m  x, y and z of each, in the platform's frame
/// @param rcs_m2       of each; empty: 1 m2
/// @throws core::InvalidRequest for numbers that cannot be computed with
void add_targets(SceneInput& input, const std::string& platform, std::span<const double> positions_m,
                 std::span<const double> rcs_m2);

/// Adds a cloud of such points.
/// @param file  that the scene's text names
void add_cloud(SceneInput& input, const std::string& platform, const std::string& file,
               std::span<const double> positions_m, std::span<const double> rcs_m2);

/// The number that a field holds, in the unit that `schema_json` names: SI, but degrees and decibels; of a yes or no 1
/// or 0. Throws core::InvalidRequest for a field that is not a number.
[[nodiscard]] double field_number(const SceneInput& input, const std::string& name);

/// Sets it; throws like `set_field_value`.
void set_field_number(SceneInput& input, const std::string& name, double value);

/// Sets a function that points give, such as a pulse, a pattern or a track, of all objects that the name means.
/// @param x  ascending; empty of lists, whose points have an order alone
/// @param y  as many values for each function of the field, one function after the other, in the unit that the field's
/// name ends in
/// @throws core::InvalidRequest for a field that is not a function, another number of functions, x that does not
/// ascend, and a field that does not apply
void set_field_points(SceneInput& input, const std::string& name, std::span<const double> x, std::span<const double> y,
                      std::size_t count, core::Interpolation method);

/// The fields of an object that apply, as a JSON array: name, id, value, number and unit.
[[nodiscard]] std::string fields_json(const SceneInput& input, scene::ObjectId id);
/// The same of the options of the scene.
[[nodiscard]] std::string option_fields_json(const SceneInput& input);
/// The same of the atmosphere.
[[nodiscard]] std::string atmosphere_fields_json(const SceneInput& input);

/// All fields of all kinds of objects as JSON, from which bindings of other languages are made.
[[nodiscard]] std::string schema_json();

}  // namespace sarsim::workflow
