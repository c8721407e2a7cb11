#pragma once

#include <memory>

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"
#include "radar/earth/sagnac.hpp"
#include "radar/motion/attitude_table.hpp"
#include "radar/motion/motion_path.hpp"
#include "radar/motion/path_state.hpp"
#include "radar/motion/rotation.hpp"
#include "radar/orbit/steering.hpp"

namespace sarsim::radar {

/// What turns a platform besides its own angles. All of it is in the frame of its path, and follows the nominal path:
/// without sines and errors.
struct AttitudeLaw {
  /// The laws.
  enum class Kind {
    angles,  ///< Nothing, or the velocity where the motion is `aligned`.
    /// Along the velocity as if aligned, banked as in a level, coordinated turn; see `coordinated_roll`.
    coordinated,
    /// The laws of steering.hpp, `with_z_up`: x ahead, y left, z up. The platform's own angles turn it within these
    /// axes.
    /// @{
    zero_doppler,
    nadir,
    look_at,  ///< z axis away from the point.
    /// @}
    quaternions,  ///< Attitudes of a table, within which the platform's own angles turn it.
  };
  Kind kind = Kind::angles;
  TurningAxes earth;                                      ///< For zero_doppler and nadir.
  FlightDirection flight = FlightDirection::earth_fixed;  ///< For zero_doppler and nadir.
  core::Vec3 point_world_m;                               ///< For look_at; rests in the frame of the path.
  double attack_rad = 0.0;                                ///< For coordinated: added to the pitch, nose up.
  std::shared_ptr<const AttitudeTable> table;             ///< For quaternions: must be given.

  /// True for the laws with axes of their own: all but angles and coordinated.
  [[nodiscard]] bool has_axes() const { return kind != Kind::angles && kind != Kind::coordinated; }
  /// True where these axes may turn in time.
  [[nodiscard]] bool axes_turn(const MotionPath& path) const {
    return has_axes() && (kind == Kind::quaternions ? table->turns() : !path.fixed());
  }
};

/// The axes of a law that has some, and their derivative, at a point of the path: frame of the path from axes. Uses the
/// state up to the acceleration.
[[nodiscard]] TurningMatrix law_axes(const AttitudeLaw& law, const PathState& state, double time_s);

/// The second derivative of these axes, 1/s^2, in closed form; uses the state up to the jerk.
[[nodiscard]] core::Mat3 law_axes_acceleration(const AttitudeLaw& law, const PathState& state, double time_s);

/// The roll of a coordinated turn, an angle of `world_from_platform`, and its derivatives: -atan(q/g), q = L h' the
/// lateral acceleration to the right, L the level speed, h the azimuth of the velocity; g = 9.80665 m/s^2. A right turn
/// lowers the right side, and in level flight apparent gravity g - a has no component along the y axis. Where the
/// platform climbs or has an angle of attack, that component is left in the order of q (1 - cos(pitch)).
/// @param snap_mps4  derivative of the jerk; the curvature alone needs it
[[nodiscard]] core::Jet coordinated_roll(const PathState& state, const core::Vec3& snap_mps4);

}  // namespace sarsim::radar
