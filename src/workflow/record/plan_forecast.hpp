#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "scene/model/scene.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/row_trial.hpp"

namespace sarsim::workflow {

/// Which script is planned, and by whom its recordings would be made.
struct PlanForecastRequest {
  std::string script;
  SceneOverrides overrides;
  unsigned threads = 0;  ///< Of each worker; 0: one per core.
};

/// What a recording takes: sizes from its plan, times from a trial of some of its rows.
struct RecordingForecast {
  std::size_t number = 0;  ///< Of its simulation in the script, from 1.
  scene::Simulation simulation;
  std::string engine;
  std::size_t rows = 0;
  std::size_t columns = 0;
  double echoes = 0.0;
  double bytes = 0.0;  ///< Of the file.
  double memory_bytes = 0.0;
  double fixed_s = 0.0;  ///< Before the first row; every worker does it.
  bool twice = false;    ///< The LSB is not known and the file holds counts.
  Trial trial;

  [[nodiscard]] double samples() const { return static_cast<double>(rows) * static_cast<double>(columns); }
  /// Seconds that so many workers take, at least 1. The slowest of them has the rows that do not divide.
  [[nodiscard]] double seconds(unsigned workers) const;
};

/// What all recordings of a script take, made one after the other.
struct PlanForecast {
  std::vector<RecordingForecast> recordings;
  unsigned threads = 1;    ///< Of each worker.
  double reading_s = 0.0;  ///< For reading and checking the script.

  /// Of all recordings.
  [[nodiscard]] double samples() const;
  /// Of all files.
  [[nodiscard]] double bytes() const;
  /// Of one worker: the largest recording's.
  [[nodiscard]] double memory_bytes() const;
  /// Reading included.
  [[nodiscard]] double seconds(unsigned workers) const;
  /// How much faster so many workers are than one.
  [[nodiscard]] double times_as_fast(unsigned workers) const;
};

/// Reads a script and tries rows of each of its recordings, for about a second in all.
/// @param observer  hears warnings about the script
/// @throws core::InvalidRequest where the script cannot be simulated, core::Interrupted when stopped
[[nodiscard]] PlanForecast forecast_recordings(const PlanForecastRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
