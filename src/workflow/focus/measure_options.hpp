#pragma once

#include <string>

#include "workflow/focus/measure.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// The options of `measure` but for those of its output.
[[nodiscard]] OptionTable<MeasureRequest> measure_option_table();

/// What an image and words for options ask for. Throws core::InvalidRequest for the first word that means nothing.
[[nodiscard]] MeasureRequest measure_request(const std::string& image, const GivenWords& given);

}  // namespace sarsim::workflow
