#pragma once

#include <string>

#include "core/report/problem.hpp"
#include "core/text/counted.hpp"
#include "core/text/json.hpp"
#include "core/text/problem_json.hpp"
#include "workflow/record/record_report.hpp"

namespace sarsim::cli {

/// The summary that the original program gave after a run: size, time, largest magnitude in mV and the share of the
/// converter's range that it used, best LSB in mV, shares of saturated and zero samples. Several lines.
[[nodiscard]] std::string report_text(const workflow::RecordingReport& report);

/// The same as one JSON object.
void write_json(core::JsonWriter& json, const workflow::RecordingReport& report);
void write_json(core::JsonWriter& json, const workflow::TableReport& report);

using core::counted;
using core::write_json;

/// A number with so many decimals, never "-0.0".
[[nodiscard]] std::string decimals(double value, int digits);

}  // namespace sarsim::cli
