#include <cmath>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/report_parts.hpp"
#include "workflow/search/detection_table.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t most_detections = 10000;  // that are shown

std::string ratio_text(double ratio) { return ratio > 0.0 ? report::fixed(core::power_db(ratio), 1) : std::string(); }

void add_intervals(report::Facts& facts, const workflow::PulseReport& made) {
  const workflow::SearchOptions& options = made.options;
  facts.count("Simulation", made.simulation + 1);
  facts.count("Intervals", made.intervals);
  facts.count("Pulses of an interval", options.pulses);
  facts.count("From one to the next", options.step_pulses(), "pulses");
  if (made.doppler()) facts.count("Doppler frequencies", options.rows());
  facts.word("Canceller", options.canceller == 0 ? "none" : fmt::format("{} pulses", options.canceller + 1));
  facts.word("Window over the pulses", signal::to_string(options.window));
}

void add_detector(report::Facts& facts, const workflow::PulseReport& made) {
  if (!made.options.detect) {
    facts.word("Detector", "none");
    return;
  }
  const signal::CfarOptions& cfar = made.options.cfar;
  facts.word("Detector", cfar.kind == signal::CfarOptions::Kind::ordered_statistic
                             ? "ordered statistic of the cells around"
                             : "mean of the cells around");
  facts.word("Probability of false alarm", fmt::format("{:g}", cfar.false_alarm));
  facts.count("Reference cells", made.reference_cells);
  facts.word("Worth independent cells", report::six_digits(made.independent_cells));
  facts.count("Detections", made.detections);
  facts.word("Expected of noise alone", fmt::format("{:.3g}", made.expected_false_alarms));
}

std::vector<std::string> finding_row(const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetSight& sight = finding.sight;
  std::vector<std::string> row{fmt::format("{}", finding.target + 1)};
  if (!sight.in_window) {
    row.emplace_back("not in the window");
    return row;
  }
  row.insert(row.end(), {report::fixed(workflow::bearing_deg(sight.azimuth_rad), 2), report::fixed(sight.range_m, 1)});
  if (doppler) row.insert(row.end(), {report::fixed(sight.doppler_hz, 1), report::fixed(sight.seen_doppler_hz, 1)});
  row.insert(row.end(), {fmt::format("{}", sight.row), fmt::format("{}", sight.column), ratio_text(sight.snr),
                         finding.probability ? fmt::format("{:.3g}", *finding.probability) : std::string(),
                         finding.probability ? fmt::format("{}", finding.expected) : std::string(),
                         fmt::format("{}", finding.found)});
  if (!finding.best) return row;
  const workflow::SearchDetection& best = *finding.best;
  row.push_back(report::fixed(best.range_m - sight.range_m, 2));
  if (doppler) row.insert(row.end(), {report::fixed(best.doppler_hz, 1), report::fixed(best.speed_mps, 3)});
  row.push_back(ratio_text(best.snr));
  return row;
}

ReportTable findings_table(const workflow::PulseReport& made) {
  const bool doppler = made.doppler();
  ReportTable table{"Targets", {"Target", "Azimuth (deg)", "Range (m)"}, {}};
  std::vector<std::string>& columns = table.columns;
  if (doppler) columns.insert(columns.end(), {"Doppler (Hz)", "Doppler as seen (Hz)"});
  columns.insert(columns.end(), {"Row", "Column", "SNR (dB)", "Detected with probability", "Intervals expected",
                                 "Intervals found", "Strongest: range error (m)"});
  if (doppler) columns.insert(columns.end(), {"Strongest: Doppler (Hz)", "Strongest: speed (m/s)"});
  columns.emplace_back("Strongest: SNR (dB)");
  for (const workflow::TargetFinding& finding : made.findings) {
    table.rows.push_back(finding_row(finding, doppler));
    table.rows.back().resize(columns.size());
  }
  return table;
}

// What the first line of a table of detections calls a column, for people.
std::string column_title(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> titles{{"interval", "Interval"},
                                                                       {"time_s", "Time (s)"},
                                                                       {"azimuth_deg", "Azimuth (deg)"},
                                                                       {"range_m", "Range (m)"},
                                                                       {"doppler_hz", "Doppler (Hz)"},
                                                                       {"speed_mps", "Speed (m/s)"},
                                                                       {"magnitude_v", "Magnitude (V)"},
                                                                       {"snr_db", "SNR (dB)"},
                                                                       {"threshold_v", "Threshold (V)"},
                                                                       {"target", "Target"},
                                                                       {"x_m", "X (m)"},
                                                                       {"y_m", "Y (m)"}};
  for (const auto& [column, title] : titles)
    if (column == name) return title;
  return name;
}

std::vector<std::string> cells_of_line(const std::string& line) {
  std::vector<std::string> cells{""};
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

// Seven digits of a number are enough to look at; counts stay as they are.
std::string shown_cell(const std::string& cell) {
  if (core::parse_integer(cell)) return cell;
  const auto value = core::parse_number(cell);
  return value ? fmt::format("{:.7g}", *value) : cell;
}

// Of the file, which holds them all.
ReportTable detections_table(const workflow::PulseReport& made) {
  ReportTable table{made.detections > most_detections ? fmt::format("Detections (first {})", most_detections)
                                                      : std::string("Detections"),
                    {},
                    {}};
  std::ifstream file(made.table);
  std::string line;
  if (!std::getline(file, line)) return table;
  for (const std::string& name : cells_of_line(line)) table.columns.push_back(column_title(name));
  while (table.rows.size() < most_detections && std::getline(file, line)) {
    table.rows.push_back(cells_of_line(line));
    for (std::string& cell : table.rows.back()) cell = shown_cell(cell);
    table.rows.back().resize(table.columns.size());
  }
  return table;
}

ReportPages pages_with(report::Facts facts, const workflow::PulseReport& made) {
  add_detector(facts, made);
  facts.time(made.seconds);
  ReportPages pages;
  pages.tables.push_back(facts.take());
  if (!made.findings.empty()) pages.tables.push_back(findings_table(made));
  if (made.options.detect && made.detections > 0) pages.tables.push_back(detections_table(made));
  return pages;
}

}  // namespace

ReportPages pages_of(const workflow::DopplerReport& made) {
  report::Facts facts;
  add_intervals(facts, made);
  if (made.doppler()) {
    facts.number("Doppler spacing", made.doppler_step_hz, "Hz");
    facts.number("Speed spacing", std::abs(made.speed_step_mps), "m/s");
  }
  facts.count("Ranges", made.columns);
  facts.number("Range from", made.range_first_m, "m");
  facts.number("Range to", made.range_last_m, "m");
  facts.number("Range spacing", made.range_step_m, "m");
  return pages_with(std::move(facts), made);
}

ReportPages pages_of(const workflow::SearchReport& made) {
  report::Facts facts;
  add_intervals(facts, made);
  if (made.picture) {
    const signal::PpiGrid& grid = made.picture->grid;
    facts.count("Turns of the antenna", made.picture->scans);
    facts.count("Rows of the picture", grid.rows, "pixels");
    facts.count("Columns of the picture", grid.columns, "pixels");
    facts.number("Side of a pixel", grid.pixel_m, "m");
    facts.number("X from", grid.first_x_m, "m");
    facts.number("Y from", grid.first_y_m, "m");
  }
  return pages_with(std::move(facts), made);
}

}  // namespace sarsim::picture
