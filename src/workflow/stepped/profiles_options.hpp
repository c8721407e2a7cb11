#pragma once

#include <string>

#include "workflow/options/option_table.hpp"
#include "workflow/stepped/profiles.hpp"

namespace sarsim::workflow {

/// Every option of `profiles`.
[[nodiscard]] OptionTable<ProfilesRequest> profiles_option_table();

/// What an input and words for options ask for. Throws core::InvalidRequest for the first word that means nothing.
[[nodiscard]] ProfilesRequest profiles_request(const std::string& input, const GivenWords& given);

}  // namespace sarsim::workflow
