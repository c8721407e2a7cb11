#pragma once

#include <string>

#include "workflow/options/option_table.hpp"
#include "workflow/stepped/isar.hpp"

namespace sarsim::workflow {

/// Every option of `isar`.
[[nodiscard]] OptionTable<IsarRequest> isar_option_table();

/// What an input and words for options ask for. Throws core::InvalidRequest for the first word that means nothing.
[[nodiscard]] IsarRequest isar_request(const std::string& input, const GivenWords& given);

}  // namespace sarsim::workflow
