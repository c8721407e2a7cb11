#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/maths/vector.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The points by which a hand can change a platform's path, in the path's frame: of legs the start and where each leg
/// ends, up to the first leg that cannot be flown; of waypoints all of them; of an orbit by its state the position and
/// where its velocity would lead straight on in `state_arrow_s`, none over a flat world. None of other paths.
[[nodiscard]] std::vector<core::Vec3> path_points(const Platform& platform, const World& world);

/// How long the arrow of the velocity of Path::state is: long enough to be taken hold of where the Earth is in view.
inline constexpr double state_arrow_s = 60.0;

/// What a point of `path_points` is called: "start", "end of leg 2", "waypoint 3", "velocity".
[[nodiscard]] std::string path_point_name(const Platform& platform, std::size_t index);

/// The platform with a point of its path moved. A start or a waypoint is put there. A leg is changed so that it ends as
/// near to the place as it can: a straight leg or a climb in its extent and in the direction of the turn before it (of
/// the first leg: the course), a climb also in its rate, a turn in its angle, a hold in its duration. The legs behind
/// it keep what they say, and so are carried along. A satellite is put there, and its velocity turns with it as the
/// ground below does, so that it climbs as before; the end of the velocity changes the velocity alone.
///
/// @param to_m          in the path's frame
/// @param resolution_m  to which lengths are rounded, and what else is changed accordingly; positive
/// @return nothing where the platform has no such point, or its legs cannot be flown so
[[nodiscard]] std::optional<Platform> with_path_point(const Platform& platform, const World& world, std::size_t index,
                                                      const core::Vec3& to_m, double resolution_m);

}  // namespace sarsim::scene
