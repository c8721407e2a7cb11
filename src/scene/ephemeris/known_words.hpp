#pragma once

#include <optional>
#include <string_view>

#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/ephemeris/file_problems.hpp"

namespace sarsim::scene::ephemeris {

/// The frame that a CCSDS message names; reports one that is not known.
/// @param at  the word in the text
[[nodiscard]] std::optional<Frame> read_frame(std::string_view at, FileProblems& problems);

/// The time scale that a CCSDS message names; reports one that is not known.
[[nodiscard]] std::optional<radar::TimeScale> read_scale(std::string_view at, FileProblems& problems);

/// The method of interpolation that a CCSDS message names; warns of one that is not known.
[[nodiscard]] InterpolationMethod read_interpolation(std::string_view at, FileProblems& problems);

/// Reads a time, with or without a Z; reports text that is none, and a leap second in a scale that has no such seconds.
/// @param words  what it is: "time of a state"
[[nodiscard]] bool read_time(std::string_view at, std::string_view words, std::optional<radar::TimeScale> scale,
                             FileProblems& problems, radar::CivilTime& time);

}  // namespace sarsim::scene::ephemeris
