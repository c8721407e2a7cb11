#pragma once

#include "scene/model/scene.hpp"

/// A flight that tests of recordings and of simulation windows share.
namespace sarsim::simulate {

/// A side-looking radar on a jittering aircraft over jittering targets, a moving and a directional one among them:
/// chirp of 20 MHz and 1 us, 1 kHz, noise.
inline scene::Scene flight_scene() {
  const auto line = [](double a, double b) {
    return core::SampledFunction{core::Interpolation::linear, {{0.0, a}, {1.0, b}}};
  };
  scene::Scene scene;
  scene.platforms.push_back({});
  scene::Platform plane;
  plane.name = "Plane";
  plane.path = scene::Platform::Path::trajectory;
  plane.trajectory_m.part = {line(0.0, 120.0), line(-2000.0, -2000.0), line(1000.0, 1010.0)};
  plane.position_stddev_m = {0.01, 0.02, 0.01};
  plane.rotation_stddev[1] = core::Angle::from_deg(0.2);
  scene.platforms.push_back(plane);
  scene::Platform car;
  car.name = "Car";
  car.path = scene::Platform::Path::trajectory;
  car.trajectory_m.part = {line(10.0, 0.0), line(50.0, 75.0), line(0.0, 0.0)};
  scene.platforms.push_back(car);
  for (int i = 0; i < 6; ++i) {
    scene::Target target;
    target.position_m = {15.0 * i - 40.0, 12.0 * i, 1.0};
    target.rcs_m2 = 1.0 + i;
    if (i == 1) target.traits.edit().position_stddev_m = {0.02, 0.03, 0.01};
    if (i == 2) target.traits.edit().rcs_stddev_m2 = 0.5;
    if (i == 3) target.platform = "Car";
    if (i == 4) {
      target.traits.edit().reflectivity = scene::Target::Reflectivity::directional;
      target.traits.edit().azimuth = core::Angle::from_deg(-90.0);
      target.traits.edit().elevation = core::Angle::from_deg(20.0);
      target.traits.edit().azimuth_stddev = core::Angle::from_deg(2.0);
    }
    scene.targets.push_back(target);
  }
  scene::Radar radar;
  radar.platform = "Plane";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 20e6;
  radar.pulse_width_s = 1e-6;
  radar.carrier_hz = 5e9;
  radar.noise_temperature_k = 300.0;
  radar.transmit_antenna.pattern = scene::Antenna::Pattern::sinx;
  radar.transmit_antenna.azimuth_beamwidth = core::Angle::from_deg(40.0);
  radar.transmit_antenna.elevation_beamwidth = core::Angle::from_deg(60.0);
  radar.beam_elevation = core::Angle::from_deg(-26.0);
  scene.radars.push_back(radar);
  return scene;
}

/// A recording of the flight's echoes by its radar, 60 MHz, into sim.bin.
inline scene::Simulation flight_recording(double lsb_v, scene::FileFormat format) {
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 2100.0;
  simulation.range_end_m = 2700.0;
  simulation.time_start_s = -0.01;
  simulation.time_end_s = 0.01;
  simulation.sample_rate_hz = 60e6;
  simulation.lsb_v = lsb_v;
  simulation.format = format;
  simulation.file = "sim.bin";
  return simulation;
}

}  // namespace sarsim::simulate
