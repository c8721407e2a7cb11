#pragma once

#include <cstddef>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/sar_echoes.hpp"
#include "signal/sar/sar_image.hpp"
#include "signal/search/range_doppler_map.hpp"

namespace sarsim::signal {

/// Where a target is and how it is turned when a pulse is sent.
struct TargetPose {
  core::Vec3 centre_m;      ///< World: the origin of the target's own frame.
  core::Vec3 velocity_mps;  ///< World, of the centre.
  core::Mat3 world_from_target;
  core::Vec3 turn_rate_radps;  ///< World: axis times rate, right-handed.
};

/// The track of an antenna in the target's own frame.
/// @param poses  one for each point of it, else std::invalid_argument
[[nodiscard]] std::vector<TrackPoint> track_from_target(const std::vector<TrackPoint>& track,
                                                        const std::vector<TargetPose>& poses);

/// The same echoes as the target sees them: the track of the antenna in the target's own frame, in which its points are
/// at rest. Distances and range rates are those of the world, so any method for synthetic apertures focuses the target;
/// back-projection does so for any motion, turning and travelling compensated exactly.
/// @param poses  one for each pulse, else std::invalid_argument
[[nodiscard]] SarEchoes seen_from_target(const SarEchoes& echoes, const std::vector<TargetPose>& poses);

/// How images of a turning target are made from a train of pulses.
struct IsarBursts {
  CoherentInterval interval;  ///< Pulses of a burst, the step between bursts, the window over a burst.
  WindowFunction range_window;
};

/// One image for each burst, by back-projection in the target's frame onto the plane of two unit vectors of that frame:
/// rows along `cross_range`, columns along `range`, about the target's centre. Range and Doppler migration through the
/// turning, the reason why long bursts blur in a plain range-Doppler map, do not occur.
/// @throw  std::invalid_argument as seen_from_target, back_project and range_doppler_maps; Interrupted
[[nodiscard]] std::vector<FocusedImage> isar_images(const SarEchoes& echoes, const std::vector<TargetPose>& poses,
                                                    const core::Vec3& cross_range, const core::Vec3& range,
                                                    const ImageAxis& cross_range_m, const ImageAxis& range_m,
                                                    const IsarBursts& bursts, const core::WorkControl& control);

/// Maps of range and Doppler of the bursts with the target's travelling taken out: the centre rests at the range it has
/// in the middle of its burst, at Doppler 0, with its amplitude. Turning is not compensated: a point x metres aside of
/// the centre has the Doppler 2 x w/lambda at the rate w, and blurs where a burst turns it through more than a cell.
/// The window of the interval weighs the pulses.
/// @throw  std::invalid_argument as seen_from_target and range_doppler_maps; Interrupted
[[nodiscard]] std::vector<RangeDopplerMap> isar_range_doppler_maps(const SarEchoes& echoes,
                                                                   const std::vector<TargetPose>& poses,
                                                                   const CoherentInterval& interval,
                                                                   const core::WorkControl& control);

/// Metres across the line of sight for each hertz of Doppler: lambda/(2 w), w the rate at which the line of sight turns
/// in the target's frame, perpendicular to it, from the first pose to the last. Infinite without turning.
[[nodiscard]] double cross_range_m_per_hz(const SarEchoes& echoes, const std::vector<TargetPose>& poses);

}  // namespace sarsim::signal
