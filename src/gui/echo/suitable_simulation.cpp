#include <algorithm>
#include <cmath>
#include <exception>
#include <string>

#include "core/maths/rounding.hpp"
#include "gui/runs/stored_simulations.hpp"
#include "radar/path/path.hpp"
#include "scene/check/check.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/survey/derived.hpp"

namespace sarsim::gui {

namespace {

constexpr double pulses_shown = 64.0;
constexpr double oversampling = 1.2;

std::string free_file(const scene::Scene& scene) {
  for (std::size_t number = scene.simulations.size() + 1;; ++number) {
    const std::string name = "sim" + std::to_string(number) + ".bin";
    if (std::ranges::none_of(scene.simulations, [&](const scene::Simulation& s) { return s.file == name; }))
      return name;
  }
}

// Two or three significant digits, so that fields show figures one might have typed.
double rounded_up(double value, double step) { return std::ceil(value / step) * step; }

// The radar with what it looks at; recordings may be faulty.
bool sound(const scene::Scene& scene) {
  scene::Scene bare = scene;
  bare.simulations.clear();
  bare.geometries.clear();
  return !core::has_errors(scene::check(bare));
}

void suit_ranges(const simulate::ResolvedScene& resolved, const simulate::Link& radar, scene::Simulation& simulation) {
  if (resolved.scatterers.empty()) return;
  simulate::PulseGeometry geometry(resolved, radar);
  const radar::PulseRange pulses = radar.repetition.pulses_in(simulation.time_start_s, simulation.time_end_s);
  double nearest_m = HUGE_VAL;
  double farthest_m = 0.0;
  for (const std::int64_t pulse : {pulses.first, pulses.last}) {
    geometry.set_pulse(pulse);
    for (std::size_t i = 0; i < resolved.scatterers.size(); ++i) {
      const double range_m = radar::range_of(geometry.view(i).delay_s, resolved.conventions.light_speed_mps);
      nearest_m = std::min(nearest_m, range_m);
      farthest_m = std::max(farthest_m, range_m);
    }
  }
  const double margin_m =
      2.0 * radar::range_of(radar.pulse.width_s, resolved.conventions.light_speed_mps);  // Two pulse lengths.
  const double step_m = std::pow(10.0, std::floor(std::log10(std::max(1.0, farthest_m - nearest_m + margin_m))) - 1.0);
  simulation.range_start_m = std::max(0.0, std::floor((nearest_m - margin_m) / step_m) * step_m);
  simulation.range_end_m = rounded_up(farthest_m + margin_m, step_m);
}

}  // namespace

scene::Simulation suitable_simulation(const scene::Scene& scene, std::size_t radar) {
  scene::Simulation simulation;
  simulation.file = free_file(scene);
  simulation.range_end_m = 10e3;
  simulation.sample_rate_hz = 100e6;
  if (radar >= scene.radars.size()) return simulation;
  simulation.radar = scene.radars[radar].name;
  if (!sound(scene)) return simulation;
  try {
    const simulate::ResolvedScene resolved = simulate::resolve(scene);
    const simulate::Link seen = simulate::resolve_radar(scene, resolved, radar);
    const simulate::RadarFigures figures =
        simulate::radar_figures(seen, scene.radars[radar].power_w, resolved.conventions);
    simulation.sample_rate_hz = core::tidy(oversampling * figures.bandwidth_hz);
    simulation.time_end_s = core::tidy((pulses_shown - 1.0) / figures.mean_prf_hz);
    suit_ranges(resolved, seen, simulation);
  } catch (const std::exception&) {
    // A scene that cannot be resolved keeps the values of the thesis.
  }
  return simulation;
}

}  // namespace sarsim::gui
