#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/motion/path_state.hpp"

namespace sarsim::radar {

/// A piece of a path in closed form: seen from above a straight line or an arc, with a height that is linear or
/// quadratic in time. World frame: z up, headings clockwise from +y.
struct PathSegment {
  double duration_s = 0.0;
  core::Vec3 position_world_m;           ///< Where it starts.
  double heading_rad = 0.0;              ///< At its start: azimuth of the level velocity.
  double speed_mps = 0.0;                ///< Level speed at its start.
  double acceleration_mps2 = 0.0;        ///< Of the level speed; 0 in an arc.
  double turn_rate_rad_per_s = 0.0;      ///< Of the heading: clockwise positive.
  double climb_mps = 0.0;                ///< Vertical speed at its start.
  double climb_acceleration_mps2 = 0.0;  ///< Of the vertical speed.
};

/// The state that long after the segment's start; exact but for rounding, without limit of the time.
[[nodiscard]] PathState state_in(const PathSegment& segment, double elapsed_s);

/// A segment of no duration that starts where another one ends and goes on as it does, straight and unaccelerated.
[[nodiscard]] PathSegment after(const PathSegment& segment);

/// A path of segments one after another; straight and unaccelerated before the first and after the last of them.
/// Each segment starts where the one before it ends (`leg_path` and `waypoint_path` make them so); the velocity may
/// step there. Const members are safe to call from many threads, with times in any order.
class SegmentPath {
 public:
  /// Rests at the origin.
  SegmentPath() = default;
  /// @param start_s   when the first segment starts
  /// @param segments  no arc may have an acceleration, no duration be negative
  SegmentPath(double start_s, std::vector<PathSegment> segments);

  /// The state at any time; where the path bends, derivatives are those to the right.
  [[nodiscard]] PathState at(double time_s) const;
  [[nodiscard]] double start_s() const { return start_s_; }
  /// From the start of the first segment to the end of the last one.
  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// No acceleration of `at` exceeds this; the steps of the velocity are not in it.
  [[nodiscard]] double acceleration_bound_mps2() const;
  /// The largest step of the velocity between two segments; 0 but for rounding where there is none.
  [[nodiscard]] double largest_step_mps() const;
  [[nodiscard]] const std::vector<PathSegment>& segments() const { return segments_; }

 private:
  double start_s_ = 0.0;
  double duration_s_ = 0.0;
  std::vector<PathSegment> segments_;
  std::vector<double> begins_;  // of each segment, in s after start_s_
};

/// A climb that is too short to reach its rate between its rounded ends.
struct SlowClimb {
  std::size_t leg = 0;                ///< Position.
  double reached_mps = 0.0;           ///< Magnitude of the greatest vertical speed.
  double needed_rounding_mps2 = 0.0;  ///< With this or more it would reach its rate.
};

/// A path, or why there is none.
struct PathResult {
  SegmentPath path;
  std::string fault;                   ///< Empty where the path was made.
  std::optional<std::size_t> at = {};  ///< Position of the leg or waypoint that the fault is about, where it is one's.
  std::vector<SlowClimb> slow_climbs = {};
  std::vector<core::Vec3> leg_ends_m = {};  ///< Of `leg_path`: where each leg ends, up to the one that is at fault.
};

}  // namespace sarsim::radar
