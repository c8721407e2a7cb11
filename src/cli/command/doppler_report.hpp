#pragma once

#include <string>

#include "cli/shell/context.hpp"
#include "cli/shell/request_options.hpp"
#include "workflow/search/pulse_report.hpp"

namespace sarsim::cli {

/// Prints what `doppler` and `search` found alike: a summary with a line or two for each of the first targets, unless
/// quiet, and JSON where asked for. Throws like `write_out`.
/// @param image  what the command says about its image, in the summary
/// @param json   the report as JSON
void print_report(Streams& streams, const RequestArguments& arguments, const workflow::PulseReport& report,
                  const std::string& image, const std::string& json);

}  // namespace sarsim::cli
