#include <algorithm>

#include "core/report/expect.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/row_kernel.hpp"

namespace sarsim::simulate {

namespace {

// Seconds for each pulse and each raw sample of it, measured once. What no echo reaches is cleared and counted alone.
constexpr double per_pulse_s = 0.3e-6;
constexpr double per_sample_s = 0.82e-9;
constexpr double per_reached_sample_s = 1.75e-9;
constexpr double per_compressed_sample_s = 9.5e-9;
constexpr double per_noise_sample_s = 5e-9;
// What each further thread brings: cores share memory, caches and clock, and large transforms live in shared ones.
constexpr double gain_of_thread = 0.85;
constexpr double gain_of_crowded_thread = 0.5;
constexpr double crowded_points = 2e5;
// Where the points are, for the fast engines; the cost of the reference has it.
constexpr double per_sight_s = 1.5e-9;
constexpr double per_platform_s = 0.25e-6;  // where it is and how it turns

double scatterers_of(const ResolvedScene& scene) {
  auto count = static_cast<double>(scene.scatterers.size());
  for (const ScattererSheet& sheet : scene.sheets) count += static_cast<double>(sheet.points_m.size());
  return count;
}

// The share of the scatterers that show the radar a face: backs of surfaces cost next to nothing.
double share_in_sight(const Plan& plan) {
  const ResolvedScene& scene = *plan.acquisition.scene;
  const double all = scatterers_of(scene);
  if (scene.sheets.empty() || all <= 0.0) return 1.0;
  constexpr double shares[] = {0.0, 0.25, 0.5, 0.75, 1.0};
  PulseGeometry geometry(scene, plan.acquisition.link);
  double seen = static_cast<double>(scene.scatterers.size()) * std::size(shares);
  for (const double share : shares) {
    geometry.set_pulse(plan.acquisition.timing.pulses.first +
                       std::llround(share * static_cast<double>(plan.acquisition.timing.pulses.count() - 1)));
    const radar::Pointing pointing = geometry.pointing();
    for (std::size_t i = 0; i < scene.sheets.size(); ++i)
      if (!scene.sheets[i].points_m.empty() && geometry.sheet_view(i, 0, pointing))
        seen += static_cast<double>(scene.sheets[i].points_m.size());
  }
  return seen / (all * std::size(shares));
}

KernelCost kernel_cost(const Plan& plan) {
  const PulseCost pulse(*plan.acquisition.scene, plan.acquisition.link, plan.acquisition.reception.pulse,
                        plan.acquisition.reception.raw_grid, plan.acquisition.scene->options.tolerance);
  return row_kernel(plan.engine.engine).cost(pulse, plan.acquisition.timing.pulses);
}

// What is not echoes: rows, noise, filters and conversion.
double row_seconds(const Plan& plan, double echo_samples, const MachineSpeed& machine) {
  const bool noisy = plan.acquisition.reception.noise_stddev_v > 0.0;
  // A filter that is a factor of the echoes' spectra is paid for with their transforms.
  const bool filtered = plan.acquisition.reception.compressor && (noisy || !plan.filters_spectra());
  const auto samples = static_cast<double>(plan.acquisition.reception.raw_grid.count);
  const double reached = noisy || plan.acquisition.reception.compressor ? samples : std::min(samples, echo_samples);
  double seconds = machine.samples * (per_pulse_s + samples * per_sample_s + reached * per_reached_sample_s);
  if (noisy) seconds += machine.noise * samples * per_noise_sample_s;
  if (filtered) seconds += machine.compression * samples * per_compressed_sample_s;
  return seconds;
}

// One pulse on one core.
// @param echo_samples  samples of all its echoes together
double pulse_seconds(const Plan& plan, const KernelCost& work, double echo_samples, const MachineSpeed& machine) {
  const double heard = static_cast<double>(1 + plan.sources.range_ambiguities.pulses.size());
  const double sight_s = row_kernel(plan.engine.engine).point_by_point
                             ? 0.0
                             : per_sight_s * scatterers_of(*plan.acquisition.scene) +
                                   per_platform_s * static_cast<double>(plan.acquisition.scene->platforms.size());
  return machine.*row_kernel(plan.engine.engine).speed * heard * share_in_sight(plan) *
             (1e-9 * work.pulse_ns + sight_s) +
         row_seconds(plan, echo_samples, machine);
}

// The most that is held at once: while the script is read and checked and its platforms are looked at, or while its
// pulses are computed.
double max_memory(const Plan& plan, const KernelCost& work, unsigned threads) {
  constexpr double program = 11e6;
  constexpr double transform_library = 5e6;
  constexpr double platform = 70e3;
  constexpr double checked_target = 148.0;
  constexpr double surveyed_target = 300.0;
  constexpr double max_surveyed = 65'536.0;
  constexpr double resolved_target = 72.0;
  constexpr double cloud_point = 32.0;
  constexpr double echo = 48.0;
  constexpr double sample = 140.0;
  constexpr double transform_point = 52.0;
  constexpr double spectra_kept = 12.0;  // of pulses, each with half the points of their transforms, 8 bytes
  constexpr double max_spectra = 16e6;
  const ResolvedScene& scene = *plan.acquisition.scene;
  const double all = scatterers_of(scene);
  const auto targets = static_cast<double>(scene.scatterers.targets());
  const double points = static_cast<double>(scene.scatterers.size()) - targets;
  const double sheets = all - static_cast<double>(scene.scatterers.size());
  const double checked = checked_target * targets + surveyed_target * std::min(all, max_surveyed) +
                         platform * static_cast<double>(scene.platforms.size());
  const std::size_t taken = row_kernel(plan.engine.engine).points_at_once;
  const double at_once = taken > 0 ? std::min(all, static_cast<double>(taken)) : all;
  double of_thread = echo * at_once + sample * static_cast<double>(std::max(plan.acquisition.reception.raw_grid.count,
                                                                            plan.acquisition.reception.columns));
  double computed = resolved_target * (targets + sheets);
  if (work.transforms > 0.0) {
    const double spectra = work.transforms > 1.0 ? spectra_kept * 4.0 * work.transforms * work.transform_points : 0.0;
    of_thread += transform_point * work.transform_points + std::min(spectra, max_spectra);
  }
  if (work.transforms > 0.0 || plan.acquisition.reception.compressor) computed += transform_library;
  computed += threads * of_thread;
  return program + cloud_point * points + std::max(checked, computed);
}

}  // namespace

Cost estimated_cost(const Plan& plan, unsigned threads, const MachineSpeed& machine) {
  CORE_EXPECT(plan.acquisition.scene != nullptr);
  CORE_EXPECT(threads > 0);
  const double scatterers = scatterers_of(*plan.acquisition.scene);
  const double pulses =
      static_cast<double>(plan.acquisition.timing.rows) * static_cast<double>(plan.acquisition.timing.row_pulses);
  const double pulse_samples =
      std::min((plan.acquisition.reception.pulse.last_s() - plan.acquisition.reception.pulse.first_s()) /
                   plan.acquisition.reception.raw_grid.interval_s,
               static_cast<double>(plan.acquisition.reception.raw_grid.count));
  Cost cost;
  cost.echoes = scatterers * pulses * static_cast<double>(1 + plan.sources.range_ambiguities.pulses.size());
  cost.echo_samples = cost.echoes * pulse_samples;
  cost.samples =
      static_cast<double>(plan.acquisition.timing.rows) * static_cast<double>(plan.acquisition.reception.columns);
  const KernelCost work = kernel_cost(plan);
  const double computing_s = pulses * pulse_seconds(plan, work, cost.echo_samples / std::max(pulses, 1.0), machine);
  const bool crowded = work.transforms * work.transform_points > crowded_points;
  const double gain = crowded ? gain_of_crowded_thread : gain_of_thread;
  cost.start_seconds = work.start_s;
  cost.seconds_one_thread = work.start_s + computing_s;
  cost.seconds = work.start_s + computing_s / (1.0 + gain * (threads - 1.0));
  cost.memory_bytes = max_memory(plan, work, threads);
  return cost;
}

}  // namespace sarsim::simulate
