#include "scene/model/route.hpp"

#include <optional>
#include <vector>

#include "radar/motion/legs.hpp"
#include "radar/motion/waypoints.hpp"

namespace sarsim::scene {

namespace {

radar::TurnSize size_of(const Leg& leg) {
  radar::TurnSize size;
  if (leg.bank.deg() != 0.0) size.bank_rad = leg.bank.rad();
  if (leg.radius_m != 0.0) size.radius_m = leg.radius_m;
  return size;
}

std::optional<double> given(double value) { return value != 0.0 ? std::optional(value) : std::nullopt; }

radar::Leg leg_of(const Leg& leg) {
  const auto side = static_cast<radar::TurnSide>(leg.side);
  switch (leg.kind) {
    case Leg::Kind::straight: break;
    case Leg::Kind::turn: return radar::TurnLeg{leg.angle.rad(), std::nullopt, side, size_of(leg)};
    case Leg::Kind::turn_to: return radar::TurnLeg{std::nullopt, leg.heading.rad(), side, size_of(leg)};
    case Leg::Kind::climb: return radar::ClimbLeg{std::nullopt, leg.duration_s, leg.rate_mps, leg.rounding_mps2};
    case Leg::Kind::climb_to: return radar::ClimbLeg{leg.height_m, std::nullopt, leg.rate_mps, leg.rounding_mps2};
    case Leg::Kind::hold: return radar::HoldLeg{leg.duration_s, std::nullopt, radar::TurnSide::right};
    case Leg::Kind::circle: return radar::HoldLeg{leg.duration_s, size_of(leg), side};
  }
  return radar::StraightLeg{given(leg.duration_s), given(leg.length_m), leg.acceleration_mps2};
}

radar::PathResult legs_of(const Platform& platform) {
  std::vector<radar::Leg> legs;
  for (const Leg& leg : platform.legs) legs.push_back(leg_of(leg));
  return radar::leg_path({platform.start_s, platform.start_m, platform.course.rad(), platform.speed_mps}, legs);
}

radar::PathResult waypoints_of(const Platform& platform) {
  radar::WaypointRoute route{platform.start_s, {}, platform.speed_mps, platform.bank.rad(), platform.acceleration_mps2};
  for (const Waypoint& point : platform.waypoints)
    route.waypoints.push_back({point.position_m, given(point.speed_mps)});
  return radar::waypoint_path(route);
}

}  // namespace

radar::PathResult route_of(const Platform& platform) {
  return platform.path == Platform::Path::legs ? legs_of(platform) : waypoints_of(platform);
}

}  // namespace sarsim::scene
