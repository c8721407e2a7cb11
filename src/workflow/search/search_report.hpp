#pragma once

#include <string>

#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::workflow {

/// What `doppler` reports, as a JSON object.
[[nodiscard]] std::string json_of(const DopplerReport& report);

/// What `search` reports, as a JSON object.
[[nodiscard]] std::string json_of(const SearchReport& report);

}  // namespace sarsim::workflow
