#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "radar/waveform/schedule.hpp"

namespace sarsim::workflow {

/// The carriers of a burst as evenly spaced frequencies: f(n) = first + step order[floor((n mod B)/p)], B = S p.
struct SteppedGrid {
  double first_hz = 0.0;
  double step_hz = 0.0;             ///< 0 where there is one carrier; negative where they step down.
  std::size_t steps = 1;            ///< S
  std::size_t pulses_per_step = 1;  ///< p
  std::vector<std::size_t> order;   ///< Of the S places of a burst, where carriers hop; empty: in turn.

  [[nodiscard]] std::int64_t burst_pulses() const { return static_cast<std::int64_t>(steps * pulses_per_step); }
};

/// The grid of a plan of carriers: that of its steps; of a list the one that its carriers lie on, each as often in a
/// row, where they are evenly spaced to 1e-12 of the carrier. Nothing for a list that has none.
/// @param pulse  one that is sent; of a single carrier its frequency counts
[[nodiscard]] std::optional<SteppedGrid> stepped_grid(const radar::CarrierPlan& carrier, std::int64_t pulse);

}  // namespace sarsim::workflow
