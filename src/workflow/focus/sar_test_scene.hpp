#pragma once

#include "signal/measure/image_quality.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "workflow/focus/sar_ghosts.hpp"
#include "workflow/focus/sar_rows.hpp"

/// Thesis 7.1 for tests: 200 m/s along y, 2000 m high, the scene 10 km away along x; a chirp of 100 MHz and 800 ns.
namespace sarsim {

inline Scene sar_scene(double prf_hz, const std::vector<Vec3>& targets_m, double half_time_s = 1.0) {
  Scene scene;
  scene.platforms.push_back(resting("Earth", {}));
  scene.platforms.push_back(moving("Plane", {-10000.0, 0.0, 2000.0}, {0.0, 200.0, 0.0}));
  for (const Vec3& target : targets_m) scene.targets.push_back(target_on("Earth", target));
  Radar radar;
  radar.platform = "Plane";
  radar.pulse = Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 800e-9;
  radar.prf_hz = prf_hz;
  radar.carrier_hz = 5.3e9;
  scene.radars.push_back(radar);
  Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 10098.0;
  simulation.range_end_m = 10298.0;
  simulation.time_start_s = -half_time_s;
  simulation.time_end_s = half_time_s - 0.5 / prf_hz;
  simulation.sample_rate_hz = 150e6;
  scene.simulations.push_back(simulation);
  return scene;
}

inline std::shared_ptr<const Plan> shared_plan(const Scene& scene) {
  return std::make_shared<const Plan>(make_plan(scene, 0));
}

/// Rows of the scene's first simulation, recorded anew.
inline std::pair<std::shared_ptr<const Plan>, EchoRows> sar_recording(Scene scene) {
  const Plan window = make_plan(scene, 0);
  scene.simulations[0] = recorded_for_sar(scene.simulations[0], window);
  const auto plan = shared_plan(scene);
  return {plan, sar_rows_of_scene(plan, window.columns)};
}

inline PointResponse focused_point(const EchoRows& rows, const ImagePlace& place, const FocusOptions& options = {}) {
  const SarEchoes echoes = sar_echoes(rows, {.threads = 2});
  const FocusedImage image = focus(echoes, options, {.threads = 2});
  return measure_point(image, reader_of(image), place, 2.0).value();
}

}  // namespace sarsim
