#pragma once

#include <filesystem>

#include "core/report/problem.hpp"
#include "core/task/observer.hpp"
#include "workflow/sweep/sweep_plan.hpp"
#include "workflow/sweep/sweep_request.hpp"

namespace sarsim::workflow {

/// What a sweep came to.
struct SweepReport {
  SweepPlan plan;               ///< With its rows completed.
  core::Problems failures;      ///< One for each product that could not be made.
  std::filesystem::path table;  ///< The table as CSV; beside it stands the same with the ending .json.
  double seconds = 0.0;

  /// "done" or "failed", as the tables say.
  [[nodiscard]] const char* status() const { return failures.empty() ? "done" : "failed"; }
};

/// Makes what is open in a plan of the same request, and the tables. The folder holds a journal as well: what stopped
/// can be resumed. What cannot be computed is a row's `failure`; failures of the disk are exceptions, and a requested
/// stop throws Interrupted.
/// @throws core::InvalidRequest where an output stands in the way; core::RetryableError where another process makes a
/// variation
///         of these. Nothing is begun then.
[[nodiscard]] SweepReport run_sweep(const SweepRequest& request, SweepPlan plan, const core::Observer& observer);

/// Plans and runs a sweep: one recording or table for each product of each variation, and a table of all of them. The
/// files do not depend on the number of threads and jobs.
/// @throws core::InvalidRequest for everything that is wrong with the request or with a variation
[[nodiscard]] SweepReport sweep(const SweepRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
