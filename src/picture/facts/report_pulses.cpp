#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text/csv.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/report_parts.hpp"
#include "workflow/search/detection_table.hpp"
#include "workflow/search/search_report.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t max_detections = 10000;  // that are shown

// The first lines of a file, and the one of their names.
core::CsvTable first_lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text;
  std::string line;
  for (std::size_t lines = 0; lines <= max_detections && std::getline(file, line); ++lines) text += line + "\n";
  return core::read_csv(text);
}

// A column of a table of detections, whose numbers are to be filled in.
core::Fact column_called(const std::string& name) {
  core::Facts known = facts_of(workflow::SearchDetection{}, {}, true, workflow::GroundPlace{});
  const auto column = std::ranges::find(known, name, &core::Fact::key);
  return column == known.end() ? core::Fact{name, name, {}, "", core::scientific(3)} : std::move(*column);
}

// Of the file, which holds them all.
ReportTable detections_table(const workflow::PulseReport& made) {
  ReportTable table{made.detections > max_detections ? fmt::format("Detections (first {})", max_detections)
                                                     : std::string("Detections"),
                    {},
                    {}};
  const core::CsvTable file = first_lines_of(made.table);
  core::Facts row;
  for (const std::string& name : file.names) row.push_back(column_called(name));
  table.columns = core::headings(row);
  for (const std::vector<std::string>& cells : file.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto number = core::parse_number(cells[c]);
      row[c].value = number ? core::FactValue(*number) : core::FactValue(cells[c]);
    }
    table.rows.push_back(core::cells(row));
  }
  return table;
}

template <class Report>
ReportPages pages_with_detections(const Report& made) {
  ReportPages pages = report::pages_of(facts_of(made));
  if (made.options.detect && made.detections > 0) pages.tables.push_back(detections_table(made));
  return pages;
}

}  // namespace

ReportPages pages_of(const workflow::DopplerReport& made) { return pages_with_detections(made); }

ReportPages pages_of(const workflow::SearchReport& made) { return pages_with_detections(made); }

}  // namespace sarsim::picture
