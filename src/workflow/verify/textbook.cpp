#include "workflow/verify/textbook.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::workflow::verify {

void add_textbook_echoes(std::span<std::complex<double>> row, const radar::SampleGrid& grid,
                         const radar::EchoPulse& pulse, double carrier_hz, const radar::EchoBatch& echoes) {
  const double rate_hz_per_s = pulse.pulse.sweep_rate_hz_per_s();
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const radar::PulseClock clock = pulse.clock_of(echoes, k);
    const radar::SampleSpan on = radar::touched_samples(pulse, grid, echoes.delay_s[k], clock);
    for (std::size_t n = on.begin; n < on.end; ++n) {
      const double u = grid.time_s(n) - echoes.delay_s[k] + pulse.lead_s - 0.5 * pulse.pulse.width_s;
      const double sent = clock.sent(u);
      const double phase =
          2.0 * core::pi *
          (0.5 * rate_hz_per_s * sent * sent - echoes.late_turns(k, carrier_hz) - carrier_hz * clock.late(u));
      row[n] += std::complex<double>(echoes.amplitude_sqrt_w[k] * std::cos(phase),
                                     echoes.amplitude_sqrt_w[k] * std::sin(phase));
    }
  }
}

}  // namespace sarsim::workflow::verify
