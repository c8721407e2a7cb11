#pragma once

#include <complex>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include "core/task/observer.hpp"
#include "raster/format/sinks.hpp"
#include "scene/model/scene.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/run/run.hpp"
#include "workflow/input/scene_input.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::workflow {

/// One recording of a scene that was read, planned as `record` plans it. Never changes; many threads may use it at
/// once.
struct ScenePlan {
  SceneInput input;  ///< The scene as it is recorded, with remarks that concern this recording.
  simulate::Plan plan;
};

/// Checks, surveys and plans one recording; what is wrong with others does not matter.
/// @param simulation  position in the scene's list
/// @throws core::InvalidRequest with all problems where it cannot be made, core::Interrupted
[[nodiscard]] ScenePlan plan_of_scene(const SceneInput& known, std::size_t simulation,
                                      const core::WorkControl& control);

/// Computes some rows into memory, in V, as files of volts hold them.
/// @param rows     within [0, plan.acquisition.timing.rows)
/// @param samples  rows.count times plan.acquisition.reception.columns
/// @param threads  0: one per core
/// @throws core::InvalidRequest for an echo that cannot be computed, core::Interrupted
void record_rows(const ScenePlan& planned, raster::RowRange rows, std::span<std::complex<float>> samples,
                 unsigned threads, const core::Observer& observer);
/// The same in double precision.
void record_rows(const ScenePlan& planned, raster::RowRange rows, std::span<std::complex<double>> samples,
                 unsigned threads, const core::Observer& observer);

/// Makes the file of a recording, as `record` does.
/// @param format   in place of the scene's
/// @param options  but for the format
/// @throws core::InvalidRequest for a name that is taken and an echo that cannot be computed, std::runtime_error for a
/// disk without room, core::Interrupted
[[nodiscard]] RecordingReport record_file(const ScenePlan& planned, const std::filesystem::path& file,
                                          std::optional<scene::FileFormat> format, raster::SinkOptions options,
                                          unsigned threads, const core::Observer& observer);

}  // namespace sarsim::workflow
