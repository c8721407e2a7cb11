#pragma once

#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"
#include "scene/model/scene.hpp"
#include "simulate/run/run.hpp"

/// Scenes and small tools that the tests of this folder share.
namespace sarsim::simulate {

/// A function of straight lines through the given points.
inline core::SampledFunction lines(std::vector<core::Knot> knots) {
  return {core::Interpolation::linear, std::move(knots)};
}

/// A platform named `name` that rests at a world position.
inline scene::Platform resting(std::string name, const core::Vec3& position_m) {
  scene::Platform platform;
  platform.name = std::move(name);
  platform.position_m = position_m;
  return platform;
}

/// A platform that passes `at_zero_m` at t = 0 with a constant velocity.
inline scene::Platform moving(std::string name, const core::Vec3& at_zero_m, const core::Vec3& velocity_mps) {
  scene::Platform platform;
  platform.name = std::move(name);
  platform.path = scene::Platform::Path::trajectory;
  platform.trajectory_m.part = {lines({{0.0, at_zero_m.x}, {1.0, at_zero_m.x + velocity_mps.x}}),
                                lines({{0.0, at_zero_m.y}, {1.0, at_zero_m.y + velocity_mps.y}}),
                                lines({{0.0, at_zero_m.z}, {1.0, at_zero_m.z + velocity_mps.z}})};
  return platform;
}

inline scene::Target target_on(std::string platform, const core::Vec3& position_m, double rcs_m2 = 1.0) {
  scene::Target target;
  target.platform = std::move(platform);
  target.position_m = position_m;
  target.rcs_m2 = rcs_m2;
  return target;
}

/// Thesis A.2: 1 kW, 1 GHz, isotropic, at the origin; a pulse of 5 us; one target of 1 m^2 at 1 km; one pulse at t = 0;
/// 0 to 2000 m at 4 MHz.
inline scene::Scene one_target_scene() {
  scene::Scene scene;
  scene.platforms.push_back(resting("Earth", {}));
  scene.targets.push_back(target_on("Earth", {1000.0, 0.0, 0.0}));
  scene.radars.push_back({});
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_end_m = 2000.0;
  simulation.time_end_s = 0.0;
  simulation.sample_rate_hz = 4e6;
  scene.simulations.push_back(simulation);
  return scene;
}

/// Square root of the power that the radar equation gives for 1 kW and no gains (thesis 2.2).
inline double equation_amplitude(double distance_m, double rcs_m2, double wavelength_m) {
  return std::sqrt(1000.0 * wavelength_m * wavelength_m * rcs_m2 /
                   (std::pow(4.0 * core::pi, 3.0) * std::pow(distance_m, 4.0)));
}

inline std::vector<std::complex<double>> samples_of(const scene::Scene& scene) {
  raster::RunControl control;
  control.threads = 1;
  return record(make_plan(scene, 0), control).samples;
}

}  // namespace sarsim::simulate
