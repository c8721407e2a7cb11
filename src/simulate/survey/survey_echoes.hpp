#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/task/parallel.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/resolve/impossible_echo.hpp"

namespace sarsim::simulate {

/// What the sampled pulses of a simulation say about one target.
struct TargetSurvey {
  double nearest_m = 0.0;  ///< One-way range of its delay, c tau/2.
  double farthest_m = 0.0;
  double lowest_doppler_hz = 0.0;  ///< -2 v f/c: positive approaching.
  double highest_doppler_hz = 0.0;
  double largest_amplitude_v = 0.0;
  double largest_speed_mps = 0.0;  ///< Radial, without its sign.
  double snr = 0.0;        ///< P Tp/(k T) at the largest amplitude, per pulse after a matched filter; 0 without noise.
  bool in_window = false;  ///< Some sampled echo touches the window.
  bool hidden = false;     ///< The Earth stands before it at all sampled pulses; its echoes are computed all the same.

  friend bool operator==(const TargetSurvey&, const TargetSurvey&) = default;
};

/// What all targets of a survey have in common.
struct SurveyTotals {
  bool any_in_window = false;
  double nearest_m = std::numeric_limits<double>::infinity();
  double farthest_m = -std::numeric_limits<double>::infinity();
  double strongest_v = 0.0;  ///< Of the targets in the window.
  double weakest_v = std::numeric_limits<double>::infinity();
  std::size_t strongest = 0;            ///< Which target that is, ...
  std::size_t weakest = 0;              ///< ... and which has the weakest echo.
  std::size_t in_window = 0;            ///< Targets some sampled echo of which touches the window.
  std::size_t hidden = 0;               ///< Targets behind the Earth, ...
  std::size_t hidden_in_window = 0;     ///< ... and of them those in the window.
  std::size_t first_hidden = 0;         ///< Which target is the first of them.
  std::size_t late = 0;                 ///< Targets in the window that lie beyond the unambiguous range.
  double latest_m = 0.0;                ///< The farthest of them.
  std::vector<std::size_t> impossible;  ///< Targets whose echo cannot be computed, in order.

  friend bool operator==(const SurveyTotals&, const SurveyTotals&) = default;
};

/// A pulse at which the echo of a target cannot be computed.
struct ImpossiblePulse {
  std::size_t target = 0;
  std::int64_t pulse = 0;  ///< In the radar's schedule.
  double time_s = 0.0;     ///< At which it is sent.
  EchoExtremes echo;
};

/// A quick look at the echoes of a simulation: at most 64 of its pulses (3 where there are very many targets), all
/// targets, and up to five passes of a rotating beam over each target. An estimate: what happens between the sampled
/// pulses is not seen, but for a radar that comes to the place of a target.
struct EchoSurvey {
  std::size_t pulses_sampled = 0;
  bool all_pulses = false;  ///< Every pulse was looked at.
  std::vector<TargetSurvey> targets;
  SurveyTotals totals;
  std::vector<ImpossiblePulse> impossible;  ///< Where that is so at some pulses, by target (`impossible_pulses`).
  double lowest_doppler_hz = 0.0;           ///< Over the echoes that touch the window.
  double highest_doppler_hz = 0.0;
  std::vector<bool> surface_faces_radar;  ///< Per surface: it shows its front in some sampled pulse.
  double largest_sum_v =
      0.0;  ///< Largest over the pulses of the sum of the amplitudes in the window: a bound for raw data.
};

/// Farthest one-way range whose echo arrives before the next pulse leaves, at the shortest interval.
[[nodiscard]] double unambiguous_range_m(const Acquisition& acquisition);

/// A target nearer than this stands on the radar.
inline constexpr double closest_echo_m = 1e-9;

/// What decides whether the echo of a target can be computed.
[[nodiscard]] EchoExtremes extremes_of(const TargetSurvey& target);

/// Looks at the echoes of a plan; the outcome is the same for any number of threads. A requested stop throws
/// Interrupted.
[[nodiscard]] EchoSurvey survey_echoes(const Acquisition& acquisition, const core::WorkControl& control = {});

/// At most `most` (3 or more) targets that the window of a survey meets: all of them, or an even choice with the
/// strongest and the weakest. Ascending.
[[nodiscard]] std::vector<std::size_t> targets_in_window(const EchoSurvey& survey, std::size_t most);

}  // namespace sarsim::simulate
