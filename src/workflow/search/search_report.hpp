#pragma once

#include "core/text/facts.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::workflow {

/// What `doppler` reports.
[[nodiscard]] core::Facts facts_of(const DopplerReport& report);

/// What `search` reports.
[[nodiscard]] core::Facts facts_of(const SearchReport& report);

}  // namespace sarsim::workflow
