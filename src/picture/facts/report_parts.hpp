#pragma once

#include <string>

#include "core/text/facts.hpp"
#include "picture/facts/report_pages.hpp"

/// Parts of the pages of reports. Internal to report_*.cpp.
namespace sarsim::picture::report {

/// The table "Result" of those with labels that are known, and a table of each list of rows that has some.
[[nodiscard]] ReportPages pages_of(const core::Facts& facts);

/// A table with the columns that the first row has.
/// @param rows  one at least
[[nodiscard]] ReportTable table_of(std::string title, const core::FactRows& rows);

}  // namespace sarsim::picture::report
