#pragma once

#include <optional>

#include "core/task/parallel.hpp"
#include "workflow/search/search_intervals.hpp"

namespace sarsim::workflow {

/// What keeps the pulses of a plan from being worked on so, all at once: synthetic range profiles; intervals or a
/// canceller over pulses that are not evenly spaced or change their carrier; more pulses than there are; fewer
/// frequencies than pulses, or more of single pulses; no reference cells.
[[nodiscard]] core::Problems problems_of_search(const simulate::Acquisition& acquisition, const SearchOptions& options);

/// What a user should know before, without errors: targets beyond the unambiguous Doppler frequencies and ranges, at
/// blind speeds of the canceller, that walk through range cells; a beam that turns farther in an interval than it is
/// wide, or not at all, for intervals of single pulses; last pulses of its only turn that make no interval (a note); no
/// noise to hold detections against; reference cells over unlike Doppler rows. Looks at some pulses of the acquisition.
[[nodiscard]] core::Problems diagnose_search(const simulate::Acquisition& acquisition, const SearchOptions& options,
                                             const core::WorkControl& control = {});

/// Width of the radar's beam in azimuth, one way, rad; 0 where the pattern has none or is given by points.
[[nodiscard]] double beam_width_rad(const simulate::Acquisition& acquisition);

/// Width that a beam is taken for where it has to have one, rad: `beam_width_rad`, or a degree.
[[nodiscard]] double seen_width_rad(const simulate::Acquisition& acquisition);

/// Half the azimuth sector of the beam about its axis, rad, at the half-power points (one way) of the narrower of its
/// two antennas: for sin(x)/x half the beamwidth, for cuts by points the farthest angle at half power or more. Nothing
/// if both are isotropic.
[[nodiscard]] std::optional<double> half_beam_rad(const simulate::Acquisition& acquisition);

/// Whether the beam's axis moves in azimuth by more than `seen_width_rad` between some pulses of the acquisition,
/// whatever turns it.
[[nodiscard]] bool beam_turns(const simulate::Acquisition& acquisition);

/// Pulses that leave while a rotating beam turns by half its width, 1 to 64; 1 where it does not rotate or has no
/// width.
[[nodiscard]] std::size_t dwell_pulses(const simulate::Acquisition& acquisition);

}  // namespace sarsim::workflow
