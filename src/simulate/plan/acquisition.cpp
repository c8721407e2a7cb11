#include "simulate/plan/acquisition.hpp"

#include <stdexcept>
#include <string>

#include "core/report/expect.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::simulate {

Acquisition acquisition_of(const scene::Scene& scene, std::size_t index, std::shared_ptr<const ResolvedScene> resolved,
                           const core::StopFlag* stop) {
  CORE_EXPECT(index < scene.simulations.size());
  Acquisition acquisition;
  const scene::Simulation& simulation = acquisition.simulation = scene.simulations[index];
  acquisition.scene = resolved ? std::move(resolved) : std::make_shared<const ResolvedScene>(resolve(scene, {1, stop}));
  const std::size_t radar = scene::find_radar(scene, simulation.radar);
  if (radar == scene::not_found) throw std::invalid_argument("radar '" + simulation.radar + "' is not defined");
  acquisition.link = resolve_radar(scene, *acquisition.scene, radar);
  acquisition.timing = timing_of(acquisition.link, simulation);
  if (acquisition.timing.pulses.count() < 1 || !(sample_count(simulation, acquisition.light_speed_mps()) >= 1.0))
    throw std::invalid_argument("the window of simulation " + std::to_string(index + 1) + " is empty");
  acquisition.reception = reception_of(acquisition.link, *acquisition.scene, simulation);
  return acquisition;
}

}  // namespace sarsim::simulate
