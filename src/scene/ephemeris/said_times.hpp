#pragma once

#include <optional>
#include <string_view>

#include "radar/earth/civil_time.hpp"
#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// A time that the header of a file gives for its first or last sample.
struct TypedTime {
  std::string_view key;  ///< What the file calls it: "START_TIME".
  std::optional<radar::CivilTime> time;
  std::string_view at;  ///< Where the file has it.
};

/// Times of the first and the last sample according to the header of a file.
struct TypedTimes {
  TypedTime first;
  TypedTime last;
};

/// Warns of each time in the header that differs by more than a step from that of the sample.
/// @param first   time of the first sample
/// @param last    time of the last sample
/// @param step_s  usual time from one sample to the next; at least 1 s is tolerated
void check_typed_times(const TypedTimes& said, const radar::CivilTime& first, const radar::CivilTime& last,
                       double step_s, FileProblems& problems);

}  // namespace sarsim::scene::ephemeris
