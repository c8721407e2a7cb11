#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/text/csv.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/report_parts.hpp"
#include "workflow/search/detection_table.hpp"
#include "workflow/search/doppler.hpp"
#include "workflow/search/search.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t max_detections = 10000;  // that are shown

std::string ratio_text(double ratio) { return ratio > 0.0 ? report::fixed(core::power_db(ratio), 1) : std::string(); }

void add_intervals(report::Facts& facts, const workflow::PulseReport& made) {
  const workflow::SearchOptions& options = made.options;
  facts.count("Simulation", made.simulation + 1);
  facts.count("Intervals", made.intervals);
  facts.count("Pulses per interval", options.pulses);
  facts.count("Interval step", options.step_pulses(), "pulses");
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
                             ? "ordered statistic of the reference cells (OS)"
                             : "mean of the reference cells (CA)");
  facts.word("Probability of false alarm", fmt::format("{:g}", cfar.false_alarm));
  facts.count("Reference cells", made.reference_cells);
  facts.word("Independent cells", report::six_digits(made.independent_cells));
  facts.count("Detections", made.detections);
  facts.word("Expected false alarms", fmt::format("{:.3g}", made.expected_false_alarms));
}

std::vector<std::string> finding_row(const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetVisibility& sight = finding.sight;
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
  if (doppler) columns.insert(columns.end(), {"Doppler (Hz)", "Aliased Doppler (Hz)"});
  columns.insert(columns.end(), {"Row", "Column", "SNR (dB)", "Detection probability", "Intervals expected",
                                 "Intervals found", "Strongest: range error (m)"});
  if (doppler) columns.insert(columns.end(), {"Strongest: Doppler (Hz)", "Strongest: speed (m/s)"});
  columns.emplace_back("Strongest: SNR (dB)");
  for (const workflow::TargetFinding& finding : made.findings) {
    table.rows.push_back(finding_row(finding, doppler));
    table.rows.back().resize(columns.size());
  }
  return table;
}

// A column of a table of detections.
struct DetectionColumn {
  std::string_view name;  // in the first line of the file
  std::string_view title;
  int decimals;  // below 0: four digits
};

constexpr std::array detection_columns{DetectionColumn{"interval", "Interval", 0},
                                       DetectionColumn{"time_s", "Time (s)", 4},
                                       DetectionColumn{"azimuth_deg", "Azimuth (deg)", 2},
                                       DetectionColumn{"range_m", "Range (m)", 2},
                                       DetectionColumn{"doppler_hz", "Doppler (Hz)", 1},
                                       DetectionColumn{"speed_mps", "Speed (m/s)", 3},
                                       DetectionColumn{"magnitude_v", "Magnitude (V)", -1},
                                       DetectionColumn{"snr_db", "SNR (dB)", 1},
                                       DetectionColumn{"threshold_v", "Threshold (V)", -1},
                                       DetectionColumn{"target", "Target", 0},
                                       DetectionColumn{"x_m", "X (m)", 1},
                                       DetectionColumn{"y_m", "Y (m)", 1}};

DetectionColumn detection_column(std::string_view name) {
  const auto* const known = std::ranges::find(detection_columns, name, &DetectionColumn::name);
  return known == detection_columns.end() ? DetectionColumn{name, name, -1} : *known;
}

std::string shown_cell(const std::string& cell, int decimals) {
  const auto value = core::parse_number(cell);
  if (!value) return cell;
  return decimals < 0 ? fmt::format("{:.3e}", *value) : report::fixed(*value, decimals);
}

// Of the file, which holds them all.
ReportTable detections_table(const workflow::PulseReport& made) {
  ReportTable table{made.detections > max_detections ? fmt::format("Detections (first {})", max_detections)
                                                     : std::string("Detections"),
                    {},
                    {}};
  std::ifstream file(made.table);
  std::string line;
  if (!std::getline(file, line)) return table;
  std::vector<int> decimals;
  for (const std::string& name : core::csv_cells(line)) {
    const DetectionColumn column = detection_column(name);
    table.columns.emplace_back(column.title);
    decimals.push_back(column.decimals);
  }
  while (table.rows.size() < max_detections && std::getline(file, line)) {
    std::vector<std::string>& row = table.rows.emplace_back(core::csv_cells(line));
    row.resize(table.columns.size());
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = shown_cell(row[c], decimals[c]);
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
