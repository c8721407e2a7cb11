#pragma once

#include <array>
#include <memory>
#include <utility>
#include <variant>

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"
#include "radar/motion/path_state.hpp"
#include "radar/motion/relative.hpp"
#include "radar/motion/segment_path.hpp"
#include "radar/orbit/state_table.hpp"

namespace sarsim::radar {

struct MotionPath;

/// Three coordinates as functions of time [s], in m. Derivatives are those of the functions, to the right where they
/// bend.
struct FunctionPath {
  std::array<core::Interpolator, 3> position_m;
};

/// A path through given states, as of an ephemeris. Beyond the spans of the table it goes on from the nearest end with
/// the velocity and the acceleration there, the acceleration constant; in a gap from the nearer end, so that it jumps
/// in the middle of the gap.
///
/// Jerk: the quotient of accelerations 0.1 s apart within the span; 0 outside. For a low orbit and
/// `hermite_degree_7` it is good to 1e-8 m/s^3.
struct StatePath {
  std::shared_ptr<const StateTable> states;
};

/// The path of something that keeps its place in the level axes of another path; see `relative_state`.
struct RelativePath {
  std::shared_ptr<const MotionPath> leader;
  PathOffset offset;
};

/// The nominal path of a platform. Const members are safe to call from many threads.
struct MotionPath {
  std::variant<FunctionPath, StatePath, SegmentPath, RelativePath> way;

  /// Rests at the origin.
  MotionPath() = default;
  /// The path that each of them describes; tables and leaders must be given.
  /// @{
  MotionPath(FunctionPath path) : way(std::move(path)) {}
  MotionPath(StatePath path);
  MotionPath(SegmentPath path) : way(std::move(path)) {}
  MotionPath(RelativePath path);
  /// @}

  /// Position, velocity, acceleration and jerk; where the path bends, derivatives are those to the right.
  [[nodiscard]] PathState state(double time_s) const;
  /// Position, velocity and acceleration of each coordinate alone: faster.
  [[nodiscard]] std::array<core::Jet, 3> jets(double time_s) const {
    const auto* functions = std::get_if<FunctionPath>(&way);
    if (functions == nullptr) return other_jets(time_s);
    const auto& f = functions->position_m;
    return {f[0].jet(time_s), f[1].jet(time_s), f[2].jet(time_s)};
  }
  /// The jerk alone.
  [[nodiscard]] core::Vec3 jerk_mps3(double time_s) const;
  /// Derivative of the jerk, m/s^4: exact for lines, cubics, straight segments and arcs, and for what keeps its place
  /// beside these; by quotients for low pass, to 1e-3; 0 for states.
  [[nodiscard]] core::Vec3 snap_mps4(double time_s) const;

  /// No acceleration of `state` exceeds this; infinity where it is not known. Steps of the velocity are not in it.
  [[nodiscard]] double acceleration_bound_mps2() const;
  /// True where the position is the same at every time.
  [[nodiscard]] bool fixed() const;
  /// False where the velocity keeps its direction: a platform that points along it does not turn.
  [[nodiscard]] bool may_turn() const;

 private:
  [[nodiscard]] std::array<core::Jet, 3> other_jets(double time_s) const;
};

/// A state from what `jets` gives, and the jerk.
[[nodiscard]] inline PathState path_state(const std::array<core::Jet, 3>& jets, const core::Vec3& jerk_mps3 = {}) {
  const auto& [x, y, z] = jets;
  return {{x.value, y.value, z.value}, {x.slope, y.slope, z.slope}, {x.curvature, y.curvature, z.curvature}, jerk_mps3};
}

}  // namespace sarsim::radar
