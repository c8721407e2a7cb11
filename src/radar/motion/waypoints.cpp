#include "radar/motion/waypoints.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "core/text/number_text.hpp"
#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

// A leg of the route, seen from above.
struct RouteLeg {
  double heading_rad = 0.0;
  double length_m = 0.0;
  double speed_mps = 0.0;
};

// The turn at a waypoint; none at the first and the last one.
struct Corner {
  double angle_rad = 0.0;  // clockwise positive
  double radius_m = 0.0;
  double tangent_m = 0.0;  // from where the arc starts to the waypoint

  [[nodiscard]] double arc_m() const { return radius_m * std::abs(angle_rad); }
};

// What is wrong with a route, and at which waypoint.
struct RouteFault {
  std::string text;
  std::optional<std::size_t> at = {};
};

std::string metres(double length_m) { return core::with_prefix(length_m, "m", 6); }
std::string waypoint_name(std::size_t i) { return "waypoint " + std::to_string(i + 1); }
std::string leg_name(std::size_t i) {
  return "the leg from waypoint " + std::to_string(i + 1) + " to " + std::to_string(i + 2);
}

bool finite_point(const core::Vec3& p) { return std::isfinite(p.x + p.y + p.z); }

RouteFault fault_of_numbers(const WaypointRoute& route) {
  if (route.waypoints.size() < 2) return {"a route needs at least two waypoints"};
  if (!std::isfinite(route.start_s + route.speed_mps + route.bank_rad + route.acceleration_mps2))
    return {"a number is not finite"};
  if (route.acceleration_mps2 < 0.0) return {"the acceleration is negative"};
  const bool turns = route.waypoints.size() > 2;
  if (turns && route.bank_rad == 0.0) return {"the bank is 0"};
  if (turns && !(route.bank_rad > 0.0 && route.bank_rad < core::pi / 2.0))
    return {"the bank is not between 0 and 90 degrees"};
  for (std::size_t i = 0; i < route.waypoints.size(); ++i)
    if (!finite_point(route.waypoints[i].position_world_m)) return {waypoint_name(i) + ": a number is not finite", i};
  return {};
}

std::vector<RouteLeg> route_legs(const WaypointRoute& route) {
  std::vector<RouteLeg> legs;
  double speed = route.speed_mps;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    speed = route.waypoints[i].speed_mps.value_or(speed);
    const core::Vec3 way = route.waypoints[i + 1].position_world_m - route.waypoints[i].position_world_m;
    legs.push_back({core::azimuth_rad(way), std::hypot(way.x, way.y), speed});
  }
  return legs;
}

RouteFault fault_of_legs(const std::vector<RouteLeg>& legs) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!(legs[i].length_m > 0.0)) return {leg_name(i) + " has no length, seen from above", i + 1};
    if (!std::isfinite(legs[i].length_m)) return {leg_name(i) + " is too long for a number", i + 1};
    if (!(legs[i].speed_mps > 0.0 && std::isfinite(legs[i].speed_mps)))
      return {waypoint_name(i) + ": the speed is not positive", i};
  }
  return {};
}

std::vector<Corner> corners_of(const std::vector<RouteLeg>& legs, double bank_rad) {
  std::vector<Corner> corners(legs.size() + 1);
  for (std::size_t i = 1; i < legs.size(); ++i) {
    Corner& corner = corners[i];
    corner.angle_rad = half_turn_angle_rad(legs[i].heading_rad - legs[i - 1].heading_rad);
    if (corner.angle_rad == 0.0) continue;
    corner.radius_m = turn_radius_m(legs[i - 1].speed_mps, bank_rad);
    corner.tangent_m = corner.radius_m * std::tan(0.5 * std::abs(corner.angle_rad));
  }
  return corners;
}

// The length in which leg i comes to its speed.
double change_m(const std::vector<RouteLeg>& legs, std::size_t i, double acceleration_mps2) {
  if (i == 0 || acceleration_mps2 <= 0.0) return 0.0;
  const double v0 = legs[i - 1].speed_mps;
  const double v1 = legs[i].speed_mps;
  return std::abs(v1 * v1 - v0 * v0) / (2.0 * acceleration_mps2);
}

std::string needs_of(const std::vector<Corner>& corners, std::size_t i, double change) {
  std::string text;
  if (corners[i].tangent_m > 0.0)
    text += "; the turn at " + waypoint_name(i) + " takes " + metres(corners[i].tangent_m);
  if (change > 0.0) text += "; the change of speed takes " + metres(change);
  if (corners[i + 1].tangent_m > 0.0)
    text += "; the turn at " + waypoint_name(i + 1) + " takes " + metres(corners[i + 1].tangent_m);
  return text;
}

