#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/kinds.hpp"

namespace sarsim::scene {

[[nodiscard]] inline ObjectKind kind_of(const AnyObject& object) { return static_cast<ObjectKind>(object.index()); }

/// "platform", "target", ... as in Subject::kind (core/report/problem.hpp).
[[nodiscard]] std::string_view name_of(ObjectKind kind);
/// The kind of that name, ignoring case; nothing for another word.
[[nodiscard]] std::optional<ObjectKind> kind_called(std::string_view word);

/// Number of objects of a kind.
[[nodiscard]] std::size_t count_of(const Scene& scene, ObjectKind kind);

/// True where the scene has this object.
[[nodiscard]] bool has_object(const Scene& scene, ObjectId id);

/// A copy of an object; throws std::out_of_range where there is none.
[[nodiscard]] AnyObject object_of(const Scene& scene, ObjectId id);

/// What a list calls an object: a platform's or radar's name; "Target 3 (0, 0, 10) m"; "Surface 1"; the file of a
/// simulation or geometry table.
[[nodiscard]] std::string label_of(const Scene& scene, ObjectId id);

/// Name of the platform that carries a target, surface or radar; the radar of a simulation or geometry table; empty for
/// a platform.
[[nodiscard]] std::string carrier_of(const Scene& scene, ObjectId id);

/// The objects that stand on a platform: those whose name means it (`find_platform`), in order of kind and index. For
/// index `not_found` those that stand on the world itself, because no platform has their name.
[[nodiscard]] std::vector<ObjectId> objects_on(const Scene& scene, std::size_t platform);

}  // namespace sarsim::scene
