#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/maths/interpolator.hpp"
#include "radar/motion/attitude_law.hpp"
#include "radar/motion/motion_path.hpp"
#include "radar/motion/sines.hpp"

namespace sarsim::radar {

class Track;

/// How a platform moves and turns; functions of time in seconds, metres and radians. The frame of all of it is the
/// world, or the platform axes of the parent where there is one.
struct Motion {
  MotionPath path;  ///< Nominal.
  bool aligned =
      false;  ///< x axis along the velocity: its elevation is added to rotation y, azimuth - 90 deg to rotation z.
  AttitudeLaw attitude;  ///< With a law other than `angles`, `aligned` does not matter.
  std::array<core::Interpolator, 3> rotation_rad;
  std::array<double, 3> rotation_rate_rad_per_s{};  ///< Added as rate * t.
  /// Oscillations, added to the position along the axes of the frame, and to the angles of rotation. They are motion:
  /// velocities, rates and accelerations have them too.
  std::vector<Sine> sines;
  std::array<double, 3> position_stddev_m{};  ///< Drawn anew for every pulse; moves the platform, not its speed.
  std::array<double, 3> rotation_stddev_rad{};
  std::array<core::Interpolator, 3>
      position_envelope;  ///< Integration envelopes (decision 16); these move the speed too, where they do not jump.
  std::array<core::Interpolator, 3> rotation_envelope;
  bool smooth_errors = false;  ///< Errors of envelopes have a continuous velocity; envelopes must vanish at their ends.
  /// The errors of the position envelopes x, y, z are along, left and up of the nominal path's level axes at the time
  /// (`relative_path::level_axes`), not along the axes of the frame; as the axes turn they carry the errors with them.
  bool errors_follow_path = false;
  /// What carries the platform: its axes are the frame of all the rest. With the parent at P, turned by Mp, and the
  /// platform at x, turned by m, in that frame,
  ///
  ///     X = P + Mp x          V = P' + Mp' x + Mp x'          A = P'' + Mp'' x + 2 Mp' x' + Mp x''
  ///     M = Mp m              and its derivatives likewise.
  ///
  /// The parent's errors carry over, its jitter for the same pulse. As Mp turns, it carries the platform's own jitter:
  /// velocities are derivatives in time for one pulse.
  std::shared_ptr<const Track> parent;
};

}  // namespace sarsim::radar
