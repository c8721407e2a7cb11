#pragma once

#include <string>
#include <vector>

#include "workflow/verify/record.hpp"

namespace sarsim::workflow::verify {

/// What a page says of the machine and the program, line by line: "Processor", "...".
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A page of HTML that needs nothing else: the verdict, a table for each group and its charts.
[[nodiscard]] std::string page_of(const Record& record, const Facts& facts);

/// "2.1281680e-07 V", "-13.39 dB": enough digits to see a difference of the tolerance.
[[nodiscard]] std::string value_text(double value, const Finding& finding);
/// "+- 0.02", "at most", "at least".
[[nodiscard]] std::string bound_text(const Finding& finding);

/// How many findings hold.
[[nodiscard]] std::size_t holding(const Record& record);

}  // namespace sarsim::workflow::verify
