#pragma once

#include <string>

#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::workflow {

/// What `focus` reports, as a JSON object.
/// @param source  the input, as it was named
[[nodiscard]] std::string json_of(const std::string& source, const FocusReport& report);

/// What `measure` reports, as a JSON object.
/// @param image  as it was named
[[nodiscard]] std::string json_of(const std::string& image, const MeasureReport& report);

}  // namespace sarsim::workflow
