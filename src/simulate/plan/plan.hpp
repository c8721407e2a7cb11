#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/task/stop.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/engine.hpp"
#include "simulate/plan/machine_speed.hpp"
#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/product.hpp"
#include "simulate/plan/range_ambiguities.hpp"

namespace sarsim::simulate {

/// Whose echoes are summed.
struct Sources {
  std::shared_ptr<const PointGroups> points;  ///< For the fast engines.
  RangeAmbiguities range_ambiguities;         ///< Whose echoes each row receives besides those of its own.
};

/// What comes of one `$SIMULATION`: everything decided before the first pulse. A value shared by all threads; made by
/// `make_plan` from a scene that has passed `check`. What needs a part of it includes and takes that part.
struct Plan {
  Acquisition acquisition;
  Sources sources;
  EngineChoice engine;

  /// Whether the matched filter is one more factor of what the kernel sums. A gain over time (STC) comes between echoes
  /// and filter and keeps them apart; so do echoes of other pulses, each with its own phase, and samples without
  /// reception.
  [[nodiscard]] bool filters_spectra() const;
};

/// Decides how an acquisition is computed.
/// @param engine  which kernel to use; automatic decides by cost
/// @param stop    asked now and then; a requested stop throws Interrupted
[[nodiscard]] Plan plan_of(Acquisition acquisition, Engine engine, const core::StopFlag* stop = nullptr);
/// The same of simulation number `index` of a scene (`acquisition_of`).
[[nodiscard]] Plan make_plan(const scene::Scene& scene, std::size_t index,
                             std::shared_ptr<const ResolvedScene> resolved = nullptr, Engine engine = Engine::reference,
                             const core::StopFlag* stop = nullptr);

/// The description of a plan's product that goes into its file.
/// @param script  text of the scene as understood
[[nodiscard]] raster::Product product_of(const Plan& plan, std::string script);

/// Rough cost of a plan, for people who want to know before it runs.
struct Cost {
  double echoes = 0.0;         ///< Targets times pulses.
  double echo_samples = 0.0;   ///< Times samples of a pulse.
  double samples = 0.0;        ///< Complex samples of the product.
  double start_seconds = 0.0;  ///< Before the first pulse; part of the other two.
  double seconds_one_thread = 0.0;
  double seconds = 0.0;       ///< On the given number of threads.
  double memory_bytes = 0.0;  ///< Resident, for the given number of threads.
};
/// @param threads  that compute, at least 1
/// @param machine  as measured; without it, that of the constants
[[nodiscard]] Cost estimated_cost(const Plan& plan, unsigned threads, const MachineSpeed& machine = {});

}  // namespace sarsim::simulate
