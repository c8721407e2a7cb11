#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "raster/format/sinks.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::workflow {

/// What a recording will take, known before its first pulse.
struct RecordingEstimate {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double bytes = 0.0;    ///< Of the file.
  double seconds = 0.0;  ///< On all cores; good to a factor of two.
  double memory_bytes = 0.0;
};

/// One recording of a scene, checked and planned: somebody may look at what it will take before it is made.
struct PreparedRecording {
  simulate::Plan plan;
  std::filesystem::path file;
  raster::SinkOptions options;
  std::string script;  ///< Text of the scene, for files that carry it.
  RecordingEstimate estimate;
  core::Problems problems;  ///< Warnings and notes about the scene and its echoes.
};

/// Checks, surveys and plans one recording of a scene, on all cores; what is wrong with other recordings does not
/// matter.
/// @param simulation  position in the scene's list
/// @param options     of the file; its format is that of the simulation
/// @param stop        null: cannot be stopped
/// @throws core::InvalidRequest with all errors of the scene; core::Interrupted
[[nodiscard]] PreparedRecording prepare_recording(const scene::Scene& scene, std::size_t simulation,
                                                  std::filesystem::path file, raster::SinkOptions options,
                                                  const core::StopFlag* stop = nullptr);

/// Makes it, on all cores. The file appears when it is complete; stopped or failed, nothing is left behind. The scene's
/// warnings are not in the report.
/// @throws core::InvalidRequest for echoes that cannot be computed, std::runtime_error for a disk without room
/// @throws core::Interrupted
[[nodiscard]] RecordingReport make_recording(const PreparedRecording& prepared, const core::Observer& observer);

}  // namespace sarsim::workflow
