#include "simulate/plan/timing.hpp"

#include <algorithm>

namespace sarsim::simulate {

Timing timing_of(const Link& link, const scene::Simulation& simulation) {
  Timing timing;
  timing.pulses = link.repetition.pulses_in(simulation.time_start_s, simulation.time_end_s);
  if (simulation.processing == scene::Processing::srp)
    timing.row_pulses = std::int64_t{link.carrier.steps()} * link.carrier.pulses_per_step();
  timing.first_row_at = radar::floor_divide(timing.pulses.first + timing.row_pulses - 1, timing.row_pulses);
  const std::int64_t end = radar::floor_divide(timing.pulses.last + 1, timing.row_pulses);
  const std::int64_t rows = std::max<std::int64_t>(0, end - timing.first_row_at);
  timing.dropped_pulses = timing.pulses.count() - rows * timing.row_pulses;
  timing.rows = static_cast<std::size_t>(rows);
  return timing;
}

}  // namespace sarsim::simulate
