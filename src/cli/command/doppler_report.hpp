#pragma once

#include <string>

#include "workflow/search/pulse_report.hpp"

namespace sarsim::cli {

/// What `doppler` and `search` found alike: a summary with a line or two for each of the first targets.
/// @param image  what the command says about its image, in the summary
[[nodiscard]] std::string text_of_pulses(const workflow::PulseReport& report, const std::string& image);

}  // namespace sarsim::cli
