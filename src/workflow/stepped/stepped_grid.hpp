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
  std::vector<std::size_t> order;   ///< Step at each of the S positions in a burst, if carriers hop; empty: in turn.

  [[nodiscard]] std::int64_t burst_pulses() const { return static_cast<std::int64_t>(steps * pulses_per_step); }
};

/// The grid of a carrier plan: that of its steps; for a list, the grid of its carriers if they are evenly spaced to
/// 1e-12 of the carrier and each is sent equally often in a row. Nothing for other lists, and for lists of more than
/// 2^15 entries.
/// @param pulse  a pulse that is sent; its frequency is used for a single carrier
[[nodiscard]] std::optional<SteppedGrid> stepped_grid(const radar::CarrierPlan& carrier, std::int64_t pulse);

}  // namespace sarsim::workflow
