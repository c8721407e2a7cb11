#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// A platform whose path has a point more or less, or why it cannot.
struct PathEdit {
  std::optional<Platform> platform;
  std::size_t point = 0;  ///< Of `path_points`: the new one, or the one that stands where one was removed.
  std::string refusal;    ///< "only a straight leg can be divided"; empty where there is a platform.
};

/// A point of a path's line becomes a point of the path: a waypoint between those about it, or the end of a straight
/// leg that is divided there.
/// @param at_m  on the line, or near it, in the path's frame
[[nodiscard]] PathEdit with_point_between(const Platform& platform, const core::Vec3& at_m);

/// The path goes on to a place: by another waypoint, or by a turn and a straight leg. A platform that stays where it is
/// leaves on waypoints, at 10 m/s where it has no speed.
/// @param to_m          in the path's frame
/// @param resolution_m  as of `with_path_point`
[[nodiscard]] PathEdit with_point_behind(const Platform& platform, const core::Vec3& to_m, double resolution_m);

/// The path without a waypoint, or without the leg that ends at a point; the legs behind are carried along.
[[nodiscard]] PathEdit without_path_point(const Platform& platform, std::size_t index);

}  // namespace sarsim::scene
