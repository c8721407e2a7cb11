#pragma once

#include <cstddef>
#include <vector>

#include "base/problem.hpp"
#include "scene/scene.hpp"
#include "simulate/plan.hpp"

namespace sarsim {

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
};

/// A quick look at the echoes of a simulation: at most 64 of its pulses (3 where there are
/// very many targets), all targets. An estimate: what happens between
/// the sampled pulses is not seen.
struct EchoSurvey {
  std::size_t pulses_sampled = 0;
  bool all_pulses = false;  ///< Every pulse was looked at.
  std::vector<TargetSurvey> targets;
  double lowest_doppler_hz = 0.0;  ///< Over the echoes that touch the window.
  double highest_doppler_hz = 0.0;
  std::vector<bool> surface_faces_radar;  ///< Per surface: it shows its front in some sampled pulse.
  double largest_sum_v =
      0.0;  ///< Largest over the pulses of the sum of the amplitudes in the window: a bound for raw data.
};

[[nodiscard]] EchoSurvey survey_echoes(const Plan& plan);

/// Warnings and errors that need the echoes of every simulation in the scene: all echoes outside the window (and where
/// they are), PRF below the Doppler band, LSB that clips or wastes more than half the range, targets whose echo is
/// impossible (at the radar's position, faster than light, too strong), echoes beyond the PRI, surfaces that show their
/// back, a window function without weight. The scene must have passed `check`.
[[nodiscard]] Problems survey(const Scene& scene);

}  // namespace sarsim
