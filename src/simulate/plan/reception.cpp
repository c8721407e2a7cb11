#include "simulate/plan/reception.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::simulate {

namespace {

constexpr double index_tolerance = 1e-9;

// Two-way time between raw samples; a row of `count` of them fills the window (decision 2).
double raw_interval_s(const scene::Simulation& simulation, const Conventions& conventions, std::size_t count) {
  if (simulation.processing == scene::Processing::matched_filter ||
      conventions.spacing == Conventions::SampleSpacing::sampling_rate)
    return 1.0 / simulation.sample_rate_hz;
  const double window_s =
      radar::delay_of(simulation.range_end_m - simulation.range_start_m, conventions.light_speed_mps);
  return window_s / static_cast<double>(count);
}

// What the pulse of a simulation is (decision 7), for samples `interval_s` apart.
radar::EchoPulse echo_pulse(const Link& radar, const scene::Simulation& simulation, const ResolvedScene& scene,
                            double interval_s) {
  radar::EchoPulse pulse;
  pulse.pulse = radar.pulse;
  pulse.doppler_rule = scene.conventions.doppler;
  pulse.lead_s =
      simulation.pulse_position == scene::Simulation::PulsePosition::centre ? 0.5 * radar.pulse.width_s : 0.0;
  if (scene.options.pulse == scene::PulseDefinition::band_limited) {
    const bool nominal = simulation.oversampling > 1.0;
    // A chirp of less than a cycle is no narrower than a pulse without one.
    const double own_band_hz = std::max(radar::bandwidth_hz(radar.pulse), 1.0 / radar.pulse.width_s);
    const double half_band_hz = 0.5 * (nominal ? own_band_hz : simulation.sample_rate_hz);
    const double kept_widths =
        simulation.width_factor > 0.0 ? simulation.width_factor : scene.conventions.usual_kept_widths;
    const double kept_s = nominal ? kept_widths * radar.pulse.width_s : 0.0;
    pulse.band_limited.emplace(radar.pulse, half_band_hz, 1.0 / interval_s, kept_s);
  }
  return pulse;
}

double noise_stddev(const Link& radar, const scene::Simulation& simulation, const Conventions& conventions) {
  const double density = conventions.boltzmann_j_per_k * radar.noise_temperature_k;
  if (conventions.noise == Conventions::Noise::per_sample) return std::sqrt(0.5 * density * simulation.sample_rate_hz);
  const bool chirp = radar.pulse.kind == radar::Pulse::Kind::chirp;
  return std::sqrt(density * (chirp ? radar::bandwidth_hz(radar.pulse) : 1.0 / radar.pulse.width_s));
}

// Gain at the range of each raw sample, not shifted by the pulse position (decision 14).
std::vector<double> stc_gains(const Link& link, const Conventions& conventions, const radar::SampleGrid& grid) {
  std::vector<double> gain;
  if (link.stc == scene::Radar::Stc::none || conventions.stc != Conventions::Stc::receiver_gain) return gain;
  gain.resize(grid.count);
  for (std::size_t i = 0; i < gain.size(); ++i) {
    const double range_m = radar::range_of(grid.time_s(i), conventions.light_speed_mps);
    gain[i] = link.stc == scene::Radar::Stc::user ? link.stc_gain.value(range_m) : range_m * range_m;
  }
  return gain;
}

std::vector<std::size_t> identity_indices(std::size_t count) {
  std::vector<std::size_t> index(count);
  for (std::size_t i = 0; i < count; ++i) index[i] = i;
  return index;
}

// Ranges of raw samples, given by their index from the start of the window.
std::vector<double> ranges_m(double start_m, double interval_s, double light_speed_mps,
                             const std::vector<std::size_t>& index) {
  const double spacing_m = radar::range_of(interval_s, light_speed_mps);
  std::vector<double> ranges(index.size());
  for (std::size_t i = 0; i < index.size(); ++i) ranges[i] = start_m + static_cast<double>(index[i]) * spacing_m;
  return ranges;
}

// Number of the first raw sample, in intervals after the send time: what its noise is keyed by. Rounding must not put
// windows that begin halfway between two numbers (CENTRE, an odd number of half samples) on different sides.
std::int64_t first_sample_number(const radar::SampleGrid& grid) {
  constexpr double rounding = 1e-6;
  return static_cast<std::int64_t>(std::floor(grid.first_s / grid.interval_s + 0.5 + rounding));
}

// Sets the raw grid, the ranges of the columns (of the gates, for profiles) and, for compressed data, the compressor.
void plan_samples(Reception& reception, const Link& link, const Conventions& conventions, const scene::Simulation& s,
                  double interval_s) {
  const std::size_t count = reception.columns;
  const double two_way_start_s = radar::delay_of(s.range_start_m, conventions.light_speed_mps);
  std::vector<std::size_t> index = identity_indices(count);
  if (!reception.is_compressed()) {
    reception.raw_grid = {two_way_start_s, interval_s, count};
    reception.column_range_m = ranges_m(s.range_start_m, interval_s, conventions.light_speed_mps, index);
    return;
  }
  const double first_s = two_way_start_s - reception.pulse.lead_s;
  const radar::BandLimitedPulse* band_limited = reception.pulse.band_limited ? &*reception.pulse.band_limited : nullptr;
  signal::CompressionFilter filter;
  if (conventions.compression == Conventions::Compression::keeps_peak) {
    filter = signal::matched_filter(link.pulse, band_limited, link.window, s.sample_rate_hz);
  } else {
    filter = signal::classic_matched_filter(link.pulse, link.window, s.sample_rate_hz);
    const double ratio = radar::turns_of(s.range_end_m - s.range_start_m, s.sample_rate_hz,
                                         conventions.light_speed_mps * static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      index[i] = static_cast<std::size_t>(std::floor(static_cast<double>(i) * ratio + index_tolerance));
  }
  const std::size_t raw_count = index.back() + filter.taps.size();
  reception.raw_grid = {first_s, interval_s, raw_count};
  reception.column_range_m = ranges_m(s.range_start_m, interval_s, conventions.light_speed_mps, index);
  reception.compressor = std::make_shared<signal::RangeCompressor>(std::move(filter), raw_count, std::move(index));
}

// Columns of synthetic range profiles: so many bins to each gate.
void plan_profiles(Reception& reception, const Link& link, double light_speed_mps) {
  const auto steps = static_cast<std::size_t>(link.carrier.steps());
  std::vector<double> gates_m = std::move(reception.column_range_m);
  const double bin_m = radar::range_of_cycle(static_cast<double>(steps) * link.carrier.step_hz(), light_speed_mps);
  reception.columns = gates_m.size() * steps;
  reception.column_range_m.assign(reception.columns, 0.0);
  for (std::size_t c = 0; c < reception.columns; ++c)
    reception.column_range_m[c] = gates_m[c / steps] + static_cast<double>(c % steps) * bin_m;
  reception.profiler = std::make_shared<signal::RangeProfiler>(std::move(gates_m), link.carrier.steps(),
                                                               link.carrier.step_hz(), link.window, light_speed_mps);
}

}  // namespace

double sample_count(const scene::Simulation& simulation, double light_speed_mps) {
  CORE_EXPECT(light_speed_mps > 0.0);
  // The guard keeps a window that was computed to hold a half sample from losing it to rounding.
  return std::floor(
      radar::turns_of(simulation.range_end_m - simulation.range_start_m, simulation.sample_rate_hz, light_speed_mps) +
      0.5 + index_tolerance);
}

Reception reception_of(const Link& link, const ResolvedScene& scene, const scene::Simulation& simulation) {
  const Conventions& conventions = scene.conventions;
  const double count = sample_count(simulation, conventions.light_speed_mps);
  if (!(count >= 1.0)) throw std::invalid_argument("the window of ranges is empty");
  if (count > 0x1p40) throw std::invalid_argument(fmt::format("a row of {:g} samples cannot be held", count));
  Reception reception;
  reception.processing = simulation.processing;
  reception.sample_rate_hz = simulation.sample_rate_hz;
  reception.columns = static_cast<std::size_t>(count);
  const double interval_s = raw_interval_s(simulation, conventions, reception.columns);
  reception.pulse = echo_pulse(link, simulation, scene, interval_s);
  plan_samples(reception, link, conventions, simulation, interval_s);
  if (reception.is_profile()) plan_profiles(reception, link, conventions.light_speed_mps);
  reception.noise_stddev_v = noise_stddev(link, simulation, conventions);
  reception.noise_first_sample = first_sample_number(reception.raw_grid);
  reception.stc_gain = stc_gains(link, conventions, reception.raw_grid);
  return reception;
}

}  // namespace sarsim::simulate
