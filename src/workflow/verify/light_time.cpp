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
}

}  // namespace sarsim::workflow::verify
