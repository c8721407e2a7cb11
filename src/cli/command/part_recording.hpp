#pragma once

#include <filesystem>
#include <optional>

#include "cli/command/part_options.hpp"
#include "cli/shell/context.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/team.hpp"
#include "core/text/json.hpp"
#include "raster/parts/part_run.hpp"
#include "simulate/plan/plan.hpp"

namespace sarsim::cli {

/// A recording of which a share is made.
struct PartJob {
  const simulate::Plan& plan;
  std::filesystem::path output;
  raster::StoredProduct product;
  raster::Identity identity;
  const PartChoice& choice;
  bool force = false;
};

/// How it is made.
struct PartWorkshop {
  Streams& streams;
  ProgressDisplay::Style style = ProgressDisplay::Style::none;
  unsigned threads = 1;
  Team* team = nullptr;  ///< Others who make it together with this process; none: nobody.
};

/// What came of it.
struct PartResult {
  simulate::RowRange range;                  ///< The share.
  std::size_t made = 0;                      ///< Rows computed by this process.
  std::size_t rejected = 0;                  ///< Rows that were vouched for but damaged.
  std::size_t there = 0;                     ///< Rows of the recording that are vouched for now.
  bool finished_before = false;              ///< The recording is complete, and was when it began.
  bool elsewhere = false;                    ///< The recording is complete; another process has seen to it.
  std::optional<simulate::RunReport> whole;  ///< The recording is complete: its report.
  double seconds = 0.0;
  std::size_t journal_entries = 0;  ///< Written by this process.
  double journal_seconds = 0.0;     ///< Spent on bringing rows and journal to the disk.
};

/// Makes a share of a recording in the folder OUTPUT.parts, and completes the recording where it was the last.
///
/// Interrupted, or stopped by a failure, it keeps what is done; KeptInterruption then tells where.
/// @throws core::Refused where what is there already does not fit
[[nodiscard]] PartResult make_part(const PartJob& job, const PartWorkshop& workshop);

/// One or two lines on what came of it, for people. The report of a complete recording is not among them.
[[nodiscard]] std::string part_text(const PartJob& job, const PartResult& result);

/// The same as one JSON object.
void write_json(core::JsonWriter& json, const PartJob& job, const PartResult& result);

}  // namespace sarsim::cli
