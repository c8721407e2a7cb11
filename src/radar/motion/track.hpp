#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/maths/interpolator.hpp"
#include "core/maths/vector.hpp"
#include "radar/motion/error_process.hpp"

namespace sarsim::radar {

/// Rotation of the thesis (6.1, with its misprinted middle entry corrected): M = Rx(a) Ry(b) Rz(c), right-handed
/// elementary rotations. A vector fixed on a platform has world coordinates M^T v, so
///
///     world_from_platform = M^T = Rz(-c) Ry(-b) Rx(-a):
///
/// roll about x first, then pitch about y, then yaw about z, each clockwise seen along its axis.
[[nodiscard]] core::Mat3 world_from_platform(const std::array<double, 3>& rotation_rad);

/// Its derivative in time while the angles change at the given rates.
[[nodiscard]] core::Mat3 world_from_platform_rate(const std::array<double, 3>& rotation_rad,
                                                  const std::array<double, 3>& rate_rad_per_s);

/// Its second derivative in time while the rates change as given.
[[nodiscard]] core::Mat3 world_from_platform_acceleration(const std::array<double, 3>& rotation_rad,
                                                          const std::array<double, 3>& rate_rad_per_s,
                                                          const std::array<double, 3>& acceleration_rad_per_s2);

/// Where a platform is and how it moves, at one time.
struct Pose {
  core::Vec3 position_world_m;
  core::Vec3 velocity_world_mps;
  std::array<double, 3> rotation_rad{};
  std::array<double, 3> rotation_rate_rad_per_s{};
  core::Mat3 world_from_platform;
  core::Mat3 world_from_platform_rate;
};

/// World position of a point that is fixed on the platform.
inline core::Vec3 world_position_m(const Pose& pose, const core::Vec3& point_platform_m) {
  return pose.position_world_m + pose.world_from_platform * point_platform_m;
}

/// World velocity of a point that is fixed on the platform: that of the origin and that of the turning.
inline core::Vec3 world_velocity_mps(const Pose& pose, const core::Vec3& point_platform_m) {
  return pose.velocity_world_mps + pose.world_from_platform_rate * point_platform_m;
}

/// How the motion of a platform changes, at one time.
struct PoseAcceleration {
  core::Vec3 acceleration_world_mps2;  ///< Of the platform's origin.
  core::Mat3 world_from_platform_acceleration{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};  ///< In 1/s^2.
};

/// World acceleration of a point that is fixed on the platform: that of the origin and that of the turning.
inline core::Vec3 world_acceleration_mps2(const PoseAcceleration& acceleration, const core::Vec3& point_platform_m) {
  return acceleration.acceleration_world_mps2 + acceleration.world_from_platform_acceleration * point_platform_m;
}

/// How a platform moves and turns; functions of time in seconds, metres and radians.
struct Motion {
  std::array<core::Interpolator, 3> position_m;
  bool aligned =
      false;  ///< x axis along the velocity: its elevation is added to rotation y, azimuth - 90 deg to rotation z.
  std::array<core::Interpolator, 3> rotation_rad;
  std::array<double, 3> rotation_rate_rad_per_s{};  ///< Added as rate * t.
  std::array<double, 3> position_stddev_m{};        ///< Drawn anew for every pulse; moves the platform, not its speed.
  std::array<double, 3> rotation_stddev_rad{};
  std::array<core::Interpolator, 3>
      position_envelope;  ///< Integration envelopes (decision 16); these move the speed too, where they do not jump.
  std::array<core::Interpolator, 3> rotation_envelope;
};

/// Where a platform's origin is and how it moves, at one time.
struct Travel {
  core::Vec3 position_world_m;
  core::Vec3 velocity_world_mps;
};

/// A platform's motion, ready to be evaluated. Const members are safe to call from many threads.
class Track {
 public:
  /// @param name  of the platform: the key of its random deviations.
  Track(Motion motion, std::uint64_t seed, const std::string& name);

  /// The pose when pulse `pulse` is sent at `time_s`. The alignment follows the nominal path, without errors. The
  /// velocity is the analytic derivative; where a path bends it is the one to the right (decision 4).
  [[nodiscard]] Pose at(double time_s, std::int64_t pulse) const;

  /// Steps of the motion errors that were last in use: calls near in time share them. One for each thread and track.
  struct ErrorSteps {
    std::array<ErrorProcess::Step, 3> position;
    std::array<ErrorProcess::Step, 3> rotation;
  };
  /// The same, and faster where motion errors have envelopes.
  [[nodiscard]] Pose at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;
  /// Position and velocity of `at` alone: much faster.
  [[nodiscard]] Travel travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const;

  /// How the pose of `at` changes its motion: its analytic second derivatives, to the right where a path bends. 0 from
  /// straight lines, motion errors among them. The jitter of pulse `pulse` turns the platform and so its derivatives.
  [[nodiscard]] PoseAcceleration acceleration_at(double time_s, std::int64_t pulse) const;
  /// The same where the pose at that time is known: faster.
  [[nodiscard]] PoseAcceleration acceleration_at(double time_s, const Pose& pose) const;

  /// No acceleration of the origin in `acceleration_at` exceeds this; infinity where it is not known beforehand.
  [[nodiscard]] double acceleration_bound_mps2() const { return acceleration_bound_mps2_; }
  /// True where the platform may turn as time passes.
  [[nodiscard]] bool turns() const { return turns_; }
  /// True where the pose is the same at every time and for every pulse.
  [[nodiscard]] bool fixed() const { return fixed_; }

 private:
  [[nodiscard]] Travel travel_along(const std::array<core::Jet, 3>& path, double time_s, std::int64_t pulse,
                                    ErrorSteps& steps) const;
  [[nodiscard]] Pose rotated_at_0() const;
  void add_rotation(Pose& pose, const std::array<core::Jet, 3>& path, double time_s, std::int64_t pulse,
                    ErrorSteps& steps) const;

  Motion motion_;
  core::RandomStream position_noise_;
  core::RandomStream rotation_noise_;
  std::array<ErrorProcess, 3> position_process_;
  std::array<ErrorProcess, 3> rotation_process_;
  double acceleration_bound_mps2_ = 0.0;
  bool turns_ = false;
  bool shakes_ = false;  // its rotation has jitter
  Pose attitude_;        // where it neither turns nor shakes; its place is not meant
  bool fixed_ = false;
};

}  // namespace sarsim::radar
