#include "radar/motion/legs.hpp"

#include <algorithm>
#include <cmath>

#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

using Segments = std::vector<PathSegment>;

struct LegMade {
  Segments segments;
  std::string fault;
  std::optional<SlowClimb> slow = {};
};

LegMade fault_of_leg(std::string text) { return {{}, std::move(text)}; }

bool given_and_not_finite(const std::optional<double>& number) { return number && !std::isfinite(*number); }

std::string fault_of_one(const std::optional<double>& a, const std::optional<double>& b, const char* names) {
  if (given_and_not_finite(a) || given_and_not_finite(b)) return "a number is not finite";
  if (a.has_value() == b.has_value()) return std::string(a ? "both " : "neither ") + names + " given";
  return {};
}

std::string fault_of_size(const TurnSize& size) {
  if (std::string fault =
          fault_of_one(size.bank_rad, size.radius_m, size.bank_rad ? "bank and radius are" : "bank nor radius is");
      !fault.empty())
    return fault;
  if (size.bank_rad && *size.bank_rad == 0.0) return "the bank is 0";
  if (size.bank_rad && (*size.bank_rad < 0.0 || *size.bank_rad >= core::pi / 2.0))
    return "the bank is not between 0 and 90 degrees";
  if (size.radius_m && *size.radius_m <= 0.0) return "the radius is not positive";
  return {};
}

double radius_of(const TurnSize& size, double speed_mps) {
  return size.radius_m ? *size.radius_m : turn_radius_m(speed_mps, *size.bank_rad);
}

// The time in which `length` is covered; nothing where the speed comes to 0 before.
std::optional<double> time_of_length(double length, double speed, double acceleration) {
  const double end_speed_2 = speed * speed + 2.0 * acceleration * length;
  if (end_speed_2 < 0.0) return std::nullopt;
  const double sum = speed + std::sqrt(end_speed_2);
  if (sum <= 0.0) return length == 0.0 ? std::optional(0.0) : std::nullopt;
  return 2.0 * length / sum;
}

LegMade segments_of(const StraightLeg& leg, PathSegment now) {
  if (std::string fault = fault_of_one(leg.duration_s, leg.length_m,
                                       leg.duration_s ? "duration and length are" : "duration nor length is");
      !fault.empty())
    return fault_of_leg(std::move(fault));
  if (!std::isfinite(leg.acceleration_mps2)) return fault_of_leg("the acceleration is not finite");
  if (leg.duration_s.value_or(0.0) < 0.0) return fault_of_leg("the duration is negative");
  if (leg.length_m.value_or(0.0) < 0.0) return fault_of_leg("the length is negative");
  const auto time =
      leg.duration_s ? leg.duration_s : time_of_length(*leg.length_m, now.speed_mps, leg.acceleration_mps2);
  if (!time) return fault_of_leg("the speed comes to 0 before its end");
  const double end_speed = now.speed_mps + leg.acceleration_mps2 * *time;
  if (end_speed < -1e-9 * now.speed_mps) return fault_of_leg("the speed comes to 0 before its end");
  now.duration_s = *time;
  now.acceleration_mps2 = leg.acceleration_mps2;
  return {{now}, {}};
}

// The angle from one heading to another by the given side, clockwise positive; none where they are the same.
double angle_to(double heading, double target, TurnSide side) {
  constexpr double same_rad = 1e-9;
  const double shorter = half_turn_angle_rad(target - heading);
  if (std::abs(shorter) <= same_rad || side == TurnSide::shorter) return shorter;
  const bool right = side == TurnSide::right;
  if (right == (shorter > 0.0)) return shorter;
  return shorter + (right ? 2.0 : -2.0) * core::pi;
}

LegMade segments_of(const TurnLeg& leg, PathSegment now) {
  if (std::string fault = fault_of_one(leg.angle_rad, leg.heading_rad,
                                       leg.angle_rad ? "angle and heading are" : "angle nor heading is");
      !fault.empty())
    return fault_of_leg(std::move(fault));
  if (std::string fault = fault_of_size(leg.size); !fault.empty()) return fault_of_leg(std::move(fault));
  if (now.speed_mps <= 0.0) return fault_of_leg("the speed is 0");
  const double angle = leg.angle_rad ? *leg.angle_rad : angle_to(now.heading_rad, *leg.heading_rad, leg.side);
  const double rate = now.speed_mps / radius_of(leg.size, now.speed_mps);
  now.duration_s = std::abs(angle) / rate;
  now.turn_rate_rad_per_s = std::copysign(rate, angle);
  return {{now}, {}};
}

LegMade segments_of(const HoldLeg& leg, PathSegment now) {
  if (!std::isfinite(leg.duration_s)) return fault_of_leg("the duration is not finite");
  if (leg.duration_s < 0.0) return fault_of_leg("the duration is negative");
  now.duration_s = leg.duration_s;
  if (!leg.circle) return {{now}, {}};
  if (std::string fault = fault_of_size(*leg.circle); !fault.empty()) return fault_of_leg(std::move(fault));
  if (now.speed_mps <= 0.0) return fault_of_leg("the speed is 0");
  const double rate = now.speed_mps / radius_of(*leg.circle, now.speed_mps);
  now.turn_rate_rad_per_s = leg.side == TurnSide::left ? -rate : rate;
  return {{now}, {}};
}

std::string fault_of_climb(const ClimbLeg& leg) {
  if (std::string fault = fault_of_one(leg.height_m, leg.duration_s,
                                       leg.height_m ? "height and duration are" : "height nor duration is");
      !fault.empty())
    return fault;
  if (!std::isfinite(leg.rate_mps) || !std::isfinite(leg.rounding_mps2)) return "a number is not finite";
  if (leg.duration_s.value_or(0.0) < 0.0) return "the duration is negative";
  if (leg.height_m && leg.rate_mps <= 0.0) return "the rate to a height is not positive";
  if (leg.rounding_mps2 < 0.0) return "the vertical acceleration is negative";
  return {};
}

