#pragma once

#include <string>

#include "core/text/facts.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::workflow {

/// What `focus` reports.
[[nodiscard]] core::Facts facts_of(const FocusReport& report);

/// What `measure` reports.
/// @param image  as it was named
[[nodiscard]] core::Facts facts_of(const std::string& image, const MeasureReport& report);

}  // namespace sarsim::workflow
