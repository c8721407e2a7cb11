#pragma once

#include <limits>

#include "core/task/stop.hpp"
#include "radar/waveform/schedule.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// One-way ranges of delays, c tau/2, from the nearest to the farthest echo; reversed where there is none.
struct RangeExtent {
  double nearest_m = std::numeric_limits<double>::infinity();
  double farthest_m = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return !(nearest_m <= farthest_m); }
};

/// Where the echoes of all targets and surfaces lie, at at most 17 of the pulses, evenly spread, first and last among
/// them. Of surfaces the distances of the points count. Targets whose delay cannot be computed do not count.
/// @param stop  asked now and then; a requested stop throws Interrupted
[[nodiscard]] RangeExtent target_ranges(const ResolvedScene& scene, const Link& radar, const radar::PulseRange& pulses,
                                        const core::StopFlag* stop = nullptr);

}  // namespace sarsim::simulate
