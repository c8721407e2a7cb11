#include "picture/facts/report_parts.hpp"

#include <utility>
#include <variant>

namespace sarsim::picture::report {

ReportPages pages_of(const core::Facts& facts) {
  ReportPages pages;
  ReportTable result{"Result", {"Name", "Value", "Unit"}, {}, true};
  for (core::ShownFact& fact : core::shown(facts))
    if (!fact.value.empty())
      result.rows.push_back({std::move(fact.label), std::move(fact.value), std::move(fact.unit)});
  pages.tables.push_back(std::move(result));
  for (const core::Fact& fact : facts)
    if (const auto* const rows = std::get_if<core::FactRows>(&fact.value.held());
        rows != nullptr && !rows->empty() && !fact.label.empty())
      pages.tables.push_back(table_of(fact.label, *rows));
  return pages;
}

ReportTable table_of(std::string title, const core::FactRows& rows) {
  ReportTable table{std::move(title), core::headings(rows.front()), {}};
  for (const core::Facts& row : rows) table.rows.push_back(core::cells(row));
  return table;
}

}  // namespace sarsim::picture::report
