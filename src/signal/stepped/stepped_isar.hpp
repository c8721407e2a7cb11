#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "core/task/progress.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"
#include "signal/stepped/profile_maker.hpp"

/// Images of a turning target from bursts of stepped frequencies, or from a train of chirps, each of which is a burst
/// of one step (docs/theory/stepped-frequency.md).
namespace sarsim::signal {

/// The plane in which a turning target is imaged, in the target's own frame: what the line of sight sweeps over.
struct IsarPlane {
  core::Vec3 range;        ///< Line of sight, away from the antenna, in the middle of the time. Length 1.
  core::Vec3 cross_range;  ///< Where it moves to, perpendicular to `range`: points there recede. Length 1.
  double range_m = 0.0;    ///< Of the target's origin then.
  double turn_rad = 0.0;   ///< Angle between the first line of sight and the last.
  double rate_radps = 0.0;
  /// Of each pulse: by how many metres a point one metre along `cross_range` is farther away than the origin.
  std::vector<double> lever;
};

/// @param seen  the antenna in the target's frame, as seen_from_target (signal/stepped/isar.hpp) gives it; two or more
/// @throw  std::invalid_argument for fewer
[[nodiscard]] IsarPlane plane_of(std::span<const TrackPoint> seen);

/// What takes the motion of the target's origin out: its delay, less that in the middle of the time, and its speed.
[[nodiscard]] std::vector<PulseMotion> motion_of_origin(std::span<const TrackPoint> seen, double light_speed_mps);

/// The echoes of whole bursts.
struct IsarEchoes {
  std::span<const std::complex<double>> values;  ///< As SteppedBand::place makes them, burst after burst.
  std::span<const PulseMotion> motion;           ///< Of each pulse.
  WindowFunction window;                         ///< Over the bursts, argument 0 to 1; empty: none.
};

/// Range and Doppler over bursts, compensated for the target's turning to the first order in its angle:
///
///     image(x, y) = sum over bursts, pulses and cells of w value exp(+2 pi j nu (delay + 2 x lever/c)) ...,
///
/// then a profile over y for each x. The exponent holds each pulse's own frequency and time: points do not walk through
/// range cells (keystone), a turning within the burst does not shear the image, and an uneven turning does not blur it.
/// What is left is the walk of second order, y turn^2/8. Rows are cross-ranges, columns the maker's ranges less
/// plane.range_m; a point keeps the mean amplitude of its echoes. The same bytes for any number of threads.
/// @throw  std::invalid_argument where the sizes contradict each other; Interrupted
[[nodiscard]] FocusedImage isar_range_doppler(const ProfileMaker& maker, const IsarEchoes& echoes,
                                              const IsarPlane& plane, const ImageAxis& cross_range,
                                              const core::WorkControl& control,
                                              const core::ProgressReport& progress = {});

/// The same points by the sum over all pulses with their exact delays, for any turning and any size of the target:
/// echoes.motion does not matter. Costs a pulse and a pixel each, where isar_range_doppler costs a pulse and a row.
/// @param seen  the antenna in the target's frame, one for each pulse
[[nodiscard]] FocusedImage isar_back_projection(const ProfileMaker& maker, const IsarEchoes& echoes,
                                                std::span<const TrackPoint> seen, const IsarPlane& plane,
                                                const ImageAxis& cross_range, const core::WorkControl& control,
                                                const core::ProgressReport& progress = {});

}  // namespace sarsim::signal
