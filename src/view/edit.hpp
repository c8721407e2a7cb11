#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/object.hpp"

namespace sarsim {

/// One object put in place of another: before without value inserts at `id`, after without value removes.
struct ObjectChange {
  ObjectId id;
  std::optional<AnyObject> before;
  std::optional<AnyObject> after;
};

/// One step of editing, as the user sees it: it can be undone and redone as a whole. Holds the changed objects only, so
/// that a long history of a large scene stays small.
struct Edit {
  std::string label;  ///< For the menu: "Move target".
  std::vector<ObjectChange> changes;
  std::optional<RunOptions> options_before;  ///< Both or neither.
  std::optional<RunOptions> options_after;
  /// Edits in a row with the same key, not empty, are one step: the runs of a spin box, the moves of a drag. A key ends
  /// with `History::end_run`.
  std::string merge_key;
};

/// Applies an edit to a scene, changes in order; `revert` undoes it, in reverse order.
/// @throws std::logic_error where the scene is not the one that the edit was made for.
void apply(const Edit& edit, Scene& scene);
void revert(const Edit& edit, Scene& scene);

/// Where an id is after an edit; nothing where the edit removed it. `forwards` false: after reverting.
[[nodiscard]] std::optional<ObjectId> moved(ObjectId id, const Edit& edit, bool forwards = true);

/// Makers of edits. Each returns an edit for the scene as it is; names that others refer to are followed.
/// @{
[[nodiscard]] Edit replace_object(const Scene& scene, ObjectId id, AnyObject with, std::string label,
                                  std::string merge_key = "");
/// Appends an object; platforms and radars get a name that is free ("Platform2").
[[nodiscard]] Edit add_object(const Scene& scene, AnyObject object);
/// Removes objects; with a platform goes everything that stands on it, with a radar its simulations and tables.
[[nodiscard]] Edit remove_objects(const Scene& scene, std::vector<ObjectId> ids);
/// Appends copies; copies of platforms and radars get free names, and what stands on a copied platform is copied with
/// it.
[[nodiscard]] Edit duplicate_objects(const Scene& scene, const std::vector<ObjectId>& ids);
/// Renames a platform or radar and re-points whatever refers to it.
[[nodiscard]] Edit rename_object(const Scene& scene, ObjectId id, const std::string& name);
/// Puts targets, surfaces and radars onto another platform; their coordinates stay as they are.
[[nodiscard]] Edit carry_objects(const Scene& scene, const std::vector<ObjectId>& ids, const std::string& platform);
/// Appends many targets at once.
[[nodiscard]] Edit add_targets(const Scene& scene, std::vector<Target> targets);
[[nodiscard]] Edit change_options(const Scene& scene, RunOptions options);
/// Whatever it takes from one scene to another, for changes that came from the script text.
[[nodiscard]] Edit difference(const Scene& from, const Scene& to, std::string label);
/// @}

}  // namespace sarsim
