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

// Everything but the echoes, for each raw sample.
double seconds_per_raw_sample(const Plan& plan) {
  const bool noisy = plan.noise_stddev_v > 0.0;
  double seconds = per_sample_s + (noisy ? per_noise_sample_s : 0.0);
  // A filter that is a factor of the echoes' spectra is paid for with their transforms.
  if (plan.compressor && (noisy || !plan.filters_spectra())) seconds += per_compressed_sample_s;
  return seconds;
}

}  // namespace

Cost estimated_cost(const Plan& plan, unsigned threads) {
  CORE_EXPECT(plan.scene != nullptr);
  const double scatterers = scatterers_of(*plan.scene);
  const double pulses =
      static_cast<double>(plan.rows) * (plan.profiler ? static_cast<double>(plan.burst_pulses()) : 1.0);
  const double pulse_samples = std::min((plan.pulse.last_s() - plan.pulse.first_s()) / plan.raw_grid.interval_s,
                                        static_cast<double>(plan.raw_grid.count));
  const double echoes_s = 1e-9 * engine_ns(plan);
  const double sight_s = plan.engine.engine == Engine::reference ? 0.0 : per_sight_s * scatterers;
  Cost cost;
  const double heard = static_cast<double>(1 + plan.other_pulses.pulses.size());
  cost.echoes = scatterers * pulses * heard;
  cost.echo_samples = cost.echoes * pulse_samples;
  cost.samples = static_cast<double>(plan.rows) * static_cast<double>(plan.columns);
  cost.seconds_one_thread = pulses * (heard * share_in_sight(plan) * (echoes_s + sight_s) +
                                      static_cast<double>(plan.raw_grid.count) * seconds_per_raw_sample(plan));
  const double row_bytes = 16.0 * static_cast<double>(plan.raw_grid.count + 2 * plan.columns);
  cost.memory_bytes = 16e6 + 200.0 * scatterers + threads * (4.0 * std::max(row_bytes, 4e6) + 24.0 * scatterers);
  return cost;
}

}  // namespace sarsim::simulate
