#pragma once

#include "base/parallel.hpp"
#include "simulate/search_intervals.hpp"

namespace sarsim {

/// What keeps the pulses of a plan from being worked on so, all at once: synthetic range profiles; intervals or a
/// canceller over pulses that are not evenly spaced or change their carrier; more pulses than there are; fewer
/// frequencies than pulses, or more of single pulses; no reference cells.
[[nodiscard]] Problems problems_of_search(const Plan& plan, const SearchOptions& options);

/// What a user should know before, without errors: targets beyond the unambiguous Doppler frequencies and ranges, at
/// blind speeds of the canceller, that walk through range cells; a beam that turns farther in an interval than it is
/// wide; no noise to hold detections against; reference cells over unlike Doppler rows. Looks at some pulses of the
/// plan.
[[nodiscard]] Problems remarks_on_search(const Plan& plan, const SearchOptions& options,
                                         const WorkControl& control = {});

/// Width of the radar's beam in azimuth, one way, rad; 0 where the pattern has none or is given by points.
[[nodiscard]] double beam_width_rad(const Plan& plan);

/// Pulses that leave while a rotating beam turns by half its width, 1 to 64; 1 where it does not rotate or has no
/// width.
[[nodiscard]] std::size_t dwell_pulses(const Plan& plan);

}  // namespace sarsim
