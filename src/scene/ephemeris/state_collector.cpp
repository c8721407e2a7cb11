#include "scene/ephemeris/state_collector.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/text/letters.hpp"
#include "core/text/number_text.hpp"
#include "radar/earth/instant.hpp"
#include "scene/ephemeris/read_ephemeris.hpp"

namespace sarsim::scene::ephemeris {

namespace {

constexpr double farthest_m = 1e9;
// Doubles have steps of 1.5e-5 m there: beyond, no wavelength of a radar is told from the next.
constexpr double farthest_without_earth_m = 1e11;
// Half axes of WGS 84, less 1 km: no point of dry land is lower, and the axes of the frames differ by 100 m here.
constexpr double equator_m = 6378137.0 - 1000.0;
constexpr double pole_m = 6356752.3 - 1000.0;

bool is_below_surface(const core::Vec3& p) {
  const double across = (p.x * p.x + p.y * p.y) / (equator_m * equator_m);
  return across + p.z * p.z / (pole_m * pole_m) < 1.0;
}

bool follows(const EphemerisState& before, const EphemerisState& state) {
  return state.time > before.time || (state.time == before.time && state.since_epoch_s > before.since_epoch_s);
}

// Seconds between two states of one day; nothing for others.
std::optional<double> step_s(const EphemerisState& before, const EphemerisState& state) {
  const radar::CivilTime& a = before.time;
  const radar::CivilTime& b = state.time;
  if (a == b) return state.since_epoch_s - before.since_epoch_s;
  if (a.year != b.year || a.month != b.month || a.day != b.day) return std::nullopt;
  return radar::seconds_between(a, b);
}

}  // namespace

EphemerisSegment& StateCollector::begin_segment(std::string_view at) {
  begins_.push_back(at);
  said_.emplace_back();
  return file_.segments.emplace_back();
}

void StateCollector::add(const EphemerisState& state, std::string_view time_at, std::string_view position_at) {
  if (file_.segments.empty()) begin_segment(time_at);
  std::vector<EphemerisState>& states = file_.segments.back().states;
  if (states_ >= max_ephemeris_states) {
    if (!problems_.again(too_many_))
      too_many_ = problems_.error(time_at, {"the file has too many states", "",
                                            fmt::format("at most {}", max_ephemeris_states), "thin them out"});
    return;
  }
  check_position(state.position_m, position_at);
  if (!states.empty()) {
    const bool ascends = follows(states.back(), state);
    if (!ascends && !problems_.again(unordered_))
      unordered_ =
          problems_.error(time_at, {"times must ascend and must not repeat", core::clipped(time_at),
                                    file_.form == TimeForm::civil
                                        ? "a time after " + radar::format_civil(states.back().time)
                                        : "a time after " + core::format_number(states.back().since_epoch_s) + " s",
                                    "sort the states by time and give each time once"});
    if (ascends && states.size() == 1 && low_ == 0 && far_ == 0) check_velocity(states.back(), state, position_at);
  }
  states.push_back(state);
  at_.push_back(time_at);
  ++states_;
}

void StateCollector::check_position(const core::Vec3& position_m, std::string_view at) {
  const double distance_m = core::norm(position_m);
  if (without_earth_) {
    if (distance_m <= farthest_without_earth_m || problems_.again(far_)) return;
    far_ =
        problems_.error(at, {"a position is more than 1e11 m from the origin", fmt::format("{:.6g} m", distance_m),
                             "at most 1e11 m", fmt::format("positions are in {} from the origin of the world", unit_)});
    return;
  }
  const bool low = is_below_surface(position_m);
  if (!low && distance_m <= farthest_m) return;
  FileProblems::Mark& mark = low ? low_ : far_;
  if (problems_.again(mark)) return;
  // What is below by a factor between 20 and 2000 or beyond is probably in the other unit.
  const bool other_unit = low ? distance_m > 3e3 && distance_m < 3e5 : distance_m < 1e12;
  mark = problems_.error(
      at, {low ? "a position is below the surface of the Earth" : "a position is more than 1e9 m from the Earth",
           fmt::format("{:.6g} m from its centre", distance_m), low ? "at least 6.357e6 m" : "at most 1e9 m",
           other_unit ? fmt::format("are the numbers in another unit? {} is expected here", unit_)
                      : fmt::format("positions are in {} from the centre of the Earth", unit_)});
}

// Velocities in another unit or of another frame do not fit the positions by a factor that no orbit explains.
void StateCollector::check_velocity(const EphemerisState& before, const EphemerisState& state, std::string_view at) {
  constexpr double longest_step_s = 600.0;
  constexpr double min_mps = 100.0;
  const std::optional<double> step = step_s(before, state);
  if (!before.velocity_mps || !state.velocity_mps || !step || *step > longest_step_s || problems_.has_errors()) return;
  const double moved_mps = core::norm(state.position_m - before.position_m) / *step;
  const double speed_mps = 0.5 * (core::norm(*before.velocity_mps) + core::norm(*state.velocity_mps));
  if (std::max(moved_mps, speed_mps) < min_mps || (speed_mps < 2.0 * moved_mps && moved_mps < 2.0 * speed_mps)) return;
  if (!problems_.again(wrong_speed_))
    wrong_speed_ = problems_.warning(
        at, {"velocities do not fit the positions", fmt::format("a speed of {:.6g} m/s", speed_mps),
             fmt::format("about {:.6g} m/s, by the first two positions", moved_mps),
             fmt::format("are the velocities in {}/s, and relative to the same axes?", unit_ == "km" ? "km" : "m")});
}

void check_usable(const UsableRange& usable, const radar::CivilTime& first, const radar::CivilTime& last,
                  std::string_view at, FileProblems& problems) {
  const std::string range = fmt::format("within {} to {}", radar::format_civil(first), radar::format_civil(last));
  const char* hint = "correct the usable range or add the missing states";
  if (usable.start && (*usable.start < first || *usable.start > last))
    problems.error(
        at, {"the usable range begins where there are no states", radar::format_civil(*usable.start), range, hint});
  if (usable.stop && (*usable.stop < first || *usable.stop > last))
    problems.error(at,
                   {"the usable range ends where there are no states", radar::format_civil(*usable.stop), range, hint});
  if (usable.start && usable.stop && *usable.stop < *usable.start)
    problems.error(at, {"the usable range ends before it begins", radar::format_civil(*usable.stop),
                        "a time after " + radar::format_civil(*usable.start), ""});
}

void check_neighbours(const radar::CivilTime& end_before, const radar::CivilTime& begin, std::string_view at,
                      FileProblems& problems) {
  if (begin >= end_before) return;
  problems.error(at, {"two segments may be used at the same time", radar::format_civil(begin),
                      "a beginning at or after " + radar::format_civil(end_before),
                      "give the segments usable ranges that do not overlap, in the order of time"});
}

std::string StateCollector::time_text(const EphemerisState& state) const {
  return file_.form == TimeForm::civil ? radar::format_civil(state.time)
                                       : core::format_number(state.since_epoch_s) + " s";
}

void StateCollector::report_odd(const std::vector<OddState>& odd, const EphemerisSegment& segment,
                                const std::string_view* at) {
  if (odd.empty()) return;
  const auto size = [](const OddState& one) { return one.position_off_m; };
  const OddState& worst = *std::ranges::max_element(odd, {}, size);
  const bool of_velocity = worst.velocity_off_mps > 1e-3;
  std::string found = fmt::format("{:.4g} m{} off at {}", worst.position_off_m,
                                  of_velocity ? fmt::format(", {:.4g} m/s", worst.velocity_off_mps) : "",
                                  time_text(segment.states[worst.index]));
  if (odd.size() > 1) found += fmt::format("; {} such states", odd.size());
  problems_.warning(at[worst.index], {"a state does not fit those around it", std::move(found),
                                      "where the states before and behind it lead",
                                      "correct it or leave it out: the path goes through it"});
}

void StateCollector::report_velocities(const VelocityMismatch& mismatch, std::string_view at) {
  const double factor = mismatch.given_mps > 0.0 ? mismatch.moved_mps / mismatch.given_mps : 1.0;
  const bool other_unit = std::abs(factor / 1e3 - 1.0) < 0.1 || std::abs(factor * 1e3 - 1.0) < 0.1;
  wrong_speed_ =
      problems_.warning(at, {"velocities do not fit the positions",
                             fmt::format("a speed of {:.6g} m/s, {:.4g} m/s off", mismatch.given_mps, mismatch.off_mps),
                             fmt::format("about {:.6g} m/s, by the positions around it", mismatch.moved_mps),
                             fmt::format("are the velocities in {}/s{}", unit_ == "km" ? "km" : "m",
                                         other_unit ? "?" : ", and relative to the same axes?")});
}

// Velocities are used of all states or of none.
void StateCollector::report_missing_velocities(const EphemerisSegment& segment, const std::string_view* at,
                                               std::size_t given) {
  const auto without = [](const EphemerisState& state) { return !state.velocity_mps; };
  const auto first = std::ranges::find_if(segment.states, without) - segment.states.begin();
  const std::size_t states = segment.states.size();
  problems_.warning(at[first], {"states have no velocity: the velocities of the others are not used",
                                fmt::format("{} of {} states, the first at {}", states - given, states,
                                            time_text(segment.states[static_cast<std::size_t>(first)])),
                                "a velocity with each state, or with none",
                                "add the missing ones; without velocities the positions alone are interpolated"});
}

void StateCollector::report_gaps(const SampleSteps& steps, const EphemerisSegment& segment,
                                 const std::string_view* at) {
  gaps_ += steps.gaps.size();
  ephemeris::report_gaps(
      steps, "state", [&](std::size_t i) { return time_text(segment.states[i]); }, at, problems_);
}

void report_gaps(const SampleSteps& steps, std::string_view what,
                 const std::function<std::string(std::size_t)>& time_text, const std::string_view* at,
                 FileProblems& problems) {
  if (steps.gaps.empty()) return;
  const SampleGap& longest = *std::ranges::max_element(steps.gaps, {}, &SampleGap::length_s);
  std::string found = fmt::format("{:.6g} s behind {}", longest.length_s, time_text(longest.before));
  if (steps.gaps.size() > 1) found += fmt::format("; {} gaps", steps.gaps.size());
  problems.warning(at[longest.before + 1], {fmt::format("{}s are missing: the file has a gap", what), std::move(found),
                                            fmt::format("one every {:.6g} s", steps.usual_s),
                                            "a recording within a gap is interpolated over more than a step"});
}

// What a segment says twice; at `at_` are the places of its states.
void StateCollector::examine(std::size_t segment) {
  const EphemerisSegment& one = file_.segments[segment];
  std::size_t before = 0;
  for (std::size_t i = 0; i < segment; ++i) before += file_.segments[i].states.size();
  const std::string_view* const at = &at_[before];
  std::vector<double> time_s;
  std::vector<core::Vec3> position_m, velocity_mps;
  const EphemerisState& first = one.states.front();
  const auto start = radar::instant_of(first.time, file_.scale).instant;
  for (const EphemerisState& state : one.states) {
    const auto now = start ? radar::instant_of(state.time, file_.scale).instant : start;
    time_s.push_back(file_.form == TimeForm::since_epoch ? state.since_epoch_s - first.since_epoch_s
                     : now                               ? radar::seconds_between(*start, *now)
                                                         : radar::seconds_between(first.time, state.time));
    position_m.push_back(state.position_m);
    if (state.velocity_mps) velocity_mps.push_back(*state.velocity_mps);
  }
  if (velocity_mps.size() != position_m.size()) {
    if (!velocity_mps.empty()) report_missing_velocities(one, at, velocity_mps.size());
    velocity_mps.clear();
  }
  const StateFindings findings = examine_states({time_s, position_m, velocity_mps});
  if (usual_step_s_ == 0.0) usual_step_s_ = findings.steps.usual_s;
  if (findings.velocities && wrong_speed_ == 0) report_velocities(*findings.velocities, at[findings.velocities->worst]);
  report_odd(findings.odd, one, at);
  report_gaps(findings.steps, one, at);
  if (file_.form == TimeForm::civil)
    check_typed_times(said_[segment], first.time, one.states.back().time,
                      time_s.size() < 3 ? time_s.back() : findings.steps.usual_s, problems_);
}

void check_typed_times(const TypedTimes& said, const radar::CivilTime& first, const radar::CivilTime& last,
                       double step_s, FileProblems& problems) {
  const auto check = [&](const TypedTime& one, const radar::CivilTime& time, const char* which) {
    if (!one.time || std::abs(radar::seconds_between(*one.time, time)) <= std::max(step_s, 1.0)) return;
    problems.warning(
        one.at, {fmt::format("{} is not the time of the {} sample", one.key, which), radar::format_civil(*one.time),
                 radar::format_civil(time), "the samples count; is the file complete, and of one piece?"});
  };
  check(said.first, first, "first");
  check(said.last, last, "last");
}

void StateCollector::finish(std::string_view at) {
  // What follows from other mistakes is not said.
  const bool comparable = file_.form == TimeForm::civil && !problems_.has_errors();
  if (comparable) check_segments(file_.segments, begins_, problems_);
  for (std::size_t i = 0; i < file_.segments.size() && !problems_.has_errors(); ++i)
    if (!file_.segments[i].states.empty()) examine(i);
  std::erase_if(file_.segments, [](const EphemerisSegment& segment) { return segment.states.empty(); });
  if (file_.segments.empty() && !problems_.has_errors())
    problems_.error(at, {"the file holds no states", "", "times with positions", ""});
}

}  // namespace sarsim::scene::ephemeris
