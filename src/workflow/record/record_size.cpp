#include "workflow/record/record_size.hpp"

#include "raster/format/sinks.hpp"
#include "raster/table/formats.hpp"
#include "workflow/record/known_machine.hpp"

namespace sarsim::workflow {

bool seeks_lsb(const scene::Simulation& simulation, bool counts) {
  return !(simulation.lsb_v > 0.0) && raster::holds_counts(simulation.format, counts);
}

double passes_of(const scene::Simulation& simulation, bool counts) { return seeks_lsb(simulation, counts) ? 2.0 : 1.0; }

double estimated_seconds(const simulate::Plan& plan, unsigned threads, double passes) {
  return simulate::estimated_cost(plan, threads, known_machine()).seconds * passes;
}

RecordingSize size_of(const simulate::Plan& plan, unsigned threads, bool counts) {
  const simulate::Cost cost = simulate::estimated_cost(plan, threads, known_machine());
  RecordingSize size;
  size.bytes = raster::expected_bytes(simulate::product_of(plan, {}),
                                      {plan.acquisition.simulation.format, false, counts, false});
  size.memory_bytes = cost.memory_bytes;
  size.echoes = cost.echoes;
  size.seconds = cost.seconds * passes_of(plan.acquisition.simulation, counts);
  return size;
}

double min_table_bytes(const scene::Scene& scene, const simulate::ResolvedScene& resolved,
                       const scene::GeometryTable& table) {
  const std::size_t radar = scene::find_radar(scene, table.radar);
  if (radar == scene::not_found) return 0.0;
  const radar::PulseRange pulses =
      simulate::resolve_radar(scene, resolved, radar).repetition.pulses_in(table.time_start_s, table.time_end_s);
  return 10.0 * static_cast<double>(pulses.count());
}

}  // namespace sarsim::workflow
