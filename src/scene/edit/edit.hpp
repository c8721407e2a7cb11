#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/edit/text_change.hpp"
#include "scene/model/object.hpp"
#include "scene/model/shared_object.hpp"
#include "scene/schema/fields.hpp"

namespace sarsim::scene {

/// One object put in place of another: before without value inserts at `id`, after without value removes.
struct ObjectChange {
  ObjectId id;
  SharedObject before;
  SharedObject after;
};

/// What a text of format 2 is to say of a field that was typed into.
struct TypedText {
  std::optional<ObjectId> object;  ///< Nothing: of the options.
  const Field* field = nullptr;    ///< Of `fields_of` or `option_fields`.
  std::string text = {};           ///< `text_as_typed`; empty: what the writer says, which at the default is nothing.
};

/// What a step of editing does to the script text of a document.
struct ScriptChange {
  TextChanges changes;
  std::map<std::string, TextChanges> included = {};  ///< Of files that the text includes, by their names.
  bool broken_before = false;                        ///< The text before, or after, could not be read.
  bool broken_after = false;
};

/// One step of editing, as the user sees it: it can be undone and redone as a whole. Holds the changed objects only, so
/// that a long history of a large scene stays small.
struct Edit {
  std::string label;  ///< For the menu: "Move target".
  std::vector<ObjectChange> changes;
  std::optional<RunOptions> options_before;  ///< Both or neither.
  std::optional<RunOptions> options_after;
  std::optional<World> world_before;  ///< Both or neither.
  std::optional<World> world_after;
  std::optional<Atmosphere> air_before;  ///< Both or neither.
  std::optional<Atmosphere> air_after;
  std::vector<TypedText> typed;  ///< Of objects that it replaces, and of the options.
  ScriptChange script;           ///< Filled in by Document.
  /// Edits in a row with the same key, not empty, are one step: the runs of a spin box, the moves of a drag. A key ends
  /// with `History::end_run`.
  std::string merge_key;
};

/// Applies an edit to a scene, changes in order; `revert` undoes it, in reverse order. Takes time linear in the scene
/// and the edit where removals come in descending order of their index and insertions in ascending order.
/// @throws std::logic_error where the scene is not the one that the edit was made for; the scene is then unchanged
void apply(const Edit& edit, Scene& scene);
void revert(const Edit& edit, Scene& scene);

/// True where applying the edit would leave scene and text as they are.
[[nodiscard]] bool changes_nothing(const Edit& edit);

/// Removes objects and what goes with them, as `remove_objects` does, without keeping anything of them.
/// @throws std::out_of_range for an id that the scene does not have; the scene is then unchanged
void erase_objects(Scene& scene, const std::vector<ObjectId>& ids);

/// What two edits, one after the other, come to. An object that both replace is in it once.
[[nodiscard]] Edit composed(Edit first, const Edit& second);

/// Where an id is after an edit; nothing where the edit removed it. `forwards` false: after reverting.
[[nodiscard]] std::optional<ObjectId> moved(ObjectId id, const Edit& edit, bool forwards = true);
/// Where many ids are, without those that the edit removed; in time linear in them for each run of changes to a list.
[[nodiscard]] std::set<ObjectId> moved(const std::set<ObjectId>& ids, const Edit& edit, bool forwards = true);

/// Why an object of the scene cannot be given a name, in words for people: it is empty, holds characters that no script
/// can, or another object of its kind has it. Empty where it can.
[[nodiscard]] std::string name_objection(const Scene& scene, ObjectId id, const std::string& name);

/// Makers of edits. Each returns an edit for the scene as it is, faulty or not. Whatever an edit does to names, what an
/// object refers to by a name stays the same: references are rewritten where a new name would draw them away, and the
/// new name of a renamed platform or radar is given to whatever refers to it, also by the beginning of its name. A name
/// that another platform or radar has already gets a number at its end ("Ship2"). std::out_of_range for an id that the
/// scene does not have.
/// @{
/// std::invalid_argument for an object of another kind.
[[nodiscard]] Edit replace_object(const Scene& scene, ObjectId id, AnyObject with, std::string label,
                                  std::string merge_key = "");
/// Appends an object; platforms and radars get a name that is free ("Platform2"), recordings a file.
[[nodiscard]] Edit add_object(const Scene& scene, AnyObject object);
/// Removes objects; with a platform goes everything that stands on it, with a radar its simulations and tables.
[[nodiscard]] Edit remove_objects(const Scene& scene, std::vector<ObjectId> ids);
/// Appends copies; copies of platforms and radars get free names, and what stands on a copied platform is copied with
/// it. Copies of things that belong together belong to each other.
[[nodiscard]] Edit duplicate_objects(const Scene& scene, const std::vector<ObjectId>& ids);
/// Renames a platform or radar and re-points whatever refers to it; std::invalid_argument for another kind.
[[nodiscard]] Edit rename_object(const Scene& scene, ObjectId id, const std::string& name);
/// Puts targets, surfaces and radars onto another platform; their coordinates stay as they are. Objects of other kinds
/// are passed over.
[[nodiscard]] Edit carry_objects(const Scene& scene, const std::vector<ObjectId>& ids, const std::string& platform);
/// Appends many targets at once.
[[nodiscard]] Edit add_targets(const Scene& scene, std::vector<Target> targets);
[[nodiscard]] Edit change_options(const Scene& scene, RunOptions options);
/// For a scene of format 2: the language of 1998 knows no atmosphere.
[[nodiscard]] Edit change_atmosphere(const Scene& scene, Atmosphere atmosphere);
/// The same of the world. What the text places by latitude and longitude stays there on the Earth: its positions in the
/// scene follow when a document performs the edit.
[[nodiscard]] Edit change_world(const Scene& scene, World world);
/// Whatever it takes from one scene to another, for changes that came from the script text: the fewest objects
/// replaced, added and removed, as long as finding them is quick; names are not followed.
[[nodiscard]] Edit difference(const Scene& from, const Scene& to, std::string label);
/// @}

}  // namespace sarsim::scene
