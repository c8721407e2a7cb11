#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/motion/segment_path.hpp"

namespace sarsim::radar {

/// Which way a turn goes, seen from above. The shorter way of exactly half a turn is right.
enum class TurnSide { shorter, right, left };

/// How tight a turn is: exactly one of the two.
struct TurnSize {
  std::optional<double> bank_rad;  ///< Between 0 and 90 degrees: coordinated, radius v^2/(g tan bank).
  std::optional<double> radius_m;
};

/// Straight and level; exactly one of duration and length.
struct StraightLeg {
  std::optional<double> duration_s;
  std::optional<double> length_m;
  double acceleration_mps2 = 0.0;  ///< Of the speed, which may come to 0 but not below.
};

/// A level arc at constant speed; exactly one of angle and heading.
struct TurnLeg {
  std::optional<double> angle_rad;    ///< By that much, clockwise positive; more than a turn is allowed.
  std::optional<double> heading_rad;  ///< To that azimuth; within 1e-9 rad of it nothing is left to turn.
  TurnSide side = TurnSide::shorter;  ///< The way to the heading.
  TurnSize size;
};

/// Straight with a vertical speed; level again behind it. Exactly one of height and duration.
struct ClimbLeg {
  std::optional<double> height_m;  ///< To that world z, up or down as it takes.
  std::optional<double> duration_s;
  double rate_mps = 0.0;  ///< Vertical speed: its magnitude where a height is given, otherwise down where negative.
  /// Rounds the path off at both ends, so that the velocity does not step: magnitude of the vertical acceleration.
  /// Where the climb is too short for the rate, the rate is not reached. 0: the vertical speed steps.
  double rounding_mps2 = 0.0;
};

/// Waits: straight on with the state there is, or in circles at constant speed.
struct HoldLeg {
  double duration_s = 0.0;
  std::optional<TurnSize> circle;
  TurnSide side = TurnSide::right;  ///< Of the circle; `shorter` is right.
};

using Leg = std::variant<StraightLeg, TurnLeg, ClimbLeg, HoldLeg>;

/// Where and how a path of legs starts; level.
struct PathStart {
  double time_s = 0.0;
  core::Vec3 position_world_m;
  double heading_rad = 0.0;  ///< Azimuth: clockwise from +y.
  double speed_mps = 0.0;
};

/// A path from a start through legs, each in closed form; straight and level on before the start and after the last
/// leg. The speed is the level speed, which climbs do not change. Velocities step only at both ends of climbs without
/// rounding, accelerations at the ends of all legs.
///
/// The fault names the first leg that cannot be flown and why: "leg 2 (turn): the bank is 0".
[[nodiscard]] PathResult leg_path(const PathStart& start, const std::vector<Leg>& legs);

/// The four legs of a racetrack: straight, half a turn, straight, half a turn. It ends where and as it starts after
/// 2 (length/v + pi R/v).
[[nodiscard]] std::vector<Leg> racetrack(double length_m, const TurnSize& size, TurnSide side = TurnSide::right);

}  // namespace sarsim::radar
