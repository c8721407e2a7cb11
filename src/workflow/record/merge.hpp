#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/task/observer.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::workflow {

/// Which parts become one file, and how.
struct MergeRequest {
  std::vector<std::string> folders;  ///< With the parts of one recording (NAME.parts); at least one.
  std::filesystem::path output;      ///< File to make; empty: NAME beside the first folder.
  unsigned threads = 0;              ///< 0: one per core.
  bool force = false;                ///< Replace the output where it exists.
  bool remove = false;               ///< Remove the parts once they are joined.
};

/// What a merge came to.
struct MergeReport {
  RecordingReport recording;
  /// The output was complete and its parts were gone: a merge before this one has done it. Then `recording` has no more
  /// than the name of the file.
  bool done_before = false;
};

/// Joins the parts of one recording, which may come from several folders, to its file: the bytes of a single run.
/// @throws core::InvalidRequest where parts are missing, do not belong together, or are still being made
/// @throws core::Interrupted when stopped; nothing is left behind
[[nodiscard]] MergeReport merge(const MergeRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
