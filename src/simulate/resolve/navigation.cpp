#include "simulate/resolve/navigation.hpp"

#include <algorithm>

namespace sarsim::simulate {

namespace {

radar::Motion wandering(const scene::Platform& platform) {
  radar::Motion motion;
  motion.smooth_errors = true;
  if (platform.fix_m > 0.0)
    for (core::Interpolator& one : motion.position_envelope)
      one = radar::smooth_wander_function(platform.fix_m, platform.fix_s);
  if (platform.attitude_error.rad() > 0.0)
    for (core::Interpolator& one : motion.rotation_envelope)
      one = radar::smooth_wander_function(platform.attitude_error.rad(), platform.attitude_s);
  return motion;
}

}  // namespace

NavigationErrors::NavigationErrors(const scene::Platform& platform, std::uint64_t seed)
    : wander_(wandering(platform), seed, platform.name + "/navigation"),
      yaw_rate_rad_per_s_(platform.gyro[2].rad()),
      aligned_s_(platform.aligned_s) {
  const core::Vec3& bias = platform.accelerometer_mps2;
  // A drift about y tilts the vertical along x, one about x along y.
  biases_ = {radar::InsBias{bias.x, platform.gyro[1].rad(), aligned_s_},
             radar::InsBias{bias.y, platform.gyro[0].rad(), aligned_s_}, radar::InsBias{bias.z, 0.0, aligned_s_}};
}

radar::Pose NavigationErrors::believed(const radar::Pose& truth, double time_s) const {
  radar::Pose pose = truth;
  const radar::Pose wander = wander_.at(time_s, 0);
  // The vertical channel of a platform is held by a barometer or GNSS: it does not swing.
  const core::Jet x = radar::position_error(biases_[0], radar::InsModel::schuler, time_s);
  const core::Jet y = radar::position_error(biases_[1], radar::InsModel::schuler, time_s);
  const core::Jet z = radar::position_error(biases_[2], radar::InsModel::polynomial, time_s);
  pose.position_world_m = pose.position_world_m + wander.position_world_m + core::Vec3{x.value, y.value, z.value};
  pose.velocity_world_mps = pose.velocity_world_mps + wander.velocity_world_mps + core::Vec3{x.slope, y.slope, z.slope};
  for (std::size_t i = 0; i < 3; ++i) {
    pose.rotation_rad[i] += wander.rotation_rad[i];
    pose.rotation_rate_rad_per_s[i] += wander.rotation_rate_rad_per_s[i];
  }
  pose.rotation_rad[2] += yaw_rate_rad_per_s_ * std::max(0.0, time_s - aligned_s_);
  if (time_s > aligned_s_) pose.rotation_rate_rad_per_s[2] += yaw_rate_rad_per_s_;
  pose.world_from_platform = radar::world_from_platform(pose.rotation_rad);
  pose.world_from_platform_rate = radar::world_from_platform_rate(pose.rotation_rad, pose.rotation_rate_rad_per_s);
  return pose;
}

std::optional<NavigationErrors> navigation_errors_of(const scene::Platform& platform, std::uint64_t seed) {
  if (platform.navigation == scene::Platform::Navigation::none) return std::nullopt;
  return NavigationErrors(platform, seed);
}

}  // namespace sarsim::simulate
