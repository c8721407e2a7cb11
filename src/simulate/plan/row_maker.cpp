#include "simulate/plan/row_maker.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/turns.hpp"
#include "core/report/expect.hpp"
#include "radar/receiver/noise.hpp"

namespace sarsim::simulate {

RowMaker::RowMaker(const Plan& plan)
    : plan_(&plan), geometry_(*plan.acquisition.scene, plan.acquisition.link), kind_(&row_kernel(plan.engine.engine)) {
  const Reception& reception = plan.acquisition.reception;
  CORE_EXPECT(reception.stc_gain.empty() || reception.stc_gain.size() == reception.raw_grid.count);
  if (reception.compressor) scratch_.resize(reception.compressor->scratch_size());
  if (reception.profiler) scratch_.resize(reception.columns);
  radar::RowFilter filter;
  if (plan.filters_spectra()) filter = {reception.compressor->filter().taps, reception.compressor->output_index()};
  kernel_ = kind_->make(reception.pulse, reception.raw_grid, plan.acquisition.scene->options.tolerance, filter);
}

radar::SampleSpan RowMaker::make_row(std::size_t row, std::span<std::complex<double>> out,
                                     const radar::SampleSpan& stale) {
  CORE_EXPECT(row < plan_->acquisition.timing.rows);
  CORE_EXPECT(out.size() == plan_->acquisition.reception.columns);
  CORE_EXPECT(stale.begin <= stale.end && stale.end <= out.size());
  const Plan& plan = *plan_;
  switch (plan.acquisition.simulation.processing) {
    case scene::Processing::raw: return make_raw(plan.acquisition.timing.first_pulse_of_row(row), out, stale);
    case scene::Processing::matched_filter:
      make_compressed(plan.acquisition.timing.first_pulse_of_row(row), out);
      break;
    case scene::Processing::srp: make_profile(row, out); break;
  }
  return {0, out.size()};
}

void RowMaker::make_compressed(std::int64_t pulse, std::span<std::complex<double>> out) {
  const Plan& plan = *plan_;
  raw_.resize(plan.acquisition.reception.raw_grid.count);
  if (!plan.filters_spectra()) {
    raw_filled_ = make_raw(pulse, raw_, raw_filled_);
    plan.acquisition.reception.compressor->compress(raw_, out, scratch_);
    return;
  }
  std::ranges::fill(out, std::complex<double>());
  if (plan.acquisition.reception.noise_stddev_v > 0.0) {
    std::ranges::fill(raw_, std::complex<double>());
    add_receiver_noise(pulse, raw_);
    plan.acquisition.reception.compressor->compress(raw_, out, scratch_);
  }
  geometry_.set_pulse(pulse);
  add_pulse(out, {});
}

radar::SampleSpan RowMaker::make_raw(std::int64_t pulse, std::span<std::complex<double>> raw,
                                     const radar::SampleSpan& stale) {
  const Plan& plan = *plan_;
  std::ranges::fill(raw.subspan(stale.begin, stale.end - stale.begin), std::complex<double>());
  geometry_.set_pulse(pulse);
  radar::SampleSpan filled = add_pulse(raw, {});
  filled = filled.with(add_range_ambiguities(pulse, raw));
  if (plan.acquisition.reception.noise_stddev_v > 0.0) {
    add_receiver_noise(pulse, raw);
    filled = {0, raw.size()};
  }
  if (plan.acquisition.scene->options.eclipsing == scene::Eclipsing::blanked) blank_while_sending(pulse, raw);
  if (!plan.acquisition.reception.stc_gain.empty())
    for (std::size_t i = filled.begin; i < filled.end; ++i) raw[i] *= plan.acquisition.reception.stc_gain[i];
  return filled;
}

void RowMaker::add_receiver_noise(std::int64_t pulse, std::span<std::complex<double>> raw) const {
  const Plan& plan = *plan_;
  const core::RandomStream stream(plan.acquisition.scene->options.seed, core::RandomKind::receiver_noise,
                                  core::name_key(plan.acquisition.link.name));
  radar::add_noise(raw, plan.acquisition.reception.noise_stddev_v, stream, pulse,
                   plan.acquisition.reception.noise_first_sample);
}

// Leaves out what is not heard in a row whose pulse left so much later.
void RowMaker::clip_to_window(std::optional<double> since_s) {
  if (since_s)
    simulate::clip_to_window(echoes_, *since_s, plan_->acquisition.reception.pulse,
                             plan_->acquisition.reception.raw_grid);
}

void RowMaker::take_point_by_point(std::optional<double> since_s) {
  geometry_.echoes(echoes_);
  clip_to_window(since_s);
  kernel_->take(echoes_);
}

void RowMaker::take_groups(std::span<std::complex<double>> raw, std::optional<double> since_s) {
  const PointGroups& points = *plan_->sources.points;
  const std::size_t at_once = kind_->points_at_once > 0 ? kind_->points_at_once : points.count;
  kernel_->begin(geometry_.carrier_hz(), points.count, raw);
  for (std::size_t from = 0; from < points.count; from += at_once) {
    const radar::PointSpan run{from, std::min(from + at_once, points.count)};
    if (!certain_echoes(points, geometry_, run, echoes_)) {
      // Where in doubt the plain geometry decides, and says what is wrong with which target.
      kernel_->begin(geometry_.carrier_hz(), 0, raw);
      return take_point_by_point(since_s);
    }
    clip_to_window(since_s);
    kernel_->take(echoes_);
  }
}

// Adds the echoes of the geometry's pulse to a row: all of them, or those heard in a row whose pulse left so much
// later. Returns the samples outside of which it is as it was.
radar::SampleSpan RowMaker::add_pulse(std::span<std::complex<double>> raw, std::optional<double> since_s) {
  if (kind_->point_by_point) {
    kernel_->begin(geometry_.carrier_hz(), 0, raw);
    take_point_by_point(since_s);
  } else {
    take_groups(raw, since_s);
  }
  return kernel_->finish();
}

// An echo of another pulse is one of the row's pulse that comes by so much earlier as that pulse left before: its phase
// is that of its own delay, and it beats with the row's carrier where its own is another (docs/theory/echo-model.md).
// Returns the samples outside of which the row is as it was.
radar::SampleSpan RowMaker::add_range_ambiguities(std::int64_t pulse, std::span<std::complex<double>> raw) {
  const Plan& plan = *plan_;
  radar::SampleSpan filled;
  const double sent_s = plan.acquisition.link.repetition.send_time_s(pulse);
  const double carrier_hz = plan.acquisition.link.carrier.carrier_hz(pulse);
  for (const RangeAmbiguity& other : plan.sources.range_ambiguities.pulses) {
    const double beat_hz = plan.acquisition.link.carrier.carrier_hz(pulse - other.back) - carrier_hz;
    if (std::abs(beat_hz) > plan.acquisition.reception.sample_rate_hz) continue;
    geometry_.set_pulse(pulse - other.back);
    const double since_s = sent_s - geometry_.send_time_s();
    other_.resize(raw.size());
    const radar::SampleSpan on = add_pulse(other_, since_s);
    filled = filled.with(on);
    const std::complex<double> turn = core::turned_exactly(-geometry_.carrier_hz() * since_s);
    for (std::size_t i = on.begin; i < on.end; ++i) {
      std::complex<double> sample = turn * other_[i];
      other_[i] = 0.0;
      if (beat_hz != 0.0)
        sample *= core::turned_exactly(
            beat_hz * plan.acquisition.reception.pulse.from_middle_s(plan.acquisition.reception.raw_grid.time_s(i)));
      raw[i] += sample;
    }
  }
  return filled;
}

// By the edge rule of the ideal pulse.
void RowMaker::blank_while_sending(std::int64_t pulse, std::span<std::complex<double>> raw) const {
  const Plan& plan = *plan_;
  const radar::Repetition& repetition = plan.acquisition.link.repetition;
  const radar::SampleGrid& grid = plan.acquisition.reception.raw_grid;
  const double width_s = plan.acquisition.link.pulse.width_s;
  const double sent_s = repetition.send_time_s(pulse);
  const double begin_s = sent_s + plan.acquisition.reception.pulse.from_middle_s(grid.time_s(0));
  const double end_s = sent_s + plan.acquisition.reception.pulse.from_middle_s(grid.time_s(grid.count));
  const radar::PulseRange sending = repetition.pulses_in(begin_s - width_s, end_s + width_s);
  radar::EchoPulse sent = plan.acquisition.reception.pulse;
  sent.band_limited.reset();
  for (std::int64_t m = sending.first; m <= sending.last; ++m) {
    const radar::SampleSpan on = radar::touched_samples(sent, grid, repetition.send_time_s(m) - sent_s, {});
    for (std::size_t i = on.begin; i < on.end; ++i) raw[i] = 0.0;
  }
}

void RowMaker::make_profile(std::size_t row, std::span<std::complex<double>> out) {
  const Plan& plan = *plan_;
  const auto steps = static_cast<std::size_t>(plan.acquisition.link.carrier.steps());
  const int per_step = plan.acquisition.link.carrier.pulses_per_step();
  const std::size_t gates = plan.acquisition.reception.raw_grid.count;
  raw_.resize(gates);
  std::ranges::fill(scratch_, std::complex<double>());
  std::int64_t pulse = plan.acquisition.timing.first_pulse_of_row(row);
  for (std::size_t n = 0; n < steps; ++n)
    for (int p = 0; p < per_step; ++p, ++pulse) {
      raw_filled_ = make_raw(pulse, raw_, raw_filled_);
      for (std::size_t g = 0; g < gates; ++g) scratch_[n * gates + g] += raw_[g] / static_cast<double>(per_step);
    }
  plan.acquisition.reception.profiler->profile(scratch_, out);
}

}  // namespace sarsim::simulate
