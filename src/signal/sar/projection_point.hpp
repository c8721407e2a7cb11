#pragma once

#include <cstddef>
#include <vector>

#include "core/maths/vector.hpp"

namespace sarsim::signal {

/// What all pulses of a back-projection have in common.
struct ProjectionConstants {
  double carrier_hz = 0.0;
  double light_speed_mps = 0.0;
  double first_delay_s = 0.0;
  double records_per_s = 0.0;     ///< EchoRecords::factor times the sampling rate.
  double doppler_delay_s2 = 0.0;  ///< 1/K: the peak of a chirp of rate K lies fd/K before its delay. 0: it does not.
  bool moving = true;             ///< Delay 2 (d - r.V/c)/(c (1 - V^2/c^2)), else 2 d/c.
  std::size_t record_count = 0;   ///< Of a pulse.
};

/// Where a pulse was sent and how fast the antenna flew.
struct ProjectionPulse {
  core::Vec3 position_m;
  core::Vec3 velocity_mps;
  const float* records = nullptr;  ///< signal/sar/echo_records.hpp.
  double carrier_hz = 0.0;         ///< 0: that of the constants.
  double later_s = 0.0;            ///< By how much its first record is later than that of the constants.
  bool bistatic = false;           ///< Received at `receiver_m`: the delay is the sum of both ways. At rest.
  core::Vec3 receiver_m{};

  [[nodiscard]] double carrier_of(const ProjectionConstants& constants) const {
    return carrier_hz > 0.0 ? carrier_hz : constants.carrier_hz;
  }
};

/// Which pulses a point takes, by a number `place` that runs from -1/2 to 1/2 along the aperture.
struct ProjectionAperture {
  /// All pulses; those from whose heading the point lies at some angles; those sent at some times.
  enum class Kind { all, angle, time } kind = Kind::all;
  core::Vec3 heading;       ///< Length 1; 0: that of each pulse's velocity.
  double squint_rad = 0.0;  ///< Of the middle: ahead of the plane perpendicular to the heading.
  double extent = 0.0;      ///< angle: rad, time: s.
  bool uniform = true;      ///< No weight but 0 and 1.
  static constexpr std::size_t pieces = 512;
  std::vector<float> weights;  ///< pieces + 1 values from place -1/2 to 1/2 and one more; empty where uniform.
};

/// Where the aperture counts angles from: a vector of length 1, or 0 for a pulse that rests.
[[nodiscard]] core::Vec3 heading_of(const ProjectionPulse& pulse, const ProjectionAperture& aperture);

/// k of tau = k (d - r.V/c): 2/c, and 1/(1 - V^2/c^2) of that where the antenna flies on while the echo is under way.
[[nodiscard]] double slowness_of(const ProjectionPulse& pulse, const ProjectionConstants& constants);

/// One point and one pulse in double precision, as `project` defines them.
/// @param[in,out] re, im  sum over pulses
/// @param[in,out] weight  sum of weights; left alone by Kind::all
void project_point(const ProjectionPulse& pulse, const ProjectionConstants& constants,
                   const ProjectionAperture& aperture, const core::Vec3& point_m, float& re, float& im, float& weight);

}  // namespace sarsim::signal
