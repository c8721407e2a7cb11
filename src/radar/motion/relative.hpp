#pragma once

#include <cmath>

#include "core/maths/vector.hpp"
#include "radar/motion/path_state.hpp"

namespace sarsim::radar {

/// A place in the frame of another path: level axes that follow its heading.
struct PathOffset {
  double along_m = 0.0;   ///< Ahead, level.
  double across_m = 0.0;  ///< To the left, level: the y axis of an aligned platform.
  double up_m = 0.0;      ///< Along world z.
  double delay_s = 0.0;   ///< Where the other one was that long ago.
};

namespace relative_path {

/// Level axes of a path and their derivatives in time, up to the third: `ahead[n]` is the n-th.
struct LevelAxes {
  core::Vec3 ahead[4];
  core::Vec3 left[4];
};

/// Heading and its rates from velocity, acceleration and jerk; north and without turning where the path is vertical or
/// rests. Azimuth rate: (vy ax - vx ay)/L^2, L the level speed.
inline LevelAxes level_axes(const PathState& s) {
  const core::Vec3& v = s.velocity_world_mps;
  const core::Vec3& a = s.acceleration_world_mps2;
  const core::Vec3& j = s.jerk_world_mps3;
  const double level2 = v.x * v.x + v.y * v.y;
  const bool moves = level2 > 0.0;
  const double rate = moves ? (v.y * a.x - v.x * a.y) / level2 : 0.0;
  const double rate2 = moves ? (v.y * j.x - v.x * j.y - 2.0 * rate * (v.x * a.x + v.y * a.y)) / level2 : 0.0;
  const double heading = core::azimuth_rad({v.x, v.y, 0.0});
  const core::Vec3 ahead{std::sin(heading), std::cos(heading), 0.0};
  const core::Vec3 left{-ahead.y, ahead.x, 0.0};
  // d ahead/dt = -rate left, d left/dt = rate ahead; the third derivative of the heading counts as 0.
  return {{ahead, -rate * left, -rate2 * left - rate * rate * ahead,
           rate * rate * rate * left - 3.0 * rate * rate2 * ahead},
          {left, rate * ahead, rate2 * ahead - rate * rate * left,
           -rate * rate * rate * ahead - 3.0 * rate * rate2 * left}};
}

}  // namespace relative_path

/// The state of something that keeps its place in the path frame of another one.
///
/// Position, velocity and acceleration are exact derivatives of each other where the parent's are. The jerk leaves out
/// the third derivative of the parent's heading; that is 0 for straight legs and turns at constant rate.
/// @param parent  a function of time [s] that returns a PathState
template <class Parent>
[[nodiscard]] PathState relative_state(const Parent& parent, const PathOffset& offset, double time_s) {
  PathState s = parent(time_s - offset.delay_s);
  const relative_path::LevelAxes axes = relative_path::level_axes(s);
  const auto arm = [&](int n) { return offset.along_m * axes.ahead[n] + offset.across_m * axes.left[n]; };
  s.position_world_m = s.position_world_m + arm(0) + core::Vec3{0.0, 0.0, offset.up_m};
  s.velocity_world_mps = s.velocity_world_mps + arm(1);
  s.acceleration_world_mps2 = s.acceleration_world_mps2 + arm(2);
  s.jerk_world_mps3 = s.jerk_world_mps3 + arm(3);
  return s;
}

}  // namespace sarsim::radar
