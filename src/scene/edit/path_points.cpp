#include "scene/edit/path_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "scene/model/route.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::scene {

namespace {

// A number of a leg that moves its end.
struct Knob {
  std::function<double(const Platform&)> get;
  std::function<void(Platform&, double)> set;
  double lowest;  // Nothing below it can be flown.
  double trial;   // A step that moves the end a little.
  double step;    // To which it is rounded.
  double most;    // By which it is turned at once: behind more, an arc leads elsewhere.
};

double power_of_ten_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }

Knob knob_of(const std::function<double&(Platform&)>& number, double lowest, double trial, double step) {
  return {[number](const Platform& platform) {
            Platform copy = platform;
            return number(copy);
          },
          [number](Platform& platform, double value) { number(platform) = value; },
          lowest,
          trial,
          step,
          HUGE_VAL};
}

Knob knob_of(const std::function<core::Angle&(Platform&)>& angle, double step_deg) {
  return {[angle](const Platform& platform) {
            Platform copy = platform;
            return angle(copy).deg();
          },
          [angle](Platform& platform, double value) { angle(platform) = core::Angle::from_deg(value); },
          -HUGE_VAL,
          1e-3,
          step_deg,
          20.0};
}

// Where the first `legs` of a platform's legs end; nothing where they cannot be flown.
std::optional<core::Vec3> end_of(Platform platform, std::size_t legs) {
  platform.legs.resize(legs);
  const radar::PathResult made = route_of(platform);
  return made.fault.empty() && !made.leg_ends_m.empty() ? std::optional(made.leg_ends_m.back()) : std::nullopt;
}

// What turns the direction in which a leg is flown, where something before it does.
std::optional<Knob> direction_of(const Platform& platform, std::size_t leg, double step_deg) {
  if (leg == 0) return knob_of([](Platform& p) -> core::Angle& { return p.course; }, step_deg);
  const Leg::Kind before = platform.legs[leg - 1].kind;
  if (before == Leg::Kind::turn)
    return knob_of([leg](Platform& p) -> core::Angle& { return p.legs[leg - 1].angle; }, step_deg);
  if (before == Leg::Kind::turn_to)
    return knob_of([leg](Platform& p) -> core::Angle& { return p.legs[leg - 1].heading; }, step_deg);
  return std::nullopt;
}

// @param reach_m  from the begin of the leg to where it is to end
std::vector<Knob> knobs_of(const Platform& platform, std::size_t leg, double reach_m, double resolution_m) {
  const double step_deg = std::min(1.0, power_of_ten_below(core::deg_per_rad * resolution_m / reach_m));
  const double step_s = power_of_ten_below(resolution_m / std::max(platform.speed_mps, 1e-3));
  const auto of_leg = [leg](double Leg::*number) {
    return [leg, number](Platform& p) -> double& { return p.legs[leg].*number; };
  };
  const auto duration = [&] { return knob_of(of_leg(&Leg::duration_s), 0.0, 1e-3, step_s); };
  std::vector<Knob> knobs;
  const Leg& flown = platform.legs[leg];
  switch (flown.kind) {
    case Leg::Kind::straight:
      knobs.push_back(flown.length_m != 0.0 ? knob_of(of_leg(&Leg::length_m), 0.0, 1e-2, resolution_m) : duration());
      break;
    case Leg::Kind::turn: return {knob_of([leg](Platform& p) -> core::Angle& { return p.legs[leg].angle; }, step_deg)};
    case Leg::Kind::turn_to:
      return {knob_of([leg](Platform& p) -> core::Angle& { return p.legs[leg].heading; }, step_deg)};
    case Leg::Kind::climb:
      knobs.push_back(duration());
      knobs.push_back(knob_of(of_leg(&Leg::rate_mps), -HUGE_VAL, 1e-4,
                              power_of_ten_below(resolution_m / std::max(flown.duration_s, 1e-3))));
      break;
    case Leg::Kind::climb_to:
      knobs.push_back(knob_of(of_leg(&Leg::height_m), -HUGE_VAL, 1e-3, resolution_m));
      knobs.push_back(knob_of(of_leg(&Leg::rate_mps), 0.0, 1e-4, 1e-3));
      break;
    case Leg::Kind::hold: knobs.push_back(duration()); break;
    case Leg::Kind::circle: return {duration()};
  }
  if (const auto direction = direction_of(platform, leg, step_deg)) knobs.push_back(*direction);
  return knobs;
}

