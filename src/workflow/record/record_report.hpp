#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/sink.hpp"
#include "scene/model/scene.hpp"
#include "simulate/run/run.hpp"

namespace sarsim::workflow {

/// What a finished recording turned out to be.
struct RecordingReport {
  std::string file;  ///< Empty where nothing was written.
  scene::Simulation simulation;
  scene::RunOptions options;
  std::string engine;
  std::string engine_reason;  ///< Why this engine.
  raster::RunReport run;
  std::optional<double> bytes;  ///< Of the file; none where nothing was written.
  double seconds = 0.0;         ///< With the estimate of the LSB.
  bool counts = false;          ///< The file holds counts of the converter, not volts.
  core::Problems warnings;
};

/// What a finished geometry table turned out to be.
struct TableReport {
  std::string file;
  std::string radar;
  double bytes = 0.0;
  double seconds = 0.0;
};

/// What came of a share of a recording.
struct PartReport {
  std::string file;                        ///< Of the whole recording.
  std::string part;                        ///< "3/8", "101:200".
  std::size_t rows = 0;                    ///< Of the whole recording.
  bool own_file = false;                   ///< The share is kept in a file of its own, to be merged.
  raster::RowRange range;                  ///< The share.
  std::size_t made = 0;                    ///< Rows computed by this process.
  std::size_t rejected = 0;                ///< Rows that were vouched for but damaged.
  std::size_t there = 0;                   ///< Rows of the recording that are vouched for now.
  bool finished_before = false;            ///< The recording is complete, and was when it began.
  bool elsewhere = false;                  ///< The recording is complete; another process has seen to it.
  std::optional<raster::RunReport> whole;  ///< The recording is complete: its report.
  double seconds = 0.0;
  std::size_t journal_entries = 0;  ///< Written by this process.
  double journal_seconds = 0.0;     ///< Spent on bringing rows and journal to the disk.
};

/// What came of one product of a scene.
struct ProductReport {
  std::filesystem::path path;                ///< Where it is, or would be if anything were written.
  std::optional<PartReport> part;            ///< Of a recording that is made in parts or with a journal.
  std::optional<RecordingReport> recording;  ///< Of a recording that is complete.
  std::optional<TableReport> table;          ///< Of a geometry table.
};

/// What a run of a scene came to.
struct RecordReport {
  std::vector<ProductReport> products;
  core::Problems problems;  ///< Everything that was found, ranked and with places.
};

/// What is told while products are made, beside what an observer sees. All functions may be empty; they are called like
/// the observer's.
struct RecordEvents {
  /// All problems known so far, ranked and with places; told whenever there are more.
  std::function<void(const core::Problems& problems)> found;
  /// A product is finished.
  std::function<void(const ProductReport& product)> made;
  /// Rows of the recording `file` that its journal vouches for are damaged; they are computed again.
  std::function<void(const std::filesystem::path& file, std::size_t rows)> rejected;
  /// A failure ends the work on the recording `file`; what is done is kept in `folder`, for a run that resumes.
  std::function<void(const std::filesystem::path& file, const std::filesystem::path& folder)> kept;
};

}  // namespace sarsim::workflow
