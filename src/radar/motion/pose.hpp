#pragma once

#include <array>

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// Where a platform is and how it moves, at one time.
struct Pose {
  core::Vec3 position_world_m;
  core::Vec3 velocity_world_mps;
  std::array<double, 3> rotation_rad{};  ///< Angles of `world_from_platform`.
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

/// Where a platform's origin is and how it moves, at one time.
struct Travel {
  core::Vec3 position_world_m;
  core::Vec3 velocity_world_mps;
};

}  // namespace sarsim::radar
