#pragma once

#include <string>

#include "core/text/json.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::cli {

/// One or two lines on what came of a share of a recording, for people. The report of a complete recording is not among
/// them.
[[nodiscard]] std::string part_text(const workflow::PartReport& report);

/// The same as one JSON object.
void write_json(core::JsonWriter& json, const workflow::PartReport& report);

}  // namespace sarsim::cli
