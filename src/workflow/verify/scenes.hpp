#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "simulate/run/run.hpp"

/// Small scenes to measure with: a radar at the world's origin, a few targets, one simulation.
namespace sarsim::workflow::verify {

/// "Earth" at rest with the radar "Radar1" (1 kW, 1 GHz, 1 kHz, monochrome, isotropic) and a simulation of it that
/// records one pulse from 0 to 2 km at 4 MHz.
inline scene::Scene radar_at_origin(scene::Profile profile = scene::Profile::physical) {
  scene::Scene scene;
  scene.options.profile = profile;
  scene.platforms.emplace_back();
  scene.radars.emplace_back();
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 2000.0;
  simulation.time_end_s = 0.0;
  simulation.sample_rate_hz = 4e6;
  scene.simulations.push_back(simulation);
  return scene;
}

/// Adds an isotropic point.
inline scene::Target& add_target(scene::Scene& scene, const core::Vec3& position_m, double rcs_m2 = 1.0,
                                 const std::string& platform = "Earth") {
  scene::Target target;
  target.platform = platform;
  target.position_m = position_m;
  target.rcs_m2 = rcs_m2;
  scene.targets.push_back(target);
  return scene.targets.back();
}

/// A straight line through `start_m` at t = 0.
inline scene::UserFunction<3> straight_path(const core::Vec3& start_m, const core::Vec3& velocity_mps) {
  const auto axis = [](double start, double speed) {
    return core::SampledFunction{core::Interpolation::linear, {{-1.0, start - speed}, {1.0, start + speed}}};
  };
  scene::UserFunction<3> path;
  path.part = {axis(start_m.x, velocity_mps.x), axis(start_m.y, velocity_mps.y), axis(start_m.z, velocity_mps.z)};
  return path;
}

/// Adds a platform that is at `start_m` at t = 0 and moves straight on.
inline scene::Platform& add_mover(scene::Scene& scene, const std::string& name, const core::Vec3& start_m,
                                  const core::Vec3& velocity_mps) {
  scene::Platform platform;
  platform.name = name;
  platform.path = scene::Platform::Path::trajectory;
  platform.trajectory_m = straight_path(start_m, velocity_mps);
  scene.platforms.push_back(platform);
  return scene.platforms.back();
}

/// Adds a platform that rests.
inline scene::Platform& add_platform(scene::Scene& scene, const std::string& name, const core::Vec3& position_m) {
  scene::Platform platform;
  platform.name = name;
  platform.position_m = position_m;
  scene.platforms.push_back(platform);
  return scene.platforms.back();
}

/// Sets the window of the scene's simulation.
inline void set_window(scene::Scene& scene, double start_m, double end_m, double sample_rate_hz) {
  scene::Simulation& simulation = scene.simulations[0];
  simulation.range_start_m = start_m;
  simulation.range_end_m = end_m;
  simulation.sample_rate_hz = sample_rate_hz;
}

/// Records pulses first ... last of a radar with constant repetition.
inline void set_pulses(scene::Scene& scene, int first, int last) {
  scene.simulations[0].time_start_s = first / scene.radars[0].prf_hz;
  scene.simulations[0].time_end_s = last / scene.radars[0].prf_hz;
}

/// The scene's first simulation in volts.
inline simulate::Recording recorded(const scene::Scene& scene) {
  return simulate::record(simulate::make_plan(scene, 0));
}

/// One column of a recording: slow time at one range.
inline std::vector<std::complex<double>> column(const simulate::Recording& recording, std::size_t index) {
  std::vector<std::complex<double>> samples;
  for (std::size_t row = 0; row < recording.report.rows; ++row)
    samples.push_back(recording.samples[row * recording.report.columns + index]);
  return samples;
}

/// Index of the largest magnitude.
inline std::size_t peak_index(const std::vector<std::complex<double>>& samples) {
  std::size_t peak = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (std::norm(samples[i]) > std::norm(samples[peak])) peak = i;
  return peak;
}

/// Angle brought into (-pi, pi].
inline double wrapped_rad(double angle_rad) { return std::remainder(angle_rad, 2.0 * core::pi); }

}  // namespace sarsim::workflow::verify
