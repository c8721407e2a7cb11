#pragma once

#include <functional>
#include <string>

#include "cli/shell/context.hpp"
#include "cli/shell/request_options.hpp"
#include "core/text/json.hpp"
#include "workflow/search/pulse_report.hpp"

namespace sarsim::cli {

/// Prints what `doppler` and `search` found alike: a summary with a line or two for each of the first targets, unless
/// quiet, and JSON where asked for. Throws like `write_out`.
/// @param image    what the command says about its image, in the summary
/// @param members  the same as members of the open JSON object
void print_report(Streams& streams, const RequestArguments& arguments, const workflow::PulseReport& report,
                  const std::string& image, const std::function<void(core::JsonWriter&)>& members);

}  // namespace sarsim::cli
