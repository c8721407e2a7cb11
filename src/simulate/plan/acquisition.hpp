#pragma once

#include <cstddef>
#include <memory>

#include "core/task/stop.hpp"
#include "scene/model/recording.hpp"
#include "simulate/plan/reception.hpp"
#include "simulate/plan/timing.hpp"
#include "simulate/resolve/link.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::scene {
struct Scene;
}

namespace sarsim::simulate {

/// What a recording is: who sees what, when, and how it is received. How its echoes are computed is `Plan`'s.
struct Acquisition {
  std::shared_ptr<const ResolvedScene> scene;
  scene::Simulation simulation;  ///< As the scene asks for it.
  Link link;
  Timing timing;
  Reception reception;

  [[nodiscard]] double light_speed_mps() const { return scene->conventions.light_speed_mps; }
  /// Of the first pulse.
  [[nodiscard]] double carrier_hz() const { return link.carrier.carrier_hz(timing.pulses.first); }
};

/// What simulation number `index` of a scene records.
/// @param resolved  the scene resolved; without it, it is resolved here
/// @param stop      asked now and then; a requested stop throws Interrupted
/// @throws std::invalid_argument where the scene would not pass `check`.
[[nodiscard]] Acquisition acquisition_of(const scene::Scene& scene, std::size_t index,
                                         std::shared_ptr<const ResolvedScene> resolved = nullptr,
                                         const core::StopFlag* stop = nullptr);

}  // namespace sarsim::simulate
