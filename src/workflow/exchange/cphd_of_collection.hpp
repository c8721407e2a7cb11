#pragma once

#include "raster/cphd/cphd_description.hpp"
#include "workflow/exchange/phase_history.hpp"

namespace sarsim::workflow {

/// What the XML of a CPHD file says of a collection; looks at no samples.
[[nodiscard]] raster::CphdDescription cphd_of(const Collection& collection, const CollectionExtent& extent,
                                              const HistoryShape& shape, raster::SignalEncoding encoding);

}  // namespace sarsim::workflow
