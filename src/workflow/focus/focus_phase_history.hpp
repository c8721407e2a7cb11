#pragma once

#include <string>

#include "core/task/observer.hpp"
#include "workflow/focus/focus_pipeline.hpp"

namespace sarsim::workflow {

/// Whether a file is a phase history (CPHD), by its ending or its first bytes.
[[nodiscard]] bool is_phase_history(const std::string& path);

/// Focuses a CPHD file by back projection onto the plane of its image area, in blocks of vectors: memory holds the
/// image and some 100 MB (docs/theory/back-projection.md). Rows run along the first axis of the area, columns along the
/// second; `azimuth_area` and `range_area` of the request are parts of them, `ground_m` a height above the plane.
/// Throws like `focus`; core::InvalidRequest also for options that mean nothing here.
[[nodiscard]] FocusReport focus_phase_history(const FocusRequest& request, const core::Observer& observer);

}  // namespace sarsim::workflow
