#pragma once

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// A point of a path at one time, and its derivatives in time. World frame: x east, y north, z up.
struct PathState {
  core::Vec3 position_world_m;
  core::Vec3 velocity_world_mps;
  core::Vec3 acceleration_world_mps2;
  core::Vec3 jerk_world_mps3;  ///< What a platform that points along its velocity needs to know how it turns.
};

}  // namespace sarsim::radar
