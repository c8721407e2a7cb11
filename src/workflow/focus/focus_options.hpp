#pragma once

#include <string>

#include "workflow/focus/focus_request.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// Every option of `focus`.
[[nodiscard]] OptionTable<FocusRequest> focus_option_table();

/// What an input and words for options ask for; the image is named after the input where they do not name it. Throws
/// core::Refused for the first word that means nothing.
[[nodiscard]] FocusRequest focus_request(const std::string& input, const GivenWords& given);

}  // namespace sarsim::workflow
