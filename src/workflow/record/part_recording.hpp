#pragma once

#include <filesystem>

#include "core/task/observer.hpp"
#include "raster/parts/part_run.hpp"
#include "simulate/plan/plan.hpp"
#include "workflow/record/part_choice.hpp"
#include "workflow/record/record_report.hpp"
#include "workflow/record/team.hpp"

namespace sarsim::workflow {

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
  const core::Observer& observer;
  const RecordEvents& events;
  unsigned threads = 1;
  Team* team = nullptr;  ///< Others who make it together with this process; none: nobody.
};

/// Makes a share of a recording in the folder OUTPUT.parts, and completes the recording where it was the last.
///
/// Interrupted, or stopped by a failure, it keeps what is done; core::DeferredSignal then tells where.
/// @throws core::InvalidRequest where what is there already does not fit
[[nodiscard]] PartReport make_part(const PartJob& job, const PartWorkshop& workshop);

}  // namespace sarsim::workflow
