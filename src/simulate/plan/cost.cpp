#include <algorithm>

#include "core/report/expect.hpp"
#include "simulate/plan/cost_of_pulse.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/pulse_geometry.hpp"

namespace sarsim::simulate {

namespace {

// Seconds for each raw sample of a pulse, measured once.
constexpr double per_sample_s = 8e-9;
constexpr double per_compressed_sample_s = 16e-9;
constexpr double per_noise_sample_s = 45e-9;
// What each further thread brings: cores share memory, caches and clock.
constexpr double gain_of_thread = 0.85;
// Where the points are, for the fast engines; the cost of the reference has it.
constexpr double per_sight_s = 5e-9;

double scatterers_of(const ResolvedScene& scene) {
  auto count = static_cast<double>(scene.scatterers.size());
  for (const ScattererSheet& sheet : scene.sheets) count += static_cast<double>(sheet.points_m.size());
  return count;
}

// The share of the scatterers that show the radar a face: backs of surfaces cost next to nothing.
double share_in_sight(const Plan& plan) {
  const ResolvedScene& scene = *plan.scene;
  const double all = scatterers_of(scene);
  if (scene.sheets.empty() || all <= 0.0) return 1.0;
  constexpr double shares[] = {0.0, 0.25, 0.5, 0.75, 1.0};
  PulseGeometry geometry(scene, plan.radar);
  double seen = static_cast<double>(scene.scatterers.size()) * std::size(shares);
  for (const double share : shares) {
    geometry.set_pulse(plan.pulses.first + std::llround(share * static_cast<double>(plan.pulses.count() - 1)));
    const radar::Pointing pointing = geometry.pointing();
    for (std::size_t i = 0; i < scene.sheets.size(); ++i)
      if (!scene.sheets[i].points_m.empty() && geometry.sheet_view(i, 0, pointing))
        seen += static_cast<double>(scene.sheets[i].points_m.size());
  }
  return seen / (all * std::size(shares));
}

// The echoes of one pulse, as if the radar saw all of them.
double engine_ns(const Plan& plan) {
  const PulseCost cost(*plan.scene, plan.radar, plan.pulse, plan.raw_grid, plan.scene->options.tolerance);
  switch (plan.engine.engine) {
    case Engine::direct: return cost.direct_ns();
    case Engine::spectral: return cost.spectral(plan.pulses).ns;
    case Engine::automatic:
    case Engine::reference: break;
  }
  return cost.reference_ns();
}

double speed_of(const MachineSpeed& machine, Engine engine) {
  switch (engine) {
    case Engine::direct: return machine.direct;
    case Engine::spectral: return machine.spectral;
    case Engine::automatic:
    case Engine::reference: break;
  }
  return machine.reference;
}

// One pulse on one core.
double pulse_seconds(const Plan& plan, const MachineSpeed& machine) {
  const double heard = static_cast<double>(1 + plan.other_pulses.pulses.size());
  const double sight_s = plan.engine.engine == Engine::reference ? 0.0 : per_sight_s * scatterers_of(*plan.scene);
  const bool noisy = plan.noise_stddev_v > 0.0;
  // A filter that is a factor of the echoes' spectra is paid for with their transforms.
  const bool filtered = plan.compressor && (noisy || !plan.filters_spectra());
  double per_sample = machine.samples * per_sample_s;
  if (noisy) per_sample += machine.noise * per_noise_sample_s;
  if (filtered) per_sample += machine.compression * per_compressed_sample_s;
  return speed_of(machine, plan.engine.engine) * heard * share_in_sight(plan) * (1e-9 * engine_ns(plan) + sight_s) +
         static_cast<double>(plan.raw_grid.count) * per_sample;
}

}  // namespace

Cost estimated_cost(const Plan& plan, unsigned threads, const MachineSpeed& machine) {
  CORE_EXPECT(plan.scene != nullptr);
  CORE_EXPECT(threads > 0);
  const double scatterers = scatterers_of(*plan.scene);
  const double pulses =
      static_cast<double>(plan.rows) * (plan.profiler ? static_cast<double>(plan.burst_pulses()) : 1.0);
  const double pulse_samples = std::min((plan.pulse.last_s() - plan.pulse.first_s()) / plan.raw_grid.interval_s,
                                        static_cast<double>(plan.raw_grid.count));
  Cost cost;
  cost.echoes = scatterers * pulses * static_cast<double>(1 + plan.other_pulses.pulses.size());
  cost.echo_samples = cost.echoes * pulse_samples;
  cost.samples = static_cast<double>(plan.rows) * static_cast<double>(plan.columns);
  cost.seconds_one_thread = pulses * pulse_seconds(plan, machine);
  cost.seconds = cost.seconds_one_thread / (1.0 + gain_of_thread * (threads - 1.0));
  const double row_bytes = 16.0 * static_cast<double>(plan.raw_grid.count + 2 * plan.columns);
  cost.memory_bytes = 16e6 + 200.0 * scatterers + threads * (4.0 * std::max(row_bytes, 4e6) + 24.0 * scatterers);
  return cost;
}

}  // namespace sarsim::simulate
