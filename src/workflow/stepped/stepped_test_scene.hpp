#pragma once

#include "simulate/plan/simulate_test_scene.hpp"

/// A radar of stepped frequencies for tests.
namespace sarsim::workflow {

/// 32 steps of 5 MHz from 9 GHz at 4 kHz; targets rest on Earth or fly.
inline scene::Scene stepped_scene(double end_s = 0.05) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene::Radar radar;
  radar.platform = "Earth";
  radar.pulse = scene::Radar::Pulse::mono;
  radar.pulse_width_s = 200e-9;
  radar.prf_hz = 4000.0;
  radar.carrier = scene::Radar::Carrier::stepped;
  radar.carrier_hz = 9e9;
  radar.carrier_step_hz = 5e6;
  radar.carrier_steps = 32;
  radar.pulses_per_step = 1;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 2950.0;
  simulation.range_end_m = 3080.0;
  simulation.time_end_s = end_s;
  simulation.sample_rate_hz = 10e6;
  scene.simulations.push_back(simulation);
  return scene;
}

}  // namespace sarsim::workflow
