#pragma once

#include <filesystem>
#include <string>

#include "core/task/observer.hpp"
#include "raster/format/sinks.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::workflow {

/// One recording on its way into one file.
struct RecordingJob {
  const simulate::Plan& plan;
  std::filesystem::path file;
  raster::SinkOptions options;
  std::string script;    ///< Text of the scene, for files that carry it (`raster::Format::carries_script`).
  bool discard = false;  ///< Everything is computed and encoded, nothing is written.
};

/// Finds the LSB where the file needs one that is not given, and makes the file in a folder that is there. The file
/// appears when it is complete; stopped or failed, nothing is left behind. Warnings of the scene are not in the report.
/// @param threads  0: one per core
[[nodiscard]] RecordingReport make_recording(const RecordingJob& job, unsigned threads, const core::Observer& observer);

/// What a report says before anything was computed: the simulation, with the name of its radar, and the engine.
[[nodiscard]] RecordingReport begun_report(const simulate::Plan& plan, const raster::Product& product);

/// Notes name and true size of a finished file.
void take_file(const std::filesystem::path& path, RecordingReport& report);

/// The progress of a stage, told at once that nothing is done yet.
[[nodiscard]] core::ProgressReport begun_stage(const core::Observer& observer, const std::string& name,
                                               const simulate::Plan& plan);

}  // namespace sarsim::workflow
