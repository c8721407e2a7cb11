#pragma once

#include <complex>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/task/progress.hpp"
#include "core/task/stop.hpp"
#include "radar/echo/reference_kernel.hpp"
#include "signal/compress/range_compression.hpp"
#include "signal/stepped/range_profile.hpp"
#include "simulate/plan/engine.hpp"
#include "simulate/plan/machine_speed.hpp"
#include "simulate/plan/other_pulses.hpp"
#include "simulate/plan/point_groups.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "simulate/plan/sink.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::simulate {

/// What comes of one `$SIMULATION`: everything decided before the first pulse. A value shared by all threads; made by
/// `make_plan` from a scene that has passed `check`.
struct Plan {
  std::shared_ptr<const ResolvedScene> scene;
  ResolvedRadar radar;
  scene::Simulation simulation;
  radar::EchoPulse pulse;
  EngineChoice engine;
  std::shared_ptr<const PointGroups> points;  ///< For the fast engines.
  OtherPulses other_pulses;                   ///< Whose echoes each row receives besides those of its own.

  radar::PulseRange pulses;         ///< All pulses of the window.
  std::int64_t first_burst = 0;     ///< Synthetic range profiles: bursts [first_burst, first_burst + rows).
  std::int64_t dropped_pulses = 0;  ///< Pulses of incomplete bursts at either end.

  radar::SampleGrid raw_grid;  ///< Times of the samples that are simulated.
  std::int64_t noise_first_sample = 0;
  double noise_stddev_v = 0.0;                                ///< In I and in Q.
  std::vector<double> stc_gain;                               ///< Per raw sample; empty: 1.
  std::shared_ptr<const signal::RangeCompressor> compressor;  ///< Processing::matched_filter.
  std::shared_ptr<const signal::RangeProfiler> profiler;      ///< Processing::srp.

  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> column_range_m;

  [[nodiscard]] std::int64_t burst_pulses() const {
    return std::int64_t{radar.carrier.steps()} * radar.carrier.pulses_per_step();
  }
  /// Whether the matched filter is one more factor of the spectral kernel's spectra. A gain over time (STC) comes
  /// between echoes and filter and keeps them apart; so do echoes of other pulses, each with its own phase, and
  /// samples without reception.
  [[nodiscard]] bool filters_spectra() const {
    return engine.engine == Engine::spectral && compressor && stc_gain.empty() && other_pulses.pulses.empty() &&
           scene->options.eclipsing == scene::Eclipsing::none;
  }
  /// First (or only) pulse of a product row.
  [[nodiscard]] std::int64_t first_pulse_of_row(std::size_t row) const;
};

/// Range samples of a window: floor(2 fs (end - start)/c + 1/2) (decision 2).
[[nodiscard]] double sample_count(const scene::Simulation& simulation, double light_speed_mps);

/// Decides everything about simulation number `index` of a scene.
/// @param engine  which kernel to use; automatic decides by cost
/// @param stop    asked now and then; a requested stop throws Interrupted
/// @throws std::invalid_argument where the scene would not pass `check`.
[[nodiscard]] Plan make_plan(const scene::Scene& scene, std::size_t index,
                             std::shared_ptr<const ResolvedScene> resolved = nullptr, Engine engine = Engine::reference,
                             const core::StopFlag* stop = nullptr);

/// The description of a plan's product that goes into its file.
/// @param script  text of the scene as understood
[[nodiscard]] Product product_of(const Plan& plan, std::string script);

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