// At most three unknowns, by Cramer's rule; the matrix is positive definite.
std::array<double, 3> solved(const core::Mat3& matrix, const core::Vec3& right) {
  const core::Mat3 columns = core::transposed(matrix);
  const double det = core::dot(columns.row[0], core::cross(columns.row[1], columns.row[2]));
  return {core::dot(right, core::cross(columns.row[1], columns.row[2])) / det,
          core::dot(columns.row[0], core::cross(right, columns.row[2])) / det,
          core::dot(columns.row[0], core::cross(columns.row[1], right)) / det};
}

// Turns the knobs until a leg ends as near to a place as it can: Levenberg's and Marquardt's method.
class LegFit {
 public:
  LegFit(const Platform& platform, std::size_t leg, const core::Vec3& to_m, std::vector<Knob> knobs)
      : platform_(platform), leg_(leg), to_m_(to_m), knobs_(std::move(knobs)) {}

  std::optional<Platform> fitted() {
    auto end = end_of(platform_, leg_ + 1);
    if (!end) return std::nullopt;
    double damping = 1e-3;
    for (int i = 0; i < max_steps && damping < 1e9; ++i) {
      const auto next = step(*end, damping);
      const auto next_end = next ? end_of(*next, leg_ + 1) : std::nullopt;
      if (next_end && core::norm(*next_end - to_m_) < core::norm(*end - to_m_)) {
        const bool settled = core::norm(*next_end - *end) < 1e-9;
        platform_ = *next;
        end = next_end;
        damping *= 0.2;
        if (settled) break;
      } else {
        damping *= 5.0;
      }
    }
    return rounded();
  }

 private:
  static constexpr int max_steps = 60;

  [[nodiscard]] std::optional<Platform> step(const core::Vec3& end, double damping) const {
    std::array<core::Vec3, 3> slope{};
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
      Platform tried = platform_;
      knobs_[i].set(tried, knobs_[i].get(platform_) + knobs_[i].trial);
      const auto tried_end = end_of(tried, leg_ + 1);
      if (!tried_end) return std::nullopt;
      slope[i] = (1.0 / knobs_[i].trial) * (*tried_end - end);
    }
    const core::Vec3 miss = to_m_ - end;
    core::Mat3 normal;
    std::array<double, 3> right{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto entry = [&](std::size_t j) {
        const double product = core::dot(slope[i], slope[j]);
        return i == j ? (1.0 + damping) * product + (product == 0.0 ? 1.0 : 0.0) : product;
      };
      normal.row[i] = {entry(0), entry(1), entry(2)};
      right[i] = core::dot(slope[i], miss);
    }
    const std::array<double, 3> by = solved(normal, {right[0], right[1], right[2]});
    Platform moved = platform_;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
      knobs_[i].set(moved, std::max(knobs_[i].lowest,
                                    knobs_[i].get(platform_) + std::clamp(by[i], -knobs_[i].most, knobs_[i].most)));
    return moved;
  }

  [[nodiscard]] std::optional<Platform> rounded() const {
    Platform round = platform_;
    for (const Knob& knob : knobs_) {
      const double value = core::rounded_to(knob.get(platform_), knob.step);
      knob.set(round, core::tidy(knob.lowest == 0.0 ? std::max(value, knob.step) : value));
    }
    if (end_of(round, leg_ + 1)) return round;
    return platform_;
  }

  Platform platform_;
  std::size_t leg_;
  core::Vec3 to_m_;
  std::vector<Knob> knobs_;
};

