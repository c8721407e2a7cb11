#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/ephemeris/ephemeris_file.hpp"
#include "scene/ephemeris/file_problems.hpp"
#include "scene/ephemeris/said_times.hpp"
#include "scene/ephemeris/state_consistency.hpp"

namespace sarsim::scene::ephemeris {

/// Adds states to an ephemeris and reports impossible ones: times that do not ascend, positions below the surface of
/// the Earth or beyond 1e9 m (1e11 m in a world without an Earth), too many states; and contradictions
/// (`examine_states`): states that do not fit their neighbours, velocities that are not the derivatives of the
/// positions, gaps, header times that are not those of the states. Reports each kind once, with a count.
class StateCollector {
 public:
  /// @param unit           of positions in the file, for messages: "km"
  /// @param without_earth  positions may be anything
  StateCollector(EphemerisFile& file, FileProblems& problems, std::string_view unit, bool without_earth = false)
      : file_(file), problems_(problems), unit_(unit), without_earth_(without_earth) {}

  /// Begins a segment, in which times ascend anew.
  /// @param at  the line at which it begins
  EphemerisSegment& begin_segment(std::string_view at);

  /// Adds a state to the last segment, or begins one where there is none.
  /// @param time_at      where the time stands in the text
  /// @param position_at  where the position stands
  void add(const EphemerisState& state, std::string_view time_at, std::string_view position_at);

  /// Sets the times that the header gives for the last segment.
  void typed_times(const TypedTimes& said) {
    if (!said_.empty()) said_.back() = said;
  }

  /// Where the segments end: drops empty ones and reports that no states remain, and usable ranges that reach beyond
  /// the states or overlap; compares redundant data of the file.
  /// @param at  where the last line stands, or what else is to blame for missing states
  void finish(std::string_view at);

  /// The usual step of the first segment with three states; 0 before `finish`.
  [[nodiscard]] double usual_step_s() const { return usual_step_s_; }

  /// Whether nothing more should be read.
  [[nodiscard]] bool full() const { return problems_.full() || too_many_ != 0; }

 private:
  void check_position(const core::Vec3& position_m, std::string_view at);
  void check_velocity(const EphemerisState& before, const EphemerisState& state, std::string_view at);
  void examine(std::size_t segment);
  void report_odd(const std::vector<OddState>& odd, const EphemerisSegment& segment, const std::string_view* at);
  void report_velocities(const VelocityMismatch& mismatch, std::string_view at);
  void report_missing_velocities(const EphemerisSegment& segment, const std::string_view* at, std::size_t given);
  void report_gaps(const SampleSteps& steps, const EphemerisSegment& segment, const std::string_view* at);
  [[nodiscard]] std::string time_text(const EphemerisState& state) const;

  EphemerisFile& file_;
  FileProblems& problems_;
  std::string unit_;
  bool without_earth_;
  std::vector<std::string_view> begins_;  // of the segments
  std::vector<TypedTimes> said_;          // of the segments
  std::vector<std::string_view> at_;      // of the states, all segments
  std::size_t states_ = 0;
  FileProblems::Mark unordered_ = 0;
  FileProblems::Mark low_ = 0;
  FileProblems::Mark far_ = 0;
  FileProblems::Mark wrong_speed_ = 0;
  FileProblems::Mark too_many_ = 0;
  std::size_t gaps_ = 0;
  double usual_step_s_ = 0.0;
};

/// Reports the longest gap of a segment, with the number of gaps.
/// @param what       a sample: "state"
/// @param time_text  of a sample, for people
/// @param at         where the samples of the segment stand
void report_gaps(const SampleSteps& steps, std::string_view what,
                 const std::function<std::string(std::size_t)>& time_text, const std::string_view* at,
                 FileProblems& problems);

/// Reports usable ranges whose ends are not in order or reach beyond the data, for one segment.
/// @param first  time of the first state
/// @param at     where the segment stands
void check_usable(const UsableRange& usable, const radar::CivilTime& first, const radar::CivilTime& last,
                  std::string_view at, FileProblems& problems);

/// Reports a segment whose times begin before those of the segment before it end.
void check_neighbours(const radar::CivilTime& end_before, const radar::CivilTime& begin, std::string_view at,
                      FileProblems& problems);

/// Reports both of all segments of a file, of orbits or of attitudes; those without states are passed over.
/// @param begins  where each segment stands
template <class Segment>
void check_segments(const std::vector<Segment>& segments, const std::vector<std::string_view>& begins,
                    FileProblems& problems) {
  const Segment* before = nullptr;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    if (segment.states.empty()) continue;
    const radar::CivilTime& first = segment.states.front().time;
    check_usable(segment.usable, first, segment.states.back().time, begins[i], problems);
    if (before != nullptr && !problems.has_errors())
      check_neighbours(before->usable.stop.value_or(before->states.back().time), segment.usable.start.value_or(first),
                       begins[i], problems);
    before = &segment;
  }
}

}  // namespace sarsim::scene::ephemeris
