#include "radar/echo/reference_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::radar {

namespace {

constexpr double edge_tolerance = 1e-9;  // of a sampling interval (decision 8)

// Fraction of a cycle, so that multiplying by 2 pi loses nothing.
double cycle_fraction(double cycles) { return cycles - std::round(cycles); }

std::complex<double> turn(double cycles) { return std::polar(1.0, 2.0 * core::pi * cycles); }

}  // namespace

SampleSpan touched_samples(const EchoPulse& pulse, const SampleGrid& grid, double delay_s) {
  const auto index_from = [&](double time_s) {
    const double index = std::ceil((time_s - grid.first_s) / grid.interval_s - edge_tolerance);
    return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(grid.count)));
  };
  return {index_from(delay_s + pulse.first_s()), index_from(delay_s + pulse.last_s())};
}

void add_echoes(std::span<std::complex<double>> row, const SampleGrid& grid, const EchoPulse& pulse, double carrier_hz,
                const EchoBatch& echoes) {
  CORE_EXPECT(row.size() >= grid.count);
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(pulse.light_speed_mps > 0.0);
  CORE_EXPECT(std::isfinite(carrier_hz));
  CORE_EXPECT(echoes.amplitude_sqrt_w.size() == echoes.delay_s.size());
  CORE_EXPECT(echoes.speed_mps.size() == echoes.delay_s.size());
  const double tolerance_s = edge_tolerance * grid.interval_s;
  const double sweep_rate = pulse.pulse.sweep_rate_hz_per_s();
  std::vector<std::complex<double>> shape;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const SampleSpan on = touched_samples(pulse, grid, echoes.delay_s[k]);
    if (on.begin >= on.end) continue;
    const auto after_edge = [&](std::size_t i) { return grid.time_s(i) - echoes.delay_s[k] + pulse.lead_s; };
    shape.resize(on.end - on.begin);
    if (pulse.band_limited)
      pulse.band_limited->values(after_edge(on.begin), shape);
    else
      for (std::size_t i = on.begin; i < on.end; ++i)
        shape[i - on.begin] = pulse.pulse.value(std::max(0.0, after_edge(i)), tolerance_s);

    const double doppler = delay_of(echoes.speed_mps[k], pulse.light_speed_mps);
    const std::complex<double> amplitude =
        echoes.amplitude_sqrt_w[k] * turn(-cycle_fraction(carrier_hz * echoes.delay_s[k]));
    if (doppler == 0.0) {
      for (std::size_t i = on.begin; i < on.end; ++i) row[i] += amplitude * shape[i - on.begin];
      continue;
    }
    for (std::size_t i = on.begin; i < on.end; ++i) {
      const double u = after_edge(i) - 0.5 * pulse.pulse.width_s;
      row[i] += amplitude * shape[i - on.begin] * turn(-doppler * (carrier_hz * u + 0.5 * sweep_rate * u * u));
    }
  }
}

}  // namespace sarsim::radar