RouteFault fault_of_fit(const std::vector<RouteLeg>& legs, const std::vector<Corner>& corners, double acceleration) {
  constexpr double half_turn_rad = core::pi - 1e-6;
  for (std::size_t i = 1; i < legs.size(); ++i)
    if (std::abs(corners[i].angle_rad) > half_turn_rad)
      return {waypoint_name(i) + ": the route turns back on itself", i};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double change = change_m(legs, i, acceleration);
    const double needed = corners[i].tangent_m + change + corners[i + 1].tangent_m;
    if (needed > legs[i].length_m * (1.0 + 1e-12))
      return {leg_name(i) + " must be " + metres(needed) + " long and is " + metres(legs[i].length_m) +
                  needs_of(corners, i, change),
              i + 1};
  }
  return {};
}

// Lays segments one after another.
class Layer {
 public:
  Layer(const core::Vec3& position_world_m, double heading_rad) {
    now_.position_world_m = position_world_m;
    now_.heading_rad = heading_rad;
  }

  // Half of a corner's arc.
  void arc(const Corner& corner, double speed_mps, double gradient) {
    if (corner.tangent_m <= 0.0) return;
    const double rate = std::copysign(speed_mps / corner.radius_m, corner.angle_rad);
    add(0.5 * corner.arc_m() / speed_mps, speed_mps, gradient, 0.0, rate);
  }

  void straight(double length_m, double speed_mps, double gradient) {
    if (length_m > 0.0) add(length_m / speed_mps, speed_mps, gradient, 0.0, 0.0);
  }

  void change(double from_mps, double to_mps, double acceleration_mps2, double gradient) {
    if (from_mps == to_mps || acceleration_mps2 <= 0.0) return;
    const double acceleration = std::copysign(acceleration_mps2, to_mps - from_mps);
    add((to_mps - from_mps) / acceleration, from_mps, gradient, acceleration, 0.0);
  }

  void face(double heading_rad) { now_.heading_rad = heading_rad; }

  [[nodiscard]] std::vector<PathSegment> done() && { return std::move(segments_); }

 private:
  void add(double duration_s, double speed_mps, double gradient, double acceleration_mps2, double turn_rate) {
    now_.duration_s = duration_s;
    now_.speed_mps = speed_mps;
    now_.acceleration_mps2 = acceleration_mps2;
    now_.turn_rate_rad_per_s = turn_rate;
    now_.climb_mps = gradient * speed_mps;
    now_.climb_acceleration_mps2 = gradient * acceleration_mps2;
    segments_.push_back(now_);
    now_ = after(now_);
  }

  PathSegment now_;
  std::vector<PathSegment> segments_;
};

// Leg i from the middle of one arc to the middle of the next.
void lay_leg(Layer& layer, const std::vector<RouteLeg>& legs, const std::vector<Corner>& corners, std::size_t i,
             double rise_m, double acceleration) {
  const RouteLeg& leg = legs[i];
  const double before_mps = i == 0 ? leg.speed_mps : legs[i - 1].speed_mps;
  const double straight = leg.length_m - corners[i].tangent_m - corners[i + 1].tangent_m;
  const double gradient = rise_m / (0.5 * corners[i].arc_m() + straight + 0.5 * corners[i + 1].arc_m());
  layer.arc(corners[i], before_mps, gradient);
  layer.face(leg.heading_rad);
  layer.change(before_mps, leg.speed_mps, acceleration, gradient);
  layer.straight(straight - change_m(legs, i, acceleration), leg.speed_mps, gradient);
  layer.arc(corners[i + 1], leg.speed_mps, gradient);
}

}  // namespace

PathResult waypoint_path(const WaypointRoute& route) {
  const auto fault_made = [](RouteFault& fault) { return PathResult{{}, std::move(fault.text), fault.at, {}}; };
  if (RouteFault fault = fault_of_numbers(route); !fault.text.empty()) return fault_made(fault);
  const std::vector<RouteLeg> legs = route_legs(route);
  if (RouteFault fault = fault_of_legs(legs); !fault.text.empty()) return fault_made(fault);
  const std::vector<Corner> corners = corners_of(legs, route.bank_rad);
  if (RouteFault fault = fault_of_fit(legs, corners, route.acceleration_mps2); !fault.text.empty())
    return fault_made(fault);
  Layer layer(route.waypoints.front().position_world_m, legs.front().heading_rad);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double rise = route.waypoints[i + 1].position_world_m.z - route.waypoints[i].position_world_m.z;
    lay_leg(layer, legs, corners, i, rise, route.acceleration_mps2);
  }
  return {SegmentPath(route.start_s, std::move(layer).done()), {}};
}

}  // namespace sarsim::radar
