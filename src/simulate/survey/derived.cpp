#include "simulate/survey/derived.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "radar/path/path.hpp"
#include "radar/receiver/converter.hpp"
#include "radar/waveform/pulse.hpp"
#include "simulate/survey/pulse_motion.hpp"

namespace sarsim::simulate {

namespace {

// Mean of |pulse|^2 over the pulse width; midpoints, so that edges and chips count with their length.
double mean_square(const radar::Pulse& pulse) {
  constexpr int points = 4096;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) sum += std::norm(pulse.value((i + 0.5) / points * pulse.width_s));
  return sum / points;
}

// Of an unmodulated pulse too, as which a chirp without a sweep counts.
double band_of(const radar::Pulse& pulse) {
  const double bandwidth_hz = radar::bandwidth_hz(pulse);
  return bandwidth_hz > 0.0 ? bandwidth_hz : 1.0 / pulse.width_s;
}

double largest_in_window_v(const EchoSurvey& survey) {
  double largest = 0.0;
  for (const TargetSurvey& target : survey.targets)
    if (target.in_window) largest = std::max(largest, target.largest_amplitude_v);
  return largest;
}

double largest_stc_gain(const Acquisition& acquisition) {
  double largest = acquisition.reception.stc_gain.empty() ? 1.0 : 0.0;
  for (const double gain : acquisition.reception.stc_gain) largest = std::max(largest, std::abs(gain));
  return largest;
}

}  // namespace

RadarFigures radar_figures(const Link& radar, double peak_power_w, const Conventions& conventions) {
  CORE_EXPECT(conventions.light_speed_mps > 0.0);
  CORE_EXPECT(conventions.boltzmann_j_per_k > 0.0);
  const double c = conventions.light_speed_mps;
  RadarFigures f;
  f.lowest_carrier_hz = radar.carrier.lowest_hz();
  f.highest_carrier_hz = radar.carrier.highest_hz();
  f.longest_wavelength_m = radar::wavelength_of(f.lowest_carrier_hz, c);
  f.shortest_wavelength_m = radar::wavelength_of(f.highest_carrier_hz, c);
  f.bandwidth_hz = band_of(radar.pulse);
  const bool shaped = radar.pulse.kind == radar::Pulse::Kind::user;
  f.range_resolution_m = radar::range_of(shaped ? radar::half_power_width_s(radar.pulse) : 1.0 / f.bandwidth_hz, c);
  if (radar.carrier.steps() > 1)
    f.synthetic_range_resolution_m =
        radar::range_of_cycle(radar.carrier.steps() * std::abs(radar.carrier.step_hz()), c);
  f.pulse_length_m = c * radar.pulse.width_s;
  f.time_bandwidth = f.bandwidth_hz * radar.pulse.width_s;
  f.shortest_pri_s = radar.repetition.shortest_interval_s();
  f.mean_prf_hz = 1.0 / radar.repetition.mean_interval_s();
  f.unambiguous_range_m = radar::range_of(f.shortest_pri_s, c);
  f.unambiguous_speed_mps = 0.25 * f.shortest_wavelength_m * f.mean_prf_hz;
  f.duty_cycle = radar.pulse.width_s * f.mean_prf_hz;
  f.mean_power_w = peak_power_w * f.duty_cycle * mean_square(radar.pulse);
  f.noise_density_w_per_hz = conventions.boltzmann_j_per_k * radar.noise_temperature_k;
  f.noise_power_w = f.noise_density_w_per_hz * f.bandwidth_hz;
  return f;
}

double processing_gain(const Acquisition& acquisition) {
  CORE_EXPECT(acquisition.scene != nullptr);
  if (!acquisition.reception.compressor) return 1.0;
  radar::EchoPulse pulse = acquisition.reception.pulse;
  pulse.lead_s = 0.0;
  std::vector<std::complex<double>> raw(acquisition.reception.raw_grid.count);
  // A lone echo that begins at the first sample, or as much earlier as a band-limited pulse has a tail before its edge.
  radar::SampleGrid grid{0.0, acquisition.reception.raw_grid.interval_s, acquisition.reception.raw_grid.count};
  const double tail_intervals = std::ceil(-std::min(0.0, pulse.first_s()) / grid.interval_s);
  radar::EchoBatch echo;
  echo.add(tail_intervals * grid.interval_s, 1.0, 0.0);
  radar::add_echoes(raw, grid, pulse, 0.0, echo);
  std::vector<std::complex<double>> out(acquisition.reception.compressor->output_count());
  std::vector<std::complex<double>> scratch(acquisition.reception.compressor->scratch_size());
  acquisition.reception.compressor->compress(raw, out, scratch);
  return radar::largest_magnitude(out);
}

SimulationFigures simulation_figures(const Acquisition& acquisition, const EchoSurvey& survey) {
  CORE_EXPECT(acquisition.scene != nullptr);
  CORE_EXPECT(!acquisition.reception.column_range_m.empty());
  const double c = acquisition.light_speed_mps();
  SimulationFigures f;
  f.first_delay_s = radar::delay_of(acquisition.reception.column_range_m.front(), c);
  f.last_delay_s = radar::delay_of(acquisition.reception.column_range_m.back(), c);
  if (acquisition.reception.column_range_m.size() > 1)
    f.column_spacing_m = acquisition.reception.column_range_m[1] - acquisition.reception.column_range_m[0];
  f.sampling_ratio = acquisition.reception.sample_rate_hz / band_of(acquisition.link.pulse);
  constexpr std::size_t max_targets = 4096;
  f.pulse_motion_rad = motion_left_in_pulse(acquisition, targets_in_window(survey, max_targets)).phase_rad;
  f.noise_power_w = 2.0 * acquisition.reception.noise_stddev_v * acquisition.reception.noise_stddev_v;
  const double gain = processing_gain(acquisition) * largest_stc_gain(acquisition);
  f.largest_echo_v = gain * largest_in_window_v(survey);
  f.largest_sum_v = gain * (survey.largest_sum_v + 3.0 * std::sqrt(2.0) * acquisition.reception.noise_stddev_v);
  f.suggested_lsb_v = f.largest_sum_v / radar::full_scale_count(acquisition.simulation.bits);
  return f;
}

}  // namespace sarsim::simulate
