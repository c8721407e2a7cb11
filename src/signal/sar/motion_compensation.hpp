#pragma once

#include "core/task/parallel.hpp"
#include "signal/sar/reference_track.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/work_matrix.hpp"

namespace sarsim::signal {

/// What echoes are compensated to.
struct MotionCompensation {
  ReferenceTrack reference;  ///< Speed above 0.
  core::Vec3 scene_m;  ///< A point in the middle of the scene: on which side, how far away, how high the ground is.
  double squint_rad = 0.0;   ///< Of the middle of the beam, ahead of the plane perpendicular to the reference track.
  bool second_order = true;  ///< Also what depends on range.
  bool resample = true;      ///< To pulses evenly spaced along the track.
};

/// Echoes as an antenna on the reference track would have received them, for the methods that need a straight flight
/// at constant speed (Moreira and Huang 1994; Cumming and Wong 2005, ch. 11).
///
/// Each pulse is moved to Q, the point of the line nearest to its antenna P. Let X(R) be the point of level ground, as
/// high as `scene_m`, that is seen from Q under the squint angle at the distance R, and tau its delay. First order: the
/// pulse is moved by D = tau_P(X(R0)) - tau_Q(X(R0)) towards earlier times and turned by exp(+j 2 pi f D), R0 the
/// distance of the scene. Second order: a sample at the distance R is turned by exp(+j 2 pi f (D(R) - D(R0))), too. The
/// times of the track become those at which the reference antenna is at Q.
///
/// Exact for points in the middle of the beam, but for the change D(R) - D(R0) of the delay itself. A point seen a
/// radians to the side keeps a phase of 4 pi/lambda e (a sin(squint) + a^2/2) at the most, e the distance of P from the
/// line.
///
/// All echoes are gone through once, here; the rows of the result are made of those when they are asked for.
/// @param space  where the compensated echoes are kept
/// @throw  std::invalid_argument where the echoes contradict themselves, the reference rests or the scene lies on its
///         line; Interrupted
[[nodiscard]] EchoRows compensate_motion(const EchoRows& echoes, const MotionCompensation& how, const WorkSpace& space,
                                         const core::WorkControl& control, const core::ProgressReport& progress = {});

/// The same in memory.
[[nodiscard]] SarEchoes compensate_motion(const SarEchoes& echoes, const MotionCompensation& how,
                                          const core::WorkControl& control);

/// Echoes of pulses on the reference track, but unevenly spaced, at even spacing: as many pulses, from the first place
/// to the last, by a windowed sinc of 16 pulses (Kaiser, beta 4.7: -50 dB for signals within 80 % of the repetition
/// frequency) about the Doppler of the squint angle. The spacing may change smoothly from pulse to pulse, not at
/// random: see `unevenness`. Fewer than two pulses stay as they are. The rows of `echoes` are read when those of the
/// result are.
/// @throw  std::invalid_argument where the places of the pulses along the track do not ascend
[[nodiscard]] EchoRows resample_azimuth(const EchoRows& echoes, const ReferenceTrack& reference, double squint_rad);

/// The same in memory. May throw Interrupted, too.
[[nodiscard]] SarEchoes resample_azimuth(const SarEchoes& echoes, const ReferenceTrack& reference, double squint_rad,
                                         const core::WorkControl& control);

/// By how much the distance along the line of a reference track between two pulses differs from that between the next
/// two, at the worst, in parts of the mean distance; infinite where the places do not ascend. An interpolation between
/// pulses is wrong by up to pi/2 of that for echoes at a quarter of the repetition frequency: above 0.02 (-30 dB) it
/// should not be used.
[[nodiscard]] double unevenness(const std::vector<TrackPoint>& track, const ReferenceTrack& reference);

}  // namespace sarsim::signal
