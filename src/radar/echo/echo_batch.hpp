#pragma once

#include <cstddef>
#include <vector>

namespace sarsim::radar {

/// The echoes of one pulse, target by target.
struct EchoBatch {
  std::vector<double> delay_s;  ///< Two-way delay tau.
  std::vector<double>
      amplitude_sqrt_w;  ///< Square root of the received power; negative where a pattern's side lobe turns the phase.
  std::vector<double> speed_mps;  ///< Radial speed v at the send time, positive receding.

  /// Forgets the echoes; their room is kept.
  void clear() {
    delay_s.clear();
    amplitude_sqrt_w.clear();
    speed_mps.clear();
  }
  /// Adds an echo: seconds, root of watts, metres per second.
  void add(double delay, double amplitude, double speed) {
    delay_s.push_back(delay);
    amplitude_sqrt_w.push_back(amplitude);
    speed_mps.push_back(speed);
  }
  [[nodiscard]] std::size_t size() const { return delay_s.size(); }
};

/// Times of the samples of a row: two-way, from the send time of the pulse.
struct SampleGrid {
  double first_s = 0.0;
  double interval_s = 1.0;
  std::size_t count = 0;

  [[nodiscard]] double time_s(std::size_t i) const { return first_s + static_cast<double>(i) * interval_s; }
};

}  // namespace sarsim::radar
