#pragma once

#include <array>

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// Rotation of the thesis (6.1, with its misprinted middle entry corrected): M = Rx(a) Ry(b) Rz(c), right-handed
/// elementary rotations. A vector fixed on a platform has world coordinates M^T v, so
///
///     world_from_platform = M^T = Rz(-c) Ry(-b) Rx(-a):
///
/// roll about x first, then pitch about y, then yaw about z, each clockwise seen against its axis, from its tip.
[[nodiscard]] core::Mat3 world_from_platform(const std::array<double, 3>& rotation_rad);

/// Its derivative in time while the angles change at the given rates.
[[nodiscard]] core::Mat3 world_from_platform_rate(const std::array<double, 3>& rotation_rad,
                                                  const std::array<double, 3>& rate_rad_per_s);

/// Its second derivative in time while the rates change as given.
[[nodiscard]] core::Mat3 world_from_platform_acceleration(const std::array<double, 3>& rotation_rad,
                                                          const std::array<double, 3>& rate_rad_per_s,
                                                          const std::array<double, 3>& acceleration_rad_per_s2);

/// A rotation and its derivative in time, 1/s.
struct TurningMatrix {
  core::Mat3 matrix;
  core::Mat3 rate{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};
};

/// `world_from_platform` and `world_from_platform_rate` for the price of one.
[[nodiscard]] TurningMatrix turning_matrix(const std::array<double, 3>& rotation_rad,
                                           const std::array<double, 3>& rate_rad_per_s);

/// The same, written where it is wanted: faster.
void set_turning_matrix(const std::array<double, 3>& rotation_rad, const std::array<double, 3>& rate_rad_per_s,
                        core::Mat3& matrix, core::Mat3& rate);

/// A rotation after another one, `inner` first, and the derivative of the product.
[[nodiscard]] TurningMatrix operator*(const TurningMatrix& outer, const TurningMatrix& inner);

/// The angles of a rotation, rad: roll and yaw in [-pi, pi], pitch in [-pi/2, pi/2]. `world_from_platform` of them
/// gives the matrix back to rounding. Where the pitch is 90 degrees (gimbal lock) roll and yaw turn about one axis;
/// there the roll is 0 in exact arithmetic, any number within rounding of the lock, and the yaw belongs to it.
[[nodiscard]] std::array<double, 3> rotation_angles_rad(const core::Mat3& world_from_platform);

/// The rates of these angles, rad/s. Within 1e-9 rad of gimbal lock the rate of the roll counts as 0, and a turn that
/// leaves the lock sideways is in none of them.
[[nodiscard]] std::array<double, 3> rotation_rates_rad_per_s(const TurningMatrix& world_from_platform,
                                                             const std::array<double, 3>& rotation_rad);

}  // namespace sarsim::radar
