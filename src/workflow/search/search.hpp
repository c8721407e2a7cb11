#pragma once

#include <cstddef>
#include <optional>

#include "core/task/observer.hpp"
#include "signal/search/ppi.hpp"
#include "workflow/search/pulse_report.hpp"
#include "workflow/search/pulse_request.hpp"
#include "workflow/search/search_picture.hpp"

namespace sarsim::workflow {

/// What is asked of `search`. Without `image`, only the height of `picture` may be given: it places detections, too.
struct SearchRequest : PulseRequest {
  PictureArguments picture{};
};

/// The picture that was painted.
struct PictureReport {
  signal::PpiGrid grid;
  std::size_t scans = 0;  ///< Whole and begun turns that the antenna made.
};

/// What a search radar found.
struct SearchReport : PulseReport {
  std::optional<PictureReport> picture{};  ///< Nothing where none was asked for.
};

/// A plan position indicator of what the beam sees and the table of its detections
/// (docs/theory/search-and-doppler.md); an interval lasts while the beam turns by half its width where nothing else is
/// said. Throws core::InvalidRequest with what keeps it from being done, before anything is written; Interrupted;
/// failures of files as the sinks tell them.
[[nodiscard]] SearchReport search(const SearchRequest& request, const core::Observer& observer = {});

}  // namespace sarsim::workflow
