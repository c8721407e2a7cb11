#include "scene/edit/path_edits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "scene/edit/path_points.hpp"
#include "scene/model/route.hpp"

namespace sarsim::scene {

namespace {

constexpr double usual_speed_mps = 10.0;
constexpr double usual_bank_deg = 20.0;
constexpr double straight_on_deg = 0.01;  // A smaller turn is none.

PathEdit refused(std::string why) { return {std::nullopt, 0, std::move(why)}; }

// With what makes it impossible to fly, if anything does.
PathEdit flown(Platform platform, std::size_t point) {
  const radar::PathResult made = route_of(platform);
  if (!made.fault.empty()) return refused(made.fault);
  return {std::move(platform), point, {}};
}

// The pair of neighbours between which a point makes the least detour; the index of the first.
std::size_t nearest_pair(const std::vector<core::Vec3>& points, const core::Vec3& at_m) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double detour =
        core::norm(points[i] - at_m) + core::norm(points[i + 1] - at_m) - core::norm(points[i + 1] - points[i]);
    if (detour < least) least = detour, best = i;
  }
  return best;
}

PathEdit with_leg_divided(Platform platform, std::size_t leg, const core::Vec3& from_m, const core::Vec3& to_m,
                          const core::Vec3& at_m) {
  if (leg >= platform.legs.size() || platform.legs[leg].kind != Leg::Kind::straight ||
      platform.legs[leg].acceleration_mps2 != 0.0)
    return refused("only a straight leg at one speed can be divided");
  const core::Vec3 way = to_m - from_m;
  const double part = std::clamp(core::dot(at_m - from_m, way) / std::max(core::dot(way, way), 1e-300), 0.01, 0.99);
  Leg first = platform.legs[leg];
  Leg second = first;
  double& whole = first.length_m != 0.0 ? first.length_m : first.duration_s;
  const double all = whole;
  const double step = std::pow(10.0, std::floor(std::log10(all * 1e-3)));
  whole = core::rounded_to(part * all, step);
  (second.length_m != 0.0 ? second.length_m : second.duration_s) = core::tidy(all - whole);
  platform.legs[leg] = first;
  platform.legs.insert(platform.legs.begin() + static_cast<std::ptrdiff_t>(leg) + 1, second);
  return flown(std::move(platform), leg + 1);
}

// The direction in which the last leg ends: that of a straight one behind it.
std::optional<core::Vec3> last_direction(Platform platform) {
  Leg straight;
  straight.length_m = 1.0;
  platform.legs.push_back(straight);
  const std::vector<core::Vec3> points = path_points(platform, {});
  if (points.size() != platform.legs.size() + 1) return std::nullopt;
  return points.back() - points[points.size() - 2];
}

// As the last turn of the path was flown.
Leg turn_like_before(const Platform& platform) {
  Leg turn;
  turn.kind = Leg::Kind::turn;
  for (const Leg& leg : platform.legs)
    if (leg.kind == Leg::Kind::turn || leg.kind == Leg::Kind::turn_to)
      turn.bank = leg.bank, turn.radius_m = leg.radius_m;
  if (turn.bank.deg() == 0.0 && turn.radius_m == 0.0) turn.bank = core::Angle::from_deg(usual_bank_deg);
  return turn;
}

PathEdit with_leg_behind(const Platform& platform, const core::Vec3& to_m, double resolution_m) {
  const auto direction = last_direction(platform);
  if (!direction) return refused("a leg of the path cannot be flown");
  const std::vector<core::Vec3> points = path_points(platform, {});
  const core::Vec3 way = to_m - points.back();
  const double length_m = std::hypot(way.x, way.y);
  if (!(length_m > resolution_m)) return refused("the place is where the path ends");
  Platform longer = platform;
  const double turn_rad = std::remainder(core::azimuth_rad(way) - core::azimuth_rad(*direction), 2.0 * core::pi);
  if (std::abs(turn_rad) * core::deg_per_rad > straight_on_deg) {
    Leg turn = turn_like_before(platform);
    turn.angle = core::Angle::from_deg(core::rounded_to(turn_rad * core::deg_per_rad, 0.1));
    longer.legs.push_back(turn);
  }
  Leg straight;
  straight.length_m = core::rounded_to(length_m, resolution_m);
  longer.legs.push_back(straight);
  const std::size_t point = longer.legs.size();
  auto fitted = with_path_point(longer, {}, point, to_m, resolution_m);
  return flown(fitted ? std::move(*fitted) : std::move(longer), point);
}

PathEdit with_waypoint_behind(Platform platform, const core::Vec3& to_m) {
  if (platform.path == Platform::Path::stationary) {
    platform.path = Platform::Path::waypoints;
    platform.waypoints = {{platform.position_m, 0.0}};
  }
  platform.waypoints.push_back({to_m, 0.0});
  if (platform.speed_mps == 0.0) platform.speed_mps = usual_speed_mps;
  if (platform.waypoints.size() > 2 && platform.bank.deg() == 0.0)
    platform.bank = core::Angle::from_deg(usual_bank_deg);
  const std::size_t point = platform.waypoints.size() - 1;
  return flown(std::move(platform), point);
}

}  // namespace

PathEdit with_point_between(const Platform& platform, const core::Vec3& at_m) {
  const std::vector<core::Vec3> points = path_points(platform, {});
  if (points.size() < 2) return refused("the path has no legs");
  const std::size_t first = nearest_pair(points, at_m);
  if (platform.path == Platform::Path::legs)
    return with_leg_divided(platform, first, points[first], points[first + 1], at_m);
  Platform more = platform;
  more.waypoints.insert(more.waypoints.begin() + static_cast<std::ptrdiff_t>(first) + 1, Waypoint{at_m, 0.0});
  if (more.bank.deg() == 0.0) more.bank = core::Angle::from_deg(usual_bank_deg);
  return flown(std::move(more), first + 1);
}

PathEdit with_point_behind(const Platform& platform, const core::Vec3& to_m, double resolution_m) {
  switch (platform.path) {
    case Platform::Path::legs: return with_leg_behind(platform, to_m, resolution_m);
    case Platform::Path::stationary:
    case Platform::Path::waypoints: return with_waypoint_behind(platform, to_m);
    case Platform::Path::trajectory:
    case Platform::Path::ephemeris:
    case Platform::Path::orbit:
    case Platform::Path::state:
    case Platform::Path::relative: break;
  }
  return refused("only platforms that rest, or go by waypoints or legs, take points by hand");
}

PathEdit without_path_point(const Platform& platform, std::size_t index) {
  if (platform.path == Platform::Path::state) return refused("a state stays; it can be moved");
  Platform less = platform;
  if (platform.path == Platform::Path::waypoints) {
    if (index >= less.waypoints.size()) return refused("the path has no such point");
    if (less.waypoints.size() <= 2) return refused("a path needs two waypoints");
    less.waypoints.erase(less.waypoints.begin() + static_cast<std::ptrdiff_t>(index));
    return flown(std::move(less), std::min(index, platform.waypoints.size() - 2));
  }
  if (platform.path != Platform::Path::legs || index > less.legs.size()) return refused("the path has no such point");
  if (index == 0) return refused("the start of a path stays; delete the end of a leg");
  if (less.legs.size() <= 1) return refused("a path needs a leg");
  less.legs.erase(less.legs.begin() + static_cast<std::ptrdiff_t>(index) - 1);
  return flown(std::move(less), std::min(index, less.legs.size()));
}

}  // namespace sarsim::scene
