#include "signal/stepped/stepped_limits.hpp"

#include <cmath>
#include <limits>

#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// By how many places of the burst the pulses of a step come later than those of the step below it, on the average: the
// slope of the line through places against steps; 1 for carriers in turn.
double places_per_step(const SteppedWaveform& w) {
  if (w.order.empty()) return 1.0;
  const double middle = 0.5 * static_cast<double>(w.steps - 1);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t place = 0; place < w.steps; ++place) {
    const double step = static_cast<double>(w.order[place]) - middle;
    products += step * (static_cast<double>(place) - middle);
    squares += step * step;
  }
  return products / squares;
}

}  // namespace

double SteppedLimits::smear_cells(double speed_mps) const {
  return std::abs(smear_m_per_mps * speed_mps) / resolution_m;
}

SteppedLimits limits_of(const SteppedBand& band, double pulse_interval_s) {
  CORE_EXPECT(pulse_interval_s > 0.0);
  const SteppedWaveform& w = band.waveform();
  const double c = w.light_speed_mps;
  SteppedLimits limits;
  limits.step_time_s = pulse_interval_s * static_cast<double>(w.pulses_per_step);
  limits.burst_time_s = limits.step_time_s * static_cast<double>(w.steps - 1);
  limits.resolution_m = radar::range_of_cycle(band.band_hz(), c);
  limits.unambiguous_range_m = limits.tolerable_mps = limits.ambiguous_mps = std::numeric_limits<double>::infinity();
  if (w.subband_hz <= 0.0) limits.seen_m = radar::range_of(w.seen_to_s - w.seen_from_s, c);
  if (w.steps < 2) return limits;
  limits.unambiguous_range_m = radar::range_of_cycle(std::abs(w.carrier_step_hz), c);
  limits.shift_m_per_mps = band.centre_hz() * limits.step_time_s / w.carrier_step_hz * places_per_step(w);
  limits.smear_m_per_mps = 2.0 * limits.burst_time_s;
  limits.tolerable_mps = 0.25 * limits.resolution_m / limits.burst_time_s;
  limits.ambiguous_mps = radar::range_of_cycle(band.centre_hz() * limits.step_time_s, c);
  return limits;
}

}  // namespace sarsim::signal
