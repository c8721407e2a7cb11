#pragma once

#include <optional>
#include <string>

#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "scene/ephemeris/ephemeris_file.hpp"

namespace sarsim::scene {

/// Where a platform is at one time, in the world frame.
struct MotionSample {
  double time_s = 0.0;  ///< After the epoch.
  core::Vec3 position_m;
  core::Vec3 velocity_mps;  ///< Derivative of the position: over the Earth where the world lies on it.
};

/// How a platform is turned at one time.
struct AttitudeSample {
  double time_s = 0.0;  ///< After the epoch.
  core::Mat3 world_from_platform;
};

/// What a file says about the motion besides its samples.
struct MotionFacts {
  std::string object_name;                 ///< Of the platform; at most 200 bytes on one line.
  std::string object_id = "UNKNOWN";       ///< International designator; the word that CCSDS has for none.
  std::string created;                     ///< When the file is made, UTC: "2025-03-14T12:00:00".
  bool created_is_epoch = false;           ///< That is no such time but the epoch, so that files are reproducible.
  std::optional<radar::Instant> epoch;     ///< Time 0 of the samples.
  std::optional<radar::EarthFrame> earth;  ///< Where the world lies; none for a flat world of its own.
  InterpolationHint interpolation{InterpolationMethod::hermite, 7};  ///< By which positions should be read.
};

/// A file, or why there is none: where `problems` holds an error, `text` is empty.
struct MotionText {
  std::string text;
  core::Problems problems;
};

}  // namespace sarsim::scene
