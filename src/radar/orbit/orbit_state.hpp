#pragma once

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// Where a satellite is and how it moves, at one time. The frame is that of the function that returns it.
struct OrbitState {
  core::Vec3 position_m;
  core::Vec3 velocity_mps;
};

/// The same with its acceleration: derivatives in time of one function.
struct OrbitMotion {
  core::Vec3 position_m;
  core::Vec3 velocity_mps;
  core::Vec3 acceleration_mps2;
};

}  // namespace sarsim::radar
