#pragma once

#include <string>

#include "workflow/options/option_table.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::workflow {

/// Every option of `doppler`.
[[nodiscard]] OptionTable<DopplerRequest> doppler_option_table();
/// Every option of `search`.
[[nodiscard]] OptionTable<SearchRequest> search_option_table();

/// What an input and words for options ask for. Throws core::InvalidRequest with everything that is wrong where one of
/// the words means nothing.
[[nodiscard]] DopplerRequest doppler_request(const std::string& input, const GivenWords& given);
/// The same for `search`.
[[nodiscard]] SearchRequest search_request(const std::string& input, const GivenWords& given);

}  // namespace sarsim::workflow
