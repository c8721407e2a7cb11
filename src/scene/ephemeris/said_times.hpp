#pragma once

#include <optional>
#include <string_view>

#include "radar/earth/civil_time.hpp"
#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// A time that the head of a file gives for its first or last sample.
struct SaidTime {
  std::string_view key;  ///< What the file calls it: "START_TIME".
  std::optional<radar::CivilTime> time;
  std::string_view at;  ///< Where the file has it.
};

/// When the samples begin and end by the head of a file.
struct SaidTimes {
  SaidTime first;
  SaidTime last;
};

/// Reports a said time that is more than a step from that of the sample, by a warning each.
/// @param first   time of the first sample
/// @param step_s  usual time from one sample to the next; 1 s where that is shorter
void check_said_times(const SaidTimes& said, const radar::CivilTime& first, const radar::CivilTime& last, double step_s,
                      FileProblems& problems);

}  // namespace sarsim::scene::ephemeris
