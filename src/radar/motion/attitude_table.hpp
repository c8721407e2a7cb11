#pragma once

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/motion/rotation.hpp"

namespace sarsim::radar {

/// A rotation as a unit quaternion: by the angle 2 acos w, right-handed about (x, y, z).
struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// The matrix of the rotation; the quaternion is taken to length 1.
[[nodiscard]] core::Mat3 matrix_of(const Quaternion& rotation);
/// The quaternion of a rotation, w >= 0.
[[nodiscard]] Quaternion quaternion_of(const core::Mat3& rotation);

/// Attitudes of a platform at certain times.
struct AttitudeSamples {
  std::vector<double> time_s;  ///< Ascending, spaced as they like.
  /// World (or parent) from platform; their signs do not matter. Lengths may differ from 1 by 1e-3. A quaternion and
  /// its neighbour are taken for less than half a turn apart.
  std::vector<Quaternion> world_from_platform;
};

/// An attitude with derivatives in time.
struct AttitudeMotion {
  TurningMatrix world_from_platform;
  core::Mat3 acceleration{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};  ///< Second derivative, 1/s^2.
};

/// The attitude through given ones: cubic splines (not a knot) of the four components of the quaternion, taken to
/// length 1. Between h-spaced samples of a smooth attitude the error is 5/192 h^4 times the largest fourth derivative
/// of a component, as an angle, and up to 10 times that in the two intervals next to each end: for the attitude of a
/// zero-Doppler satellite in low orbit, every 10 s, 3e-11 rad, and 2e-11 rad/s of its rate. The derivatives are exactly
/// those of the interpolation: matrix and rate are continuous, the second derivative is too and bends at samples.
///
/// Before the first and after the last sample the attitude stays as it is there, without turning. Const members are
/// safe to call from many threads.
class AttitudeTable {
 public:
  /// Refuses lists of different lengths, no samples, numbers that are not finite, times that do not ascend and
  /// quaternions whose length is not 1.
  [[nodiscard]] static std::variant<AttitudeTable, core::Problem> from(const AttitudeSamples& samples);

  /// The attitude and its derivatives at any time.
  [[nodiscard]] AttitudeMotion at(double time_s) const;
  /// The same without the second derivative.
  [[nodiscard]] TurningMatrix turning_at(double time_s) const;
  /// True where it has more than one attitude.
  [[nodiscard]] bool turns() const { return last_s_ > first_s_; }
  [[nodiscard]] double first_s() const { return first_s_; }
  [[nodiscard]] double last_s() const { return last_s_; }

 private:
  AttitudeTable() = default;

  std::array<core::Interpolator, 4> parts_;  // w, x, y, z
  double first_s_ = 0.0;
  double last_s_ = 0.0;
};

}  // namespace sarsim::radar
