#pragma once

#include <gtest/gtest.h>

#include "core/maths/vector.hpp"
#include "radar/motion/path_state.hpp"

namespace sarsim::radar {

inline void expect_near_vector(const core::Vec3& a, const core::Vec3& b, double bound) {
  EXPECT_LT(core::norm(a - b), bound) << "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y
                                      << ", " << b.z << ")";
}

/// Compares velocity, acceleration and jerk with central differences over +-1 ms. The paths of the tests are within
/// 1e5 m of the origin (rounding 1e-11/1e-3 in the quotient), below 300 m/s, and their derivatives fall by at least a
/// factor of 2 each (the difference's own error: a sixth of the third derivative times 1e-6).
template <class Path>
void expect_derivatives(const Path& path, double time_s) {
  constexpr double h = 1e-3;
  const PathState before = path(time_s - h), now = path(time_s), then = path(time_s + h);
  const auto slope = [](const core::Vec3& a, const core::Vec3& b) { return (0.5 / h) * (b - a); };
  expect_near_vector(slope(before.position_world_m, then.position_world_m), now.velocity_world_mps, 1e-4);
  expect_near_vector(slope(before.velocity_world_mps, then.velocity_world_mps), now.acceleration_world_mps2, 1e-5);
  expect_near_vector(slope(before.acceleration_world_mps2, then.acceleration_world_mps2), now.jerk_world_mps3, 1e-5);
}

}  // namespace sarsim::radar
