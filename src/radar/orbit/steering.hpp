#pragma once

#include "core/maths/vector.hpp"
#include "radar/earth/sagnac.hpp"
#include "radar/orbit/orbit_state.hpp"

namespace sarsim::radar {

/// Velocity relative to axes that do not turn with the Earth, in the directions of the world's axes: v + w x (r - C),
/// m/s.
/// @param earth  how the world turns about the Earth's centre
[[nodiscard]] core::Vec3 inertial_velocity_mps(const OrbitMotion& motion, const TurningAxes& earth);

/// The attitude of a satellite: its x axis ahead, y to the right, z down. Columns of the matrix are these axes in the
/// world frame.
struct OrbitAttitude {
  core::Mat3 world_from_platform;
  core::Mat3 world_from_platform_rate{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};  ///< Its derivative in time, 1/s.
};

/// An angle and its derivative in time.
struct TurningAngle {
  double angle_rad = 0.0;
  double rate_rad_per_s = 0.0;
};

/// Which velocity the x axis follows.
enum class FlightDirection {
  earth_fixed,  ///< Over the turning Earth.
  inertial,     ///< As stars see it.
};

/// The laws below take the motion in the world frame. Rates need its acceleration; with the acceleration left 0 they
/// are those of a straight flight. Down is towards the Earth's centre: at most 0.2 deg from the normal of the
/// ellipsoid. The y axis is undefined where ahead and down are parallel; then it is some direction, and its rate is 0.

/// x axis exactly along the velocity, z axis as far down as that allows. With FlightDirection::earth_fixed this is
/// total zero-Doppler steering: whatever the roll, a beam in the y-z plane sees a Doppler frequency of 0 at all ranges.
[[nodiscard]] OrbitAttitude zero_doppler_attitude(const OrbitMotion& motion, const TurningAxes& earth,
                                                  FlightDirection flight = FlightDirection::earth_fixed);

/// z axis exactly down, x axis as far along the velocity as that allows.
[[nodiscard]] OrbitAttitude nadir_attitude(const OrbitMotion& motion, const TurningAxes& earth,
                                           FlightDirection flight = FlightDirection::earth_fixed);

/// z axis exactly at a point, x axis as far along the Earth-fixed velocity as that allows.
/// @param target  the point in the world frame; its acceleration is not used
[[nodiscard]] OrbitAttitude look_at_attitude(const OrbitMotion& motion, const OrbitMotion& target);

/// The attitude after a roll about x: y turns towards z, so that the right side goes down and z moves to the left. A
/// beam along z looks at `look` from the nadir to the right with a roll of -look.
[[nodiscard]] OrbitAttitude rolled(const OrbitAttitude& attitude, const TurningAngle& roll);
/// The attitude after a pitch about y: z turns towards x, so that the nose goes up.
[[nodiscard]] OrbitAttitude pitched(const OrbitAttitude& attitude, const TurningAngle& pitch);
/// The attitude after a yaw about z: x turns towards y, so that the nose goes to the right.
[[nodiscard]] OrbitAttitude yawed(const OrbitAttitude& attitude, const TurningAngle& yaw);

/// The same platform with axes x ahead, y to the left, z up, as platforms over a flat Earth have them.
[[nodiscard]] OrbitAttitude with_z_up(const OrbitAttitude& attitude);

/// Yaw for `yawed` that turns the x axis from the inertial to the Earth-fixed direction of flight on a circular orbit
/// (Raney 1986),
///
///     tan(yaw) = -sin(i) cos(u)/(n/w - cos(i)),
///
/// negative (to the left) at the ascending node. Within 0.01 deg of the exact angle for e < 0.002.
/// @param latitude_argument_rad  u: angle from the ascending node
/// @param motion_by_rotation     n/w: turns of the satellite in one turn of the Earth; above 1
[[nodiscard]] double yaw_steering_rad(double inclination_rad, double latitude_argument_rad, double motion_by_rotation);

}  // namespace sarsim::radar
