#pragma once

#include <optional>
#include <vector>

#include "scene/edit/edit.hpp"

namespace sarsim::scene {

/// An object that stayed where it is in its list and was replaced, and which of its members that others go by differ.
struct ChangedObject {
  ObjectId id;
  bool name = false;     ///< Others refer to it by another name.
  bool carrier = false;  ///< It refers to a platform or radar by another name.

  friend bool operator==(const ChangedObject&, const ChangedObject&) = default;
};

/// What became of a scene, for those who show it: enough to look again at what changed only. Says nothing of the text
/// of a script; one that changed alone is an empty change.
struct SceneChange {
  bool everything = false;             ///< Another scene in place of the one before; the rest is empty then.
  bool options = false;                ///< The run options are others.
  std::vector<ObjectId> removed;       ///< As they were numbered before; ascending.
  std::vector<ObjectId> inserted;      ///< As they are numbered now; ascending.
  std::vector<ChangedObject> changed;  ///< As they are numbered now; ascending, each once.

  /// True where the scene is the same.
  [[nodiscard]] bool empty() const { return same_objects() && changed.empty() && !options; }
  /// True where every id means the object that it meant before.
  [[nodiscard]] bool same_objects() const { return !everything && removed.empty() && inserted.empty(); }
  /// True where objects of a kind came, went or changed.
  [[nodiscard]] bool concerns(ObjectKind kind) const;
  /// True where an object, as it is numbered now, came or changed.
  [[nodiscard]] bool concerns(ObjectId id) const;
  /// Where an object is now that was there before; nothing where it was removed, or is not known.
  [[nodiscard]] std::optional<ObjectId> moved(ObjectId before) const;
  /// True where names may mean other platforms or radars than before, or where an object refers to others.
  [[nodiscard]] bool concerns_names() const;

  friend bool operator==(const SceneChange&, const SceneChange&) = default;
};

/// True where each object is the one that it was before an edit, or before undoing it: `SceneChange::same_objects`
/// without looking at the objects.
[[nodiscard]] bool keeps_objects(const Edit& edit);

/// What an edit did to a scene, or undoing it. An edit that came to nothing changed the objects that it names: who
/// shows what was asked for has to go back.
///
/// @param forwards  the edit was applied, rather than reverted
/// @throws std::logic_error for a change that neither takes nor gives an object
[[nodiscard]] SceneChange change_of(const Edit& edit, bool forwards = true);

}  // namespace sarsim::scene