// Where a state and the end of its velocity are in the world.
std::vector<core::Vec3> state_points(const Platform& platform, const radar::EarthFrame& earth) {
  const core::Vec3 ahead_m = state_arrow_s * platform.state_velocity_mps;
  return {earth.world_from_ecef(platform.state_position_m), earth.world_from_ecef(platform.state_position_m + ahead_m)};
}

// A vector turned as the vertical turns from one place to another, the shortest way; places opposite each other leave
// it as it is.
core::Vec3 turned_with_vertical(const core::Vec3& vector, const core::Vec3& from, const core::Vec3& to) {
  const core::Vec3 a = (1.0 / core::norm(from)) * from;
  const core::Vec3 b = (1.0 / core::norm(to)) * to;
  const core::Vec3 sum = a + b;
  const double cosine_1 = 1.0 + core::dot(a, b);
  if (!(cosine_1 > 1e-9)) return vector;
  return vector - (core::dot(sum, vector) / cosine_1) * sum + (2.0 * core::dot(a, vector)) * b;
}

Platform with_state_point(Platform platform, const radar::EarthFrame& earth, std::size_t index, const core::Vec3& to_m,
                          double resolution_m) {
  const core::Vec3 to_ecef_m = earth.ecef_from_world(to_m);
  const double step_mps = power_of_ten_below(resolution_m / state_arrow_s);
  core::Vec3 velocity_mps = (1.0 / state_arrow_s) * (to_ecef_m - platform.state_position_m);
  if (index == 0) {
    velocity_mps = turned_with_vertical(platform.state_velocity_mps, platform.state_position_m, to_ecef_m);
    platform.state_position_m = core::rounded_to(to_ecef_m, resolution_m);
  }
  platform.state_velocity_mps = core::rounded_to(velocity_mps, step_mps);
  return platform;
}

}  // namespace

std::vector<core::Vec3> path_points(const Platform& platform, const World& world) {
  if (platform.path == Platform::Path::state) {
    const auto earth = earth_of(world);
    return earth ? state_points(platform, *earth) : std::vector<core::Vec3>();
  }
  std::vector<core::Vec3> points;
  if (platform.path == Platform::Path::waypoints)
    for (const Waypoint& waypoint : platform.waypoints) points.push_back(waypoint.position_m);
  if (platform.path != Platform::Path::legs) return points;
  points.push_back(platform.start_m);
  const std::vector<core::Vec3> ends = route_of(platform).leg_ends_m;
  points.insert(points.end(), ends.begin(), ends.end());
  return points;
}

std::string path_point_name(const Platform& platform, std::size_t index) {
  if (platform.path == Platform::Path::waypoints) return fmt::format("waypoint {}", index + 1);
  if (platform.path == Platform::Path::state) return index == 0 ? "state at time 0" : "velocity";
  return index == 0 ? "start" : fmt::format("end of leg {}", index);
}

std::optional<Platform> with_path_point(const Platform& platform, const World& world, std::size_t index,
                                        const core::Vec3& to_m, double resolution_m) {
  const std::vector<core::Vec3> points = path_points(platform, world);
  if (index >= points.size() || !std::isfinite(core::norm(to_m))) return std::nullopt;
  if (platform.path == Platform::Path::state)
    return with_state_point(platform, *earth_of(world), index, to_m, resolution_m);
  Platform moved = platform;
  if (platform.path == Platform::Path::waypoints) {
    moved.waypoints[index].position_m = to_m;
    return moved;
  }
  if (index == 0) {
    moved.start_m = to_m;
    return moved;
  }
  const double reach_m = std::max(core::norm(to_m - points[index - 1]), resolution_m);
  return LegFit(platform, index - 1, to_m, knobs_of(platform, index - 1, reach_m, resolution_m)).fitted();
}

}  // namespace sarsim::scene
