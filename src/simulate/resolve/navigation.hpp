#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "radar/motion/ins_errors.hpp"
#include "radar/motion/track.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::simulate {

/// By how much the navigation of a platform is wrong, as a function of time.
class NavigationErrors {
 public:
  /// @param platform  with Navigation::ins
  NavigationErrors(const scene::Platform& platform, std::uint64_t seed);

  /// What the navigation says where the platform has a pose: positions, velocities and angles with their errors, world
  /// axes; angles are added to those of the pose.
  [[nodiscard]] radar::Pose believed(const radar::Pose& truth, double time_s) const;

 private:
  radar::Track wander_;                     // wandering errors around the origin
  std::array<radar::InsBias, 3> biases_{};  // along world x, y, z
  double yaw_rate_rad_per_s_ = 0.0;
  double aligned_s_ = 0.0;
};

/// Nothing where the motion is known exactly.
[[nodiscard]] std::optional<NavigationErrors> navigation_errors_of(const scene::Platform& platform, std::uint64_t seed);

}  // namespace sarsim::simulate
