#pragma once

#include <span>
#include <string>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"

namespace sarsim::workflow {

/// What is wrong with a motion that is to be believed in place of that of the recording, pulse by pulse.
///
/// Errors: it is farther from the recording's own track than the farthest range that was recorded; it flies the other
/// way (the mean of the cosines between both, weighted by their steps, is below 0); its way is more than twice or less
/// than half as long. Warnings, from what navigation systems do not lose within a recording on: a hundredth of the
/// farthest range away, a way that is a hundredth longer or shorter, a direction 1 degree off. Ways and directions are
/// compared over 64 parts of the recording, where the antenna goes a meter or more.
/// @param name        of the file
/// @param recorded    the track of the recording
/// @param believed    the other one, of the same pulses
/// @param farthest_m  slant range of the last sample
[[nodiscard]] core::Problems problems_of_navigation(const std::string& name,
                                                    std::span<const signal::TrackPoint> recorded,
                                                    std::span<const signal::TrackPoint> believed, double farthest_m);

}  // namespace sarsim::workflow
