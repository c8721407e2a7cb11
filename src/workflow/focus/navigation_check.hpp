#pragma once

#include <span>
#include <string>

#include "core/report/problem.hpp"
#include "signal/sar/focusing.hpp"

namespace sarsim::workflow {

/// Checks a navigation track, which replaces that of the recording, against it, pulse by pulse.
///
/// Errors: it is farther from the recording's own track than the farthest recorded range; it has the opposite direction
/// (the mean cosine between both, weighted by their steps, is below 0); it is more than twice or less than half as
/// long. Warnings, where the difference exceeds what navigation systems drift within a recording: a hundredth of the
/// farthest range away, 1 % longer or shorter, 1 degree off in direction. Lengths and directions are compared over 64
/// parts of the recording, if the antenna moves by more than a metre.
/// @param name        of the file
/// @param recorded    the track of the recording
/// @param believed    the other one, of the same pulses
/// @param farthest_m  slant range of the last sample
[[nodiscard]] core::Problems problems_of_navigation(const std::string& name,
                                                    std::span<const signal::TrackPoint> recorded,
                                                    std::span<const signal::TrackPoint> believed, double farthest_m);

}  // namespace sarsim::workflow
