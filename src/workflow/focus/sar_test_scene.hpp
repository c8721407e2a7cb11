#pragma once

#include "signal/measure/image_quality.hpp"
#include "simulate/plan/simulate_test_scene.hpp"
#include "simulate/run/run.hpp"
#include "workflow/focus/azimuth_ambiguities.hpp"
#include "workflow/focus/sar_rows.hpp"

/// Thesis 7.1 for tests: 200 m/s along y, 2000 m high, the scene 10 km away along x; a chirp of 100 MHz and 800 ns.
namespace sarsim::workflow {

inline scene::Scene sar_scene(double prf_hz, const std::vector<core::Vec3>& targets_m, double half_time_s = 1.0) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene.platforms.push_back(simulate::moving("Plane", {-10000.0, 0.0, 2000.0}, {0.0, 200.0, 0.0}));
  for (const core::Vec3& target : targets_m) scene.targets.push_back(simulate::target_on("Earth", target));
  scene::Radar radar;
  radar.platform = "Plane";
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 100e6;
  radar.pulse_width_s = 800e-9;
  radar.prf_hz = prf_hz;
  radar.carrier_hz = 5.3e9;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 10098.0;
  simulation.range_end_m = 10298.0;
  simulation.time_start_s = -half_time_s;
  simulation.time_end_s = half_time_s - 0.5 / prf_hz;
  simulation.sample_rate_hz = 150e6;
  scene.simulations.push_back(simulation);
  return scene;
}

inline std::shared_ptr<const simulate::Acquisition> shared_acquisition(const scene::Scene& scene) {
  return std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0));
}

/// Rows of the scene's first simulation, recorded anew.
inline std::pair<std::shared_ptr<const simulate::Acquisition>, signal::EchoRows> sar_recording(scene::Scene scene) {
  const simulate::Acquisition window = simulate::acquisition_of(scene, 0);
  scene.simulations[0] = recorded_for_sar(scene.simulations[0], window);
  const auto acquisition = shared_acquisition(scene);
  return {acquisition, sar_rows_of_scene(acquisition, window.reception.columns)};
}

/// Rows of a recording that holds what the scene's plan makes.
inline std::pair<std::shared_ptr<const simulate::Acquisition>, signal::EchoRows> stored(const scene::Scene& scene) {
  const auto acquisition = shared_acquisition(scene);
  const auto recording = std::make_shared<const simulate::Recording>(
      simulate::record(simulate::plan_of(*acquisition, simulate::Engine::automatic)));
  return {acquisition,
          sar_rows_of_recording(
              acquisition, core::rows_in_memory(
                               std::shared_ptr<const std::vector<std::complex<double>>>(recording, &recording->samples),
                               acquisition->timing.rows, acquisition->reception.columns))};
}

inline signal::PointResponse focused_point(const signal::EchoRows& rows, const signal::ImagePlace& place,
                                           const signal::FocusOptions& options = {}) {
  const signal::SarEchoes echoes = signal::sar_echoes(rows, {.threads = 2});
  const signal::FocusedImage image = signal::focus(echoes, options, {.threads = 2});
  return signal::measure_point(image, signal::reader_of(image), place, 2.0).value();
}

}  // namespace sarsim::workflow
