#pragma once

#include <span>

#include "signal/sar/sar_echoes.hpp"

namespace sarsim::signal {

/// A straight line flown at constant speed.
struct ReferenceTrack {
  double time_s = 0.0;      ///< When the antenna is at `position_m`.
  core::Vec3 position_m;    ///< World.
  core::Vec3 velocity_mps;  ///< World.

  [[nodiscard]] core::Vec3 at(double time) const { return position_m + (time - time_s) * velocity_mps; }
};

/// The line that fits the positions of a track best in the sense of least squares; `time_s` is the mean time. One
/// pulse, or pulses at one time: its own velocity. No pulses: at rest at the origin.
[[nodiscard]] ReferenceTrack fitted_track(std::span<const TrackPoint> track);

/// Straightness of a flight, 0 to 1: the distance from its first pulse to its last over the sum of the distances
/// between the pulses at its eighths. 1 for a straight flight, also with fast sway, about sin(a/2)/(a/2) for a turn by
/// the angle a, 0 for a circle and for fewer than two pulses.
[[nodiscard]] double straightness(std::span<const TrackPoint> track);

/// Straightness below which a flight is treated as curved, without a line: a turn by more than about 50 degrees.
inline constexpr double min_straightness = 0.97;

/// Distance of a point from the whole line; from `position_m` where the velocity is 0.
[[nodiscard]] double distance_from(const ReferenceTrack& track, const core::Vec3& point_m);

}  // namespace sarsim::signal
