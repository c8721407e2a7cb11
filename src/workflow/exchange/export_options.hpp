#pragma once

#include "workflow/exchange/export.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// The options that files of the standards CPHD and CRSD alone have.
[[nodiscard]] OptionTable<ExportRequest> exchange_option_table();

/// Those and what else such a file takes: --out, --anchor, --force.
[[nodiscard]] OptionTable<ExportRequest> export_option_table();

/// The request that the words stand for. Throws core::InvalidRequest with what is wrong with them, and where --out does
/// not name a file of one of the standards.
/// @param input  the echoes
[[nodiscard]] ExportRequest export_request(const RecordingArguments& input, const GivenWords& given);

}  // namespace sarsim::workflow
