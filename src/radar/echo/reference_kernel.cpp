#include "radar/echo/reference_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double edge_tolerance = 1e-9;  // of a sampling interval (decision 8)

// Fraction of a cycle, so that multiplying by 2 pi loses nothing.
double cycle_fraction(double cycles) { return cycles - std::round(cycles); }

std::complex<double> turn(double cycles) { return std::polar(1.0, 2.0 * core::pi * cycles); }

// The pulse's value at the samples that it touches, as it was sent.
void fill_shape(const EchoPulse& pulse, const SampleGrid& grid, double delay_s, const PulseClock& clock,
                const SampleSpan& on, std::span<std::complex<double>> shape) {
  const auto after_edge = [&](std::size_t i) {
    const double w = grid.time_s(i) - delay_s + pulse.lead_s;
    return w - clock.late(w - 0.5 * pulse.pulse.width_s);
  };
  if (pulse.band_limited && clock.ticks_evenly()) return pulse.band_limited->values(after_edge(on.begin), shape);
  const double tolerance_s = edge_tolerance * grid.interval_s;
  for (std::size_t i = on.begin; i < on.end; ++i)
    shape[i - on.begin] = pulse.band_limited ? pulse.band_limited->value(after_edge(i))
                                             : pulse.pulse.value(std::max(0.0, after_edge(i)), tolerance_s);
}

}  // namespace

SampleSpan touched_samples(const EchoPulse& pulse, const SampleGrid& grid, double delay_s, const PulseClock& clock) {
  const auto index_from = [&](double after_s) {
    const double time_s = delay_s + after_s + clock.late_of(pulse.from_middle_s(after_s));
    const double index = std::ceil((time_s - grid.first_s) / grid.interval_s - edge_tolerance);
    return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(grid.count)));
  };
  return {index_from(pulse.first_s()), index_from(pulse.last_s())};
}

void add_echoes(std::span<std::complex<double>> row, const SampleGrid& grid, const EchoPulse& pulse, double carrier_hz,
                const EchoBatch& echoes) {
  CORE_EXPECT(row.size() >= grid.count);
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(std::isfinite(carrier_hz));
  CORE_EXPECT(echoes.is_whole());
  std::vector<std::complex<double>> shape;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const PulseClock clock = pulse.clock_of(echoes, k);
    const double delay_s = echoes.delay_s[k];
    const SampleSpan on = touched_samples(pulse, grid, delay_s, clock);
    if (on.begin >= on.end) continue;
    shape.resize(on.end - on.begin);
    fill_shape(pulse, grid, delay_s, clock, on, shape);
    const std::complex<double> amplitude =
        echoes.amplitude_sqrt_w[k] * turn(-cycle_fraction(echoes.late_turns(k, carrier_hz)));
    if (echoes.clock(k).ticks_evenly()) {
      for (std::size_t i = on.begin; i < on.end; ++i) row[i] += amplitude * shape[i - on.begin];
      continue;
    }
    const double sweep_rate = pulse.pulse.sweep_rate_hz_per_s();
    for (std::size_t i = on.begin; i < on.end; ++i) {
      const double u = pulse.from_middle_s(grid.time_s(i) - delay_s);
      const double turns = pulse.doppler_rule == DopplerRule::stretch
                               ? carrier_hz * clock.late(u)
                               : echoes.doppler[k] * (carrier_hz * u + 0.5 * sweep_rate * u * u);
      row[i] += amplitude * shape[i - on.begin] * turn(-turns);
    }
  }
}

}  // namespace sarsim::radar
