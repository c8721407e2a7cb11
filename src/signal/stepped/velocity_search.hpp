#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/stepped/profile_maker.hpp"

namespace sarsim::signal {

/// The pulses of some bursts.
struct BurstEchoes {
  std::vector<double> time_s;                ///< When each pulse leaves, burst after burst.
  std::vector<std::complex<double>> values;  ///< As SteppedBand::place makes them, burst after burst.

  [[nodiscard]] std::size_t bursts(const SteppedBand& band) const {
    return time_s.size() / band.waveform().burst_pulses();
  }
};

/// What takes the motion of a target of constant radial speed out of a burst.
/// @param time_s  of its pulses
/// @param at_s    the target is then seen where it is at that time
[[nodiscard]] std::vector<PulseMotion> motion_of_speed(std::span<const double> time_s, double at_s, double speed_mps,
                                                       double light_speed_mps);

/// Middle of the first and last of some times.
[[nodiscard]] double middle_of(std::span<const double> time_s);

/// The speed that sharpens the profiles of some bursts most.
struct VelocityEstimate {
  double speed_mps = 0.0;
  double entropy = 0.0;          ///< Of the mean of the profiles' powers, their motion taken out.
  double entropy_at_rest = 0.0;  ///< The same for speed 0.
  double uncertainty_mps = 0.0;  ///< The last spacing of the search: what noise and a turning target add is not in it.
};

/// Speeds that the first round of a search tries at the most.
inline constexpr double max_searched_speeds = 20000.0;

/// Spacing of the speeds that a search over some time begins with: c/(8 B) over that time, a quarter of a cell.
[[nodiscard]] double first_speed_step_mps(const SteppedBand& band, double span_s);

/// The one speed that makes profiles sharpest: the entropy of their mean power is least where the smear within bursts
/// and the walk from burst to burst are both taken out. Searched in rounds, first in the middle burst alone over the
/// whole interval at steps of half a cell's smear, then over more and more bursts at steps of half a cell's walk about
/// the eight that were best before. The same bytes for any number of threads.
///
/// @param echoes  of one burst or more
/// @throw  std::invalid_argument where the sizes contradict the band, the interval is empty or the first round would
/// try
///         more than `max_searched_speeds`; Interrupted
[[nodiscard]] VelocityEstimate estimate_velocity(const ProfileMaker& maker, const BurstEchoes& echoes, double from_mps,
                                                 double to_mps, const core::WorkControl& control);

}  // namespace sarsim::signal
