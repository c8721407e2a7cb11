#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/report/problem.hpp"
#include "scene/ephemeris/motion_sample.hpp"

/// What the writers of motions have in common.
namespace sarsim::scene::ephemeris {

/// Times of dates must be so far apart, s.
inline constexpr double closest_dates_s = 1e-12;

/// What is wrong with the list of samples as a whole; nothing for a sound number of them.
[[nodiscard]] std::optional<core::Problem> fault_of_count(std::size_t count);
/// What is wrong with one time behind another.
/// @param sample     number of the sample, from 0
/// @param closest_s  times must be so far apart; 0 where they must ascend
[[nodiscard]] std::optional<core::Problem> fault_of_time(std::size_t sample, std::optional<double> before_s,
                                                         double time_s, double closest_s);

/// Both, of all samples of a list.
template <class Sample>
[[nodiscard]] std::optional<core::Problem> fault_of_times(std::span<const Sample> samples, double closest_s) {
  if (std::optional<core::Problem> fault = fault_of_count(samples.size())) return fault;
  std::optional<double> before_s;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::optional<core::Problem> fault = fault_of_time(i, before_s, samples[i].time_s, closest_s)) return fault;
    before_s = samples[i].time_s;
  }
  return std::nullopt;
}

/// What is wrong with samples of a motion: times, numbers, and, with an Earth, places where no orbit is.
[[nodiscard]] std::optional<core::Problem> fault_of_motion(std::span<const MotionSample> samples,
                                                           const MotionFacts& facts, double closest_s);

/// What keeps a CCSDS message from being written: no epoch or Earth, names and dates that cannot stand in it, and times
/// that the calendar of UTC cannot give.
/// @param first_s  of the samples; ascending
[[nodiscard]] std::optional<core::Problem> fault_of_message(double first_s, double last_s, const MotionFacts& facts);

/// A file that is refused.
[[nodiscard]] inline MotionText refused(core::Problem problem) { return {{}, {std::move(problem)}}; }

/// Adds three numbers, each behind a separator. Metres become kilometres by a shift of -3, and reading moves the
/// exponent back, so that no bit is lost.
void append_vector(std::string& text, const core::Vec3& v, std::string_view separator, int exponent_shift);

/// A time in UTC as CCSDS messages have it, without a Z: the shortest text of 12 to 15 decimals, zeros at its end left
/// out, that gives the same double of seconds after the epoch where there is one, otherwise 15 decimals.
[[nodiscard]] std::string stamp_of(const radar::Instant& epoch, double time_s);

/// The header of a CCSDS message up to OBJECT_ID and CENTER_NAME.
/// @param version_key  "CCSDS_OEM_VERS"
[[nodiscard]] std::string message_head(std::string_view version_key, std::string_view version, std::string_view comment,
                                       const MotionFacts& facts);
/// The lines of a block of metadata about its times: TIME_SYSTEM, START_TIME, STOP_TIME.
[[nodiscard]] std::string time_lines(double first_s, double last_s, const radar::Instant& epoch);
/// The word of CCSDS for a method: "HERMITE"; empty for none.
[[nodiscard]] std::string_view word_of(InterpolationMethod method);
/// The lines about the interpolation; none where nothing is to be said.
/// @param method_key  "INTERPOLATION"
[[nodiscard]] std::string interpolation_lines(std::string_view method_key, const InterpolationHint& interpolation);

}  // namespace sarsim::scene::ephemeris
