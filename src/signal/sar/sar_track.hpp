#pragma once

#include <span>

#include "core/maths/vector.hpp"
#include "signal/sar/sar_echoes.hpp"

namespace sarsim::signal {

/// The straight line, flown at constant speed, that comes closest to a track in the least squares of its positions, and
/// how far the track departs from it.
struct StraightTrack {
  core::Vec3 origin_m;  ///< World, at the time of pulse number `middle_pulse`.
  core::Vec3 along;     ///< Direction of flight, length 1.
  double speed_mps = 0.0;
  double interval_s = 0.0;  ///< Mean time between pulses.
  std::size_t middle_pulse = 0;
  double worst_position_m = 0.0;  ///< Largest distance between the track and the line at the same time.
  double worst_interval_s = 0.0;  ///< Largest departure of a pulse from even spacing.

  /// Time of a pulse, from that of the middle one.
  [[nodiscard]] double time_s(double pulse) const { return (pulse - static_cast<double>(middle_pulse)) * interval_s; }
};

/// @param track  at least two points, in ascending time; otherwise std::invalid_argument
[[nodiscard]] StraightTrack fit_straight(std::span<const TrackPoint> track);

}  // namespace sarsim::signal
