#pragma once

#include <cstddef>
#include <vector>

#include "core/os/aligned_vector.hpp"
#include "radar/echo/pulse_clock.hpp"

namespace sarsim::radar {

/// The echoes of one pulse, target by target.
struct EchoBatch {
  core::AlignedVector<double> delay_s;  ///< Two-way delay tau.
  core::AlignedVector<double>
      amplitude_sqrt_w;  ///< Square root of the received power; negative where a pattern's side lobe turns the phase.
  core::AlignedVector<double> doppler;  ///< D, the share by which the echo is longer than the pulse: positive receding.
  core::AlignedVector<double> dilation_rate;  ///< a, what D changes by in a second; empty where that does not count.
  /// phi, the turns by which the carrier is ahead of exp(-j 2 pi f tau): the phase path through electrons is shorter
  /// than that of the pulse. Empty where all are 0.
  core::AlignedVector<double> ahead_turns;

  /// Forgets the echoes; their room is kept.
  void clear() { resize(0, false); }
  /// Makes room for so many echoes, with or without their bends and the turns by which they are ahead.
  void resize(std::size_t count, bool bends, bool ahead = false) {
    delay_s.resize(count);
    amplitude_sqrt_w.resize(count);
    doppler.resize(count);
    dilation_rate.resize(bends ? count : 0);
    ahead_turns.resize(ahead ? count : 0);
  }
  /// Adds an echo: seconds, root of watts, D. The others must have no bends.
  void add(double delay, double amplitude, double echo_doppler) {
    delay_s.push_back(delay);
    amplitude_sqrt_w.push_back(amplitude);
    doppler.push_back(echo_doppler);
  }
  /// Adds an echo with its bend; the others must have theirs.
  void add(double delay, double amplitude, const PulseClock& clock) {
    add(delay, amplitude, clock.doppler);
    dilation_rate.push_back(clock.dilation_rate);
  }
  [[nodiscard]] std::size_t size() const { return delay_s.size(); }
  /// How echo k is stretched.
  [[nodiscard]] PulseClock clock(std::size_t k) const {
    return {doppler[k], dilation_rate.empty() ? 0.0 : dilation_rate[k]};
  }
  /// By how many turns the carrier of echo k is ahead.
  [[nodiscard]] double ahead(std::size_t k) const { return ahead_turns.empty() ? 0.0 : ahead_turns[k]; }
  /// By how many turns a carrier of f is late at the delay of echo k: f tau - phi.
  [[nodiscard]] double late_turns(std::size_t k, double carrier_hz) const { return carrier_hz * delay_s[k] - ahead(k); }
  /// Whether all columns have the same length.
  [[nodiscard]] bool is_whole() const {
    return amplitude_sqrt_w.size() == size() && doppler.size() == size() &&
           (dilation_rate.empty() || dilation_rate.size() == size()) &&
           (ahead_turns.empty() || ahead_turns.size() == size());
  }
};

/// Times of the samples of a row: two-way, from the send time of the pulse.
struct SampleGrid {
  double first_s = 0.0;
  double interval_s = 1.0;
  std::size_t count = 0;

  [[nodiscard]] double time_s(std::size_t i) const { return first_s + static_cast<double>(i) * interval_s; }
};

}  // namespace sarsim::radar
