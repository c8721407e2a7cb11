#include "workflow/stepped/stepped_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/task/worker_pool.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/work_matrix.hpp"
#include "simulate/run/computed_rows.hpp"
#include "workflow/stepped/stepped_grid.hpp"

namespace sarsim::workflow {

namespace {

// `problems_of_stepped` has seen that there is one.
SteppedGrid grid_of(const simulate::Acquisition& acquisition) {
  return stepped_grid(acquisition.link.carrier, acquisition.timing.pulses.first).value_or(SteppedGrid{});
}

// One frequency has no profile but that of its pulse.
bool one_sample_each(const simulate::Acquisition& acquisition) {
  return acquisition.link.pulse.kind == radar::Pulse::Kind::mono && grid_of(acquisition).steps > 1;
}

signal::CompressionFilter plain_filter(const simulate::Acquisition& acquisition) {
  const radar::BandLimitedPulse* band_limited =
      acquisition.reception.pulse.band_limited ? &*acquisition.reception.pulse.band_limited : nullptr;
  return signal::matched_filter(
      acquisition.link.pulse, band_limited, [](double) { return 1.0; },
      1.0 / acquisition.reception.raw_grid.interval_s);
}

// The filter's answer to a resting echo of amplitude 1: y[i] = sum over k of taps[k] p[i + k]. The plain filter is the
// conjugate pulse over its energy, and 1 over the sum of its squares is that energy.
void set_response(signal::SteppedWaveform& w, const signal::CompressionFilter& plain,
                  const signal::CompressionFilter& used) {
  double squares = 0.0;
  for (const auto& tap : plain.taps) squares += std::norm(tap);
  const auto length = static_cast<std::ptrdiff_t>(plain.taps.size());
  const auto taps = static_cast<std::ptrdiff_t>(used.taps.size());
  w.response.resize(static_cast<std::size_t>(length + taps - 1));
  w.response_zero = static_cast<std::size_t>(taps - 1);
  for (std::ptrdiff_t i = 0; i < length + taps - 1; ++i) {
    std::complex<double> sum;
    for (std::ptrdiff_t k = 0; k < taps; ++k) {
      const std::ptrdiff_t n = i - (taps - 1) + k;
      if (n < 0 || n >= length) continue;
      sum += used.taps[static_cast<std::size_t>(k)] * std::conj(plain.taps[static_cast<std::size_t>(n)]);
    }
    w.response[static_cast<std::size_t>(i)] = sum / squares;
  }
}

// @param compressed  the rows that are read hold compressed echoes
signal::SteppedWaveform waveform_of(const simulate::Acquisition& acquisition, bool compressed) {
  const SteppedGrid grid = grid_of(acquisition);
  const radar::Pulse& pulse = acquisition.link.pulse;
  signal::SteppedWaveform w;
  w.first_carrier_hz = grid.first_hz;
  w.carrier_step_hz = grid.step_hz;
  w.steps = grid.steps;
  w.pulses_per_step = grid.pulses_per_step;
  w.order = grid.order;
  w.pulse_width_s = pulse.width_s;
  w.sample_rate_hz = 1.0 / acquisition.reception.raw_grid.interval_s;
  w.light_speed_mps = acquisition.light_speed_mps();
  w.first_sample_s = acquisition.reception.raw_grid.first_s;
  w.samples = acquisition.reception.columns;
  const double lead_s = acquisition.reception.pulse.lead_s;
  if (one_sample_each(acquisition)) {
    w.first_sample_s += compressed ? lead_s : 0.0;
    // A compressed monochrome echo is a triangle about its delay; half of it counts as seen.
    w.seen_from_s = compressed ? -0.5 * pulse.width_s : -lead_s;
    w.seen_to_s = w.seen_from_s + pulse.width_s;
    return w;
  }
  w.first_sample_s += lead_s;
  w.subband_hz = radar::bandwidth_hz(pulse);
  w.sweep_rate_hz_per_s = pulse.sweep_rate_hz_per_s();
  const signal::CompressionFilter plain = plain_filter(acquisition);
  set_response(w, plain, compressed ? acquisition.reception.compressor->filter() : plain);
  if (!compressed) w.filter = plain.taps;
  return w;
}

// Whole bursts of recorded rows.
SteppedRows rows_reading(std::shared_ptr<const simulate::Acquisition> acquisition, core::SampleRows<double> recorded,
                         bool compressed) {
  SteppedRows rows;
  rows.acquisition = std::move(acquisition);
  rows.band = std::make_shared<const signal::SteppedBand>(waveform_of(*rows.acquisition, compressed));
  const std::int64_t burst = grid_of(*rows.acquisition).burst_pulses();
  const radar::PulseRange& pulses = rows.acquisition->timing.pulses;
  const std::int64_t first = radar::floor_divide(pulses.first + burst - 1, burst);
  const std::int64_t bursts = std::max<std::int64_t>(0, radar::floor_divide(pulses.last + 1, burst) - first);
  rows.first_pulse = first * burst;
  rows.bursts = static_cast<std::size_t>(bursts);
  rows.rows = static_cast<std::size_t>(bursts * burst);
  rows.columns = rows.acquisition->reception.columns;
  rows.dropped_pulses = pulses.count() - bursts * burst;
  rows.from_m = rows.acquisition->simulation.range_start_m;
  rows.to_m = rows.acquisition->simulation.range_end_m;
  const auto skipped = static_cast<std::size_t>(rows.first_pulse - pulses.first);
  rows.copy = [skipped, recorded = std::move(recorded)](std::size_t pulse, std::span<std::complex<double>> out) {
    recorded.read(skipped + pulse, out);
  };
  return rows;
}

}  // namespace

scene::Simulation recorded_for_stepped(const scene::Simulation& simulation, const simulate::Acquisition& acquisition) {
  scene::Simulation recorded = simulation;
  recorded.processing = scene::Processing::raw;
  const double interval_s = 1.0 / simulation.sample_rate_hz;
  const double last_s = acquisition.reception.pulse.band_limited ? acquisition.reception.pulse.band_limited->last_s()
                                                                 : acquisition.link.pulse.width_s;
  const double sample_m = radar::range_of(interval_s, acquisition.light_speed_mps());
  recorded.range_end_m += sample_m * (std::ceil(last_s / interval_s) + 1.0);
  // The echo of a target at CENTRE begins half a pulse before its range.
  recorded.range_start_m -= sample_m * std::ceil(acquisition.reception.pulse.lead_s / interval_s);
  return recorded;
}

SteppedRows stepped_rows_of_scene(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                  const simulate::Acquisition& window) {
  SteppedRows rows = rows_reading(acquisition, simulate::computed_rows(acquisition), false);
  rows.from_m = window.simulation.range_start_m;
  rows.to_m = window.simulation.range_end_m;
  return rows;
}

SteppedRows stepped_rows_of_recording(const std::shared_ptr<const simulate::Acquisition>& acquisition,
                                      core::SampleRows<double> recorded) {
  return rows_reading(acquisition, std::move(recorded), acquisition->reception.is_compressed());
}

signal::BurstEchoes read_bursts(const SteppedRows& rows, std::size_t first, std::size_t count,
                                const core::WorkControl& control, const core::ProgressReport& progress) {
  constexpr std::size_t grain = 8;
  const std::size_t per_burst = rows.band->waveform().burst_pulses();
  const std::size_t pulses = count * per_burst;
  const std::size_t size = rows.band->values_per_pulse();
  signal::BurstEchoes echoes;
  echoes.values.resize(pulses * size);
  for (std::size_t p = 0; p < pulses; ++p) echoes.time_s.push_back(rows.pulse_time_s(first * per_burst + p));
  signal::WorkCounter counter(progress, pulses * rows.acquisition->reception.columns,
                              rows.acquisition->reception.columns);
  core::parallel_ranges(pulses, grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<double>> row(rows.acquisition->reception.columns);
    for (std::size_t p = begin; p < end; ++p) {
      rows.read(first * per_burst + p, row);
      rows.band->place(p % per_burst, row, std::span(echoes.values).subspan(p * size, size));
    }
    counter.add((end - begin) * row.size());
  });
  return echoes;
}

}  // namespace sarsim::workflow
