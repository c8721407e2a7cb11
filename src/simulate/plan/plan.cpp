#include "simulate/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
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
radar::EchoPulse echo_pulse(const ResolvedRadar& radar, const scene::Simulation& simulation, const ResolvedScene& scene,
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

double noise_stddev(const ResolvedRadar& radar, const scene::Simulation& simulation, const Conventions& conventions) {
  const double density = conventions.boltzmann_j_per_k * radar.noise_temperature_k;
  if (conventions.noise == Conventions::Noise::per_sample) return std::sqrt(0.5 * density * simulation.sample_rate_hz);
  const bool chirp = radar.pulse.kind == radar::Pulse::Kind::chirp;
  return std::sqrt(density * (chirp ? radar::bandwidth_hz(radar.pulse) : 1.0 / radar.pulse.width_s));
}

// Gain at the range of each raw sample, not shifted by the pulse position (decision 14).
std::vector<double> stc_gains(const Plan& plan) {
  std::vector<double> gain;
  if (plan.radar.stc == scene::Radar::Stc::none || plan.scene->conventions.stc != Conventions::Stc::receiver_gain)
    return gain;
  gain.resize(plan.raw_grid.count);
  for (std::size_t i = 0; i < gain.size(); ++i) {
    const double range_m = radar::range_of(plan.raw_grid.time_s(i), plan.scene->conventions.light_speed_mps);
    gain[i] = plan.radar.stc == scene::Radar::Stc::user ? plan.radar.stc_gain.value(range_m) : range_m * range_m;
  }
  return gain;
}

std::vector<std::size_t> identity_indices(std::size_t count) {
  std::vector<std::size_t> index(count);
  for (std::size_t i = 0; i < count; ++i) index[i] = i;
  return index;
}

// Ranges of raw samples, given by their index from the start of the window.
std::vector<double> ranges_m(const Plan& plan, const std::vector<std::size_t>& index) {
  const double spacing_m = radar::range_of(plan.raw_grid.interval_s, plan.scene->conventions.light_speed_mps);
  std::vector<double> ranges(index.size());
  for (std::size_t i = 0; i < index.size(); ++i)
    ranges[i] = plan.simulation.range_start_m + static_cast<double>(index[i]) * spacing_m;
  return ranges;
}

// Number of the first raw sample, in intervals after the send time: what its noise is keyed by. Rounding must not put
// windows that begin halfway between two numbers (CENTRE, an odd number of half samples) on different sides.
std::int64_t first_sample_number(const radar::SampleGrid& grid) {
  constexpr double rounding = 1e-6;
  return static_cast<std::int64_t>(std::floor(grid.first_s / grid.interval_s + 0.5 + rounding));
}

// Sets the raw grid, the ranges of the columns (of the gates, for profiles) and, for compressed data, the compressor.
void plan_samples(Plan& plan, std::size_t count) {
  const scene::Simulation& s = plan.simulation;
  const Conventions& conventions = plan.scene->conventions;
  const double two_way_start_s = radar::delay_of(s.range_start_m, conventions.light_speed_mps);
  const double interval_s = raw_interval_s(s, conventions, count);
  if (s.processing != scene::Processing::matched_filter) {
    plan.raw_grid = {two_way_start_s, interval_s, count};
    plan.column_range_m = ranges_m(plan, identity_indices(count));
    return;
  }
  const double first_s = two_way_start_s - plan.pulse.lead_s;
  const radar::BandLimitedPulse* band_limited = plan.pulse.band_limited ? &*plan.pulse.band_limited : nullptr;
  std::vector<std::size_t> index = identity_indices(count);
  signal::CompressionFilter filter;
  if (conventions.compression == Conventions::Compression::keeps_peak) {
    filter = signal::matched_filter(plan.radar.pulse, band_limited, plan.radar.window, s.sample_rate_hz);
  } else {
    filter = signal::classic_matched_filter(plan.radar.pulse, plan.radar.window, s.sample_rate_hz);
    const double ratio = radar::turns_of(s.range_end_m - s.range_start_m, s.sample_rate_hz,
                                         conventions.light_speed_mps * static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      index[i] = static_cast<std::size_t>(std::floor(static_cast<double>(i) * ratio + index_tolerance));
  }
  const std::size_t raw_count = index.back() + filter.taps.size();
  plan.raw_grid = {first_s, interval_s, raw_count};
  plan.column_range_m = ranges_m(plan, index);
  plan.compressor = std::make_shared<signal::RangeCompressor>(std::move(filter), raw_count, std::move(index));
}

void plan_rows(Plan& plan, std::size_t count) {
  if (plan.simulation.processing != scene::Processing::srp) {
    plan.rows = static_cast<std::size_t>(plan.pulses.count());
    plan.columns = count;
    return;
  }
  const std::int64_t burst = plan.burst_pulses();
  plan.first_burst = radar::floor_divide(plan.pulses.first + burst - 1, burst);
  const std::int64_t bursts =
      std::max<std::int64_t>(0, radar::floor_divide(plan.pulses.last + 1, burst) - plan.first_burst);
  plan.dropped_pulses = plan.pulses.count() - bursts * burst;
  plan.rows = static_cast<std::size_t>(bursts);
  const auto steps = static_cast<std::size_t>(plan.radar.carrier.steps());
  plan.columns = count * steps;
  std::vector<double> gates_m = std::move(plan.column_range_m);
  const double bin_m = radar::range_of_cycle(static_cast<double>(steps) * plan.radar.carrier.step_hz(),
                                             plan.scene->conventions.light_speed_mps);
  plan.column_range_m.assign(plan.columns, 0.0);
  for (std::size_t c = 0; c < plan.columns; ++c)
    plan.column_range_m[c] = gates_m[c / steps] + static_cast<double>(c % steps) * bin_m;
  plan.profiler = std::make_shared<signal::RangeProfiler>(std::move(gates_m), plan.radar.carrier.steps(),
                                                          plan.radar.carrier.step_hz(), plan.radar.window,
                                                          plan.scene->conventions.light_speed_mps);
}

// What files hold of a pose.
RowPose row_pose(const radar::Pose& pose) {
  const auto numbers = [](const core::Vec3& v) { return std::array{v.x, v.y, v.z}; };
  return {numbers(pose.position_world_m), numbers(pose.velocity_world_mps), pose.rotation_rad};
}

}  // namespace

std::int64_t Plan::first_pulse_of_row(std::size_t row) const {
  CORE_EXPECT(row < rows);
  if (simulation.processing == scene::Processing::srp)
    return (first_burst + static_cast<std::int64_t>(row)) * burst_pulses();
  return pulses.first + static_cast<std::int64_t>(row);
}

double sample_count(const scene::Simulation& simulation, double light_speed_mps) {
  CORE_EXPECT(light_speed_mps > 0.0);
  // The guard keeps a window that was computed to hold a half sample from losing it to rounding.
  return std::floor(
      radar::turns_of(simulation.range_end_m - simulation.range_start_m, simulation.sample_rate_hz, light_speed_mps) +
      0.5 + index_tolerance);
}

Plan make_plan(const scene::Scene& scene, std::size_t index, std::shared_ptr<const ResolvedScene> resolved,
               Engine engine, const core::StopFlag* stop) {
  CORE_EXPECT(index < scene.simulations.size());
  Plan plan;
  plan.simulation = scene.simulations.at(index);
  plan.scene = resolved ? std::move(resolved) : std::make_shared<const ResolvedScene>(resolve(scene, {1, stop}));
  const std::size_t radar = scene::find_radar(scene, plan.simulation.radar);
  if (radar == scene::not_found) throw std::invalid_argument("radar '" + plan.simulation.radar + "' is not defined");
  plan.radar = resolve_radar(scene, *plan.scene, radar);
  plan.pulses = plan.radar.repetition.pulses_in(plan.simulation.time_start_s, plan.simulation.time_end_s);
  const double count = sample_count(plan.simulation, plan.scene->conventions.light_speed_mps);
  if (!(count >= 1.0) || plan.pulses.count() < 1)
    throw std::invalid_argument("the window of simulation " + std::to_string(index + 1) + " is empty");
  if (count > 0x1p40) throw std::invalid_argument(fmt::format("a row of {:g} samples cannot be held", count));
  const double interval_s = raw_interval_s(plan.simulation, plan.scene->conventions, static_cast<std::size_t>(count));
  plan.pulse = echo_pulse(plan.radar, plan.simulation, *plan.scene, interval_s);
  plan_samples(plan, static_cast<std::size_t>(count));
  plan_rows(plan, static_cast<std::size_t>(count));
  plan.noise_stddev_v = noise_stddev(plan.radar, plan.simulation, plan.scene->conventions);
  plan.noise_first_sample = first_sample_number(plan.raw_grid);
  plan.stc_gain = stc_gains(plan);
  plan.other_pulses = asked_for(heard_pulses(*plan.scene, plan.radar, plan.pulse, plan.raw_grid, plan.pulses, stop),
                                plan.scene->options.ambiguous_echoes);
  plan.engine = choose_engine(engine, *plan.scene, plan.radar, plan.pulse, plan.raw_grid, plan.pulses,
                              plan.scene->options.tolerance);
  if (plan.engine.engine != Engine::reference)
    plan.points = std::make_shared<const PointGroups>(group_points(*plan.scene, plan.radar, stop));
  return plan;
}

Product product_of(const Plan& plan, std::string script) {
  CORE_EXPECT(plan.scene != nullptr);
  CORE_EXPECT(plan.column_range_m.size() == plan.columns);
  Product product;
  product.radar = plan.radar.name;
  product.processing = plan.simulation.processing;
  product.rows = plan.rows;
  product.columns = plan.columns;
  // The axes are functions so that a long recording costs no memory; they keep the plan's schedule, not the plan.
  const bool srp = plan.simulation.processing == scene::Processing::srp;
  const std::int64_t first = plan.first_pulse_of_row(0);
  const std::int64_t step = srp ? plan.burst_pulses() : 1;
  const auto pulse_of = [first, step](std::size_t row) { return first + static_cast<std::int64_t>(row) * step; };
  product.row_time_s = [pulse_of, repetition = plan.radar.repetition](std::size_t row) {
    return repetition.send_time_s(pulse_of(row));
  };
  product.row_carrier_hz = [pulse_of, carrier = plan.radar.carrier](std::size_t row) {
    return carrier.carrier_hz(pulse_of(row));
  };
  const radar::Track& track = plan.scene->platforms[plan.radar.platform].track;
  product.row_pose = [pulse_of, repetition = plan.radar.repetition,
                      track = std::make_shared<const radar::Track>(track)](std::size_t row) {
    const std::int64_t pulse = pulse_of(row);
    return row_pose(track->at(repetition.send_time_s(pulse), pulse));
  };
  product.column_range_m = [ranges = plan.column_range_m](std::size_t column) { return ranges[column]; };
  product.sample_rate_hz = plan.simulation.sample_rate_hz;
  product.bits = plan.simulation.bits;
  product.lsb_v = plan.simulation.lsb_v;
  product.options = plan.scene->options;
  product.engine = name_of(plan.engine.engine);
  product.script = std::move(script);
  return product;
}

}  // namespace sarsim::simulate
