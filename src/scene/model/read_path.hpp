#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "radar/motion/attitude_table.hpp"
#include "radar/orbit/state_table.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Interpolation error between the samples of a file (`accuracy_between`, scene/ephemeris/sample_accuracy.hpp).
struct ReadAccuracy {
  double error = 0.0;  ///< Largest in the times that are needed: m, or rad for attitudes.
  double at_s = 0.0;
  double spacing_s = 0.0;  ///< Of the samples there.
};

/// The states of a platform whose path is an orbit (scene/model/orbit.hpp), over times of the scene and in its world.
struct ReadPath {
  std::shared_ptr<const radar::StateTable> states;
  radar::TimeSpan usable;                ///< Times for which the states may be used.
  std::string made_of;                   ///< What it was made of: another file, satellite, world or time makes it anew.
  std::string description;               ///< For people: "a Sentinel-1 orbit file, 17 states, 10 s apart, in ITRF".
  std::optional<ReadAccuracy> accuracy;  ///< Nothing if states are computed.
  core::Problems remarks;                ///< Warnings and notes from reading the file.
};

/// The attitude of a platform with Rotation::quaternions.
struct ReadAttitude {
  std::shared_ptr<const radar::AttitudeTable> attitudes;
  radar::TimeSpan usable;
  std::string made_of;
  std::optional<ReadAccuracy> accuracy;
  core::Problems remarks;
};

/// The times for which the recordings and tables of a scene need the motion of platforms; from 0 to 0 without any.
[[nodiscard]] radar::TimeSpan needed_times(const Scene& scene);

}  // namespace sarsim::scene
