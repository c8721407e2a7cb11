#pragma once

#include <algorithm>
#include <complex>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulate/plan/simulate_test_scene.hpp"
#include "workflow/search/pulse_rows.hpp"
#include "workflow/search/search_intervals.hpp"

/// Radars for the tests of pulse trains: at the origin, 10 GHz, 4 kHz, isotropic.
namespace sarsim::workflow {

inline constexpr double search_prf_hz = 4000.0;

/// A chirp of 10 MHz and 10 us; one target at y = 5000 m that recedes at a speed; no noise. 1024 pulses, 4700 to 5300 m
/// at 12.5 MHz.
inline scene::Scene pulse_scene(double speed_mps, int pulses = 1024) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene.platforms.push_back(simulate::moving("Car", {0.0, 5000.0, 0.0}, {0.0, speed_mps, 0.0}));
  scene.targets.push_back(simulate::target_on("Car", {}));
  scene::Radar radar;
  radar.pulse = scene::Radar::Pulse::chirp;
  radar.bandwidth_hz = 10e6;
  radar.pulse_width_s = 10e-6;
  radar.prf_hz = search_prf_hz;
  radar.carrier_hz = 10e9;
  radar.window = scene::Radar::Window::hamming;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 4700.0;
  simulation.range_end_m = 5300.0;
  simulation.time_end_s = (pulses - 0.5) / search_prf_hz;
  simulation.sample_rate_hz = 12.5e6;
  scene.simulations.push_back(simulation);
  return scene;
}

/// A pulse of a single sample, so that noise is independent from sample to sample: 1 MHz, 290 K, no target. `samples`
/// ranges 149.9 m apart from 15 km on.
inline scene::Scene noise_scene(int pulses, int samples) {
  scene::Scene scene;
  scene.platforms.push_back(simulate::resting("Earth", {}));
  scene::Radar radar;
  radar.pulse_width_s = 1e-6;
  radar.prf_hz = search_prf_hz;
  radar.carrier_hz = 10e9;
  radar.noise_temperature_k = 290.0;
  scene.radars.push_back(radar);
  scene::Simulation simulation;
  simulation.radar = "Radar1";
  simulation.range_start_m = 15e3;
  simulation.range_end_m = 15e3 + samples * 0.5 * core::exact_light_speed_mps / 1e6;
  simulation.time_end_s = (pulses - 0.5) / search_prf_hz;
  simulation.sample_rate_hz = 1e6;
  scene.simulations.push_back(simulation);
  return scene;
}

inline PulseRows pulse_rows_of(scene::Scene scene) {
  scene.simulations[0] = compressed_simulation(scene.simulations[0]);
  return pulse_rows_of_scene(std::make_shared<const simulate::Acquisition>(simulate::acquisition_of(scene, 0)));
}

/// All intervals, kept.
inline std::vector<SearchInterval> intervals_of(const PulseRows& rows, const SearchOptions& options,
                                                unsigned threads = 2) {
  std::vector<SearchInterval> intervals;
  each_interval(rows, options, {threads, nullptr}, {},
                [&](const SearchInterval& interval) { intervals.push_back(interval); });
  return intervals;
}

inline const SearchDetection& strongest(const SearchInterval& interval) {
  if (interval.detections.empty()) throw std::runtime_error("nothing was detected");
  return *std::ranges::max_element(interval.detections, {}, &SearchDetection::magnitude_v);
}

}  // namespace sarsim::workflow
