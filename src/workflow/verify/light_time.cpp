#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "core/maths/constants.hpp"
#include "workflow/verify/groups.hpp"
#include "workflow/verify/own_path.hpp"
#include "workflow/verify/scenes.hpp"

namespace sarsim::workflow::verify {

namespace {

// A radar and a target that fly straight on, and the chirp between them.
struct Flight {
  std::string name;
  core::Vec3 radar_m;
  core::Vec3 radar_mps;
  core::Vec3 target_m;
  core::Vec3 target_mps;
  double carrier_hz;
  double swept_hz;
  double width_s;
};

// The largest error of the phase of two pulses' samples, 40 to a pulse, from a solution of the light-time equation for
// the time at which each was sent.
double worst_phase_rad(const Flight& f, scene::Simulation::PulsePosition position) {
  scene::Scene scene = radar_at_origin();
  add_mover(scene, "Radar", f.radar_m, f.radar_mps);
  add_mover(scene, "Target", f.target_m, f.target_mps);
  scene::Radar& radar = scene.radars[0];
  radar.platform = "Radar";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.carrier_hz = f.carrier_hz;
  radar.bandwidth_hz = f.swept_hz;
  radar.pulse_width_s = f.width_s;
  radar.prf_hz = 100.0;
  add_target(scene, {}, 1.0, "Target");
  scene.simulations[0].pulse_position = position;
  const Motion from = straight_motion(place(f.radar_m), place(f.radar_mps));
  const Motion to = straight_motion(place(f.target_m), place(f.target_mps));
  const double range_m = 0.5 * core::exact_light_speed_mps * static_cast<double>(two_way_s(from, to, 0.0L));
  const double reach_m = 0.5 * core::exact_light_speed_mps * f.width_s;
  set_window(scene, std::max(0.0, range_m - 0.6123 * reach_m), range_m + 1.1 * reach_m, 40.0 / f.width_s);
  set_pulses(scene, 0, 1);
  const bool begin = position == scene::Simulation::PulsePosition::begin;
  const simulate::Recording recording = recorded(scene);
  double worst_rad = 0.0;
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    const std::complex<double> found = recording.samples[i];
    if (found == 0.0) continue;
    const double row_s = 2.0 * scene.simulations[0].range_start_m / core::exact_light_speed_mps +
                         static_cast<double>(i % recording.report.columns) / scene.simulations[0].sample_rate_hz;
    const std::complex<double> expected =
        echo_received(from, to, i < recording.report.columns ? 0.0 : 0.01, begin ? row_s - 0.5 * f.width_s : row_s,
                      f.carrier_hz, f.swept_hz / f.width_s);
    worst_rad = std::max(worst_rad, std::abs(std::arg(found * std::conj(expected))));
  }
  return recording.report.zero < recording.samples.size() ? worst_rad : core::pi;
}

// The largest error of samples of a target at 203 km, which a window around 53.1 km hears of the pulse 1 ms before;
// over its amplitude. Infinite where another sample is on.
double second_time_around_error() {
  constexpr double range_m = 203e3;
  constexpr double rcs_m2 = 1e4;
  scene::Scene scene = radar_at_origin();
  scene::Radar& radar = scene.radars[0];
  radar.carrier_hz = 10e9;
  radar.pulse_width_s = 10e-6;
  add_target(scene, {0.0, range_m, 0.0}, rcs_m2);
  set_window(scene, 52e3, 55e3, 4e6);
  set_pulses(scene, 0, 2);
  const simulate::Recording recording = recorded(scene);
  const double lambda_m = core::exact_light_speed_mps / radar.carrier_hz;
  const double amplitude = std::sqrt(1e3 * rcs_m2) * lambda_m / (std::pow(4.0 * core::pi, 1.5) * range_m * range_m);
  const std::complex<double> echo =
      std::polar(amplitude, -4.0 * core::pi * std::fmod(range_m, 0.5 * lambda_m) / lambda_m);
  const double arrives_s = 2.0 * range_m / core::exact_light_speed_mps - 1.0 / radar.prf_hz;
  double worst = 0.0;
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    const double after_s =
        2.0 * 52e3 / core::exact_light_speed_mps + static_cast<double>(i % recording.report.columns) / 4e6 - arrives_s;
    const bool on = after_s >= 0.0 && after_s < radar.pulse_width_s;
    worst = std::max(worst, std::abs(std::complex<double>(recording.samples[i]) - (on ? echo : 0.0)));
  }
  return worst / amplitude;
}

}  // namespace

void measure_light_time(Record& record) {
  using Position = scene::Simulation::PulsePosition;
  const core::Vec3 none;
  for (const Flight& f :
       {Flight{"satellite, X band", none, {0.0, 7600.0, 0.0}, {700e3, 250e3, 0.0}, none, 9.65e9, 1.2e9, 50e-6},
        Flight{
            "satellite, Ka band", none, {0.0, 7600.0, 0.0}, {700e3, 0.0, 0.0}, {3.0, 2.0, 0.0}, 35.75e9, 0.5e9, 100e-6},
        Flight{"missile of 2 km/s", none, none, {60e3, 5e3, 0.0}, {-2000.0, 100.0, 0.0}, 9.6e9, 1e9, 100e-6},
        Flight{"aircraft", none, {200.0, 0.0, 0.0}, {3e3, 40e3, 0.0}, {20.0, -300.0, 5.0}, 9.6e9, 0.5e9, 100e-6},
        Flight{"car at 77 GHz, 1 ms", none, none, {100.0, 3.0, 0.0}, {-50.0, 0.0, 0.0}, 77e9, 150e6, 1e-3}})
    for (const Position position : {Position::begin, Position::centre})
      record.at_most("Error of the phase, " + f.name + (position == Position::begin ? ", BEGIN" : ", CENTRE"), "rad",
                     6e-4, worst_phase_rad(f, position), "light-time equation of every sample; 1e-4 of a wavelength");
  record.at_most("Relative error of an echo that comes with the next pulse", "", 1e-6, second_time_around_error(),
                 "radar equation and delay of its own pulse");
}

}  // namespace sarsim::workflow::verify
