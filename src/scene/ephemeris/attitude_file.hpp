#pragma once

#include <string>
#include <vector>

#include "core/maths/vector.hpp"
#include "core/report/problem.hpp"
#include "radar/earth/civil_time.hpp"
#include "scene/ephemeris/ephemeris_file.hpp"

namespace sarsim::scene {

/// A rotation as a quaternion of length 1; `w` is the scalar. q and -q are the same rotation.
struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// The matrix that gives the coordinates of a vector in the turned axes from those in the first:
/// (w^2 - |v|^2) I + 2 v v^T - 2 w [v x] with v = (x, y, z), the convention of CCSDS 504.0. Axes turned by +90 degrees
/// about z (w = z = sqrt(1/2)) see the first x axis at (0, -1, 0).
[[nodiscard]] core::Mat3 turned_from_first(const Quaternion& q);

/// How a body was turned at one time.
struct AttitudeState {
  radar::CivilTime time;
  Quaternion body_from_reference;  ///< `turned_from_first` of it gives body axes from reference axes.
};

/// States between which one may interpolate. Nothing may be interpolated from one segment to the next.
struct AttitudeSegment {
  std::vector<AttitudeState> states;  ///< Times ascend; at least one. Signs of neighbours agree: their dot product is
                                      ///< not negative.
  UsableRange usable;                 ///< Within the times of the states.
  InterpolationHint interpolation;
};

/// The attitude of one body as a file gives it.
struct AttitudeFile {
  std::string object_name;
  std::string body_frame;  ///< As the file names it: "SC_BODY_1".
  Frame reference = Frame::itrf;
  radar::TimeScale scale = radar::TimeScale::utc;
  std::vector<AttitudeSegment> segments;  ///< By time; usable ranges touch at most.
};

/// What was read, and what is wrong with it. Where `problems` holds an error, `file` is incomplete.
struct AttitudeReading {
  AttitudeFile file;
  core::Problems problems;
};

}  // namespace sarsim::scene