// A climb: its greatest vertical speed, the time of the whole and that of each rounded end.
struct ClimbTimes {
  double rate_mps = 0.0;
  double whole_s = 0.0;
  double ramp_s = 0.0;
};

// A trapezium of vertical speed; a triangle where the rate is not reached.
ClimbTimes climb_times(const ClimbLeg& leg, double height_now) {
  const double a = leg.rounding_mps2;
  double rate = std::abs(leg.rate_mps);
  if (leg.height_m) {
    const double rise = *leg.height_m - height_now;
    if (a > 0.0) rate = std::min(rate, std::sqrt(std::abs(rise) * a));
    const double ramp = a > 0.0 ? rate / a : 0.0;
    const double whole = rate > 0.0 ? std::abs(rise) / rate + ramp : 0.0;
    return {std::copysign(rate, rise), whole, ramp};
  }
  if (a > 0.0) rate = std::min(rate, 0.5 * a * *leg.duration_s);
  return {std::copysign(rate, leg.rate_mps), *leg.duration_s, a > 0.0 ? rate / a : 0.0};
}

PathSegment climbing(PathSegment from, double duration_s, double rate_mps, double acceleration_mps2) {
  from.duration_s = duration_s;
  from.climb_mps = rate_mps;
  from.climb_acceleration_mps2 = acceleration_mps2;
  return from;
}

// Whether the ends of a climb meet before its rate is reached. What it reaches goes with the rounding, to a height with
// its root.
std::optional<SlowClimb> slow_climb(const ClimbLeg& leg, const ClimbTimes& times) {
  const double rate = std::abs(leg.rate_mps);
  const double reached = std::abs(times.rate_mps);
  if (reached == 0.0 || reached >= rate) return std::nullopt;
  const double share = rate / reached;
  return SlowClimb{0, reached, leg.rounding_mps2 * (leg.height_m ? share * share : share)};
}

LegMade segments_of(const ClimbLeg& leg, const PathSegment& now) {
  if (std::string fault = fault_of_climb(leg); !fault.empty()) return fault_of_leg(std::move(fault));
  const ClimbTimes times = climb_times(leg, now.position_world_m.z);
  const double steady_s = std::max(0.0, times.whole_s - 2.0 * times.ramp_s);
  if (times.ramp_s == 0.0) return {{climbing(now, times.whole_s, times.rate_mps, 0.0)}, {}};
  const double a = std::copysign(leg.rounding_mps2, times.rate_mps);
  const PathSegment up = climbing(now, times.ramp_s, 0.0, a);
  const PathSegment steady = climbing(after(up), steady_s, times.rate_mps, 0.0);
  return {{up, steady, climbing(after(steady), times.ramp_s, times.rate_mps, -a)}, {}, slow_climb(leg, times)};
}

const char* name_of(const Leg& leg) {
  constexpr const char* names[] = {"straight", "turn", "climb", "hold"};
  return names[leg.index()];
}

PathSegment level(PathSegment segment) {
  segment.climb_mps = 0.0;
  return segment;
}

bool finite(const PathStart& start) {
  const core::Vec3& p = start.position_world_m;
  return std::isfinite(start.time_s + p.x + p.y + p.z + start.heading_rad + start.speed_mps);
}

// A number that a leg makes so large that nothing follows it.
bool lost(const PathSegment& now) {
  const core::Vec3& p = now.position_world_m;
  return !std::isfinite(p.x + p.y + p.z + now.heading_rad + now.speed_mps);
}

std::string fault_of_start(const PathStart& start) {
  if (!finite(start)) return "start: a number is not finite";
  if (start.speed_mps < 0.0) return "start: the speed is negative";
  return {};
}

}  // namespace

PathResult leg_path(const PathStart& start, const std::vector<Leg>& legs) {
  if (std::string fault = fault_of_start(start); !fault.empty()) return {{}, std::move(fault)};
  PathSegment now;
  now.position_world_m = start.position_world_m;
  now.heading_rad = start.heading_rad;
  now.speed_mps = start.speed_mps;
  Segments all{now};
  std::vector<SlowClimb> slow;
  std::vector<core::Vec3> ends_m;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    LegMade made = std::visit([&now](const auto& leg) { return segments_of(leg, now); }, legs[i]);
    if (made.fault.empty()) now = level(after(made.segments.back()));
    if (made.fault.empty() && lost(now)) made.fault = "it leads beyond all numbers";
    if (!made.fault.empty())
      return {
          {}, "leg " + std::to_string(i + 1) + " (" + name_of(legs[i]) + "): " + made.fault, i, {}, std::move(ends_m)};
    if (made.slow) slow.push_back({i, made.slow->reached_mps, made.slow->needed_rounding_mps2});
    now.speed_mps = std::max(0.0, now.speed_mps);
    all.insert(all.end(), made.segments.begin(), made.segments.end());
    ends_m.push_back(now.position_world_m);
  }
  all.push_back(now);
  return {SegmentPath(start.time_s, std::move(all)), {}, {}, std::move(slow), std::move(ends_m)};
}

std::vector<Leg> racetrack(double length_m, const TurnSize& size, TurnSide side) {
  const StraightLeg straight{std::nullopt, length_m, 0.0};
  const double half = side == TurnSide::left ? -core::pi : core::pi;
  const TurnLeg turn{half, std::nullopt, TurnSide::shorter, size};
  return {straight, turn, straight, turn};
}

}  // namespace sarsim::radar
