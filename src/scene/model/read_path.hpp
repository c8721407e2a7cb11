#pragma once

#include <memory>
#include <string>

#include "radar/motion/attitude_table.hpp"
#include "radar/orbit/state_table.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The states of a platform whose path is an orbit (scene/model/orbit.hpp), over times of the scene and in its world.
struct ReadPath {
  std::shared_ptr<const radar::StateTable> states;
  radar::TimeSpan usable;   ///< Times for which the states may be used.
  std::string made_of;      ///< What it was made of: another file, satellite, world or time makes it anew.
  std::string description;  ///< For people: "a Sentinel-1 orbit file, 17 states, 10 s apart, in ITRF".
};

/// The attitude of a platform with Rotation::quaternions.
struct ReadAttitude {
  std::shared_ptr<const radar::AttitudeTable> attitudes;
  radar::TimeSpan usable;
  std::string made_of;
};

/// The times for which the recordings and tables of a scene need the motion of platforms; from 0 to 0 without any.
[[nodiscard]] radar::TimeSpan needed_times(const Scene& scene);

}  // namespace sarsim::scene
