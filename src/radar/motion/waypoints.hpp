#pragma once

#include <optional>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/motion/segment_path.hpp"

namespace sarsim::radar {

/// A point of a route and how to go on from it.
struct Waypoint {
  core::Vec3 position_world_m;
  std::optional<double> speed_mps;  ///< Level speed of the leg from here on; not given: as before.
};

/// A route through points.
struct WaypointRoute {
  double start_s = 0.0;  ///< When it leaves the first point.
  std::vector<Waypoint> waypoints;
  double speed_mps = 0.0;          ///< Level speed from the first point on, where that gives none.
  double bank_rad = 0.0;           ///< Of the turns at the points between, between 0 and 90 degrees.
  double acceleration_mps2 = 0.0;  ///< Of the speed behind a turn, where a leg is flown faster or slower; 0: it steps.
};

/// The path of a route: straight from point to point, past every point between the ends (fly-by) on an arc that is
/// tangent to both legs, of radius v^2/(g tan bank), v the speed of the leg before. Closed form.
///
/// The height is linear in the length of the way, seen from above, from point to point; at a point between it is
/// reached in the middle of the arc. There the vertical speed steps where the legs rise differently. Before the first
/// point and after the last one the path goes straight on, rising as its first or last leg.
///
/// The fault names what does not fit: the waypoint or the leg, how long the leg must be and how long it is.
[[nodiscard]] PathResult waypoint_path(const WaypointRoute& route);

}  // namespace sarsim::radar
