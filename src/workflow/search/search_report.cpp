#include "workflow/search/search_report.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/search/detection_table.hpp"

namespace sarsim::workflow {

namespace {

using core::Facts;
using core::fixed;
using core::only;
using core::significant;

Facts facts_of_sight(const TargetFinding& finding, bool doppler) {
  const TargetVisibility& sight = finding.sight;
  const bool seen = sight.in_window;
  Facts facts{{"interval", "", only(seen, sight.interval + 1)},
              {"time_s", "", only(seen, sight.time_s)},
              {"azimuth_deg", "Azimuth", only(seen, bearing_deg(sight.azimuth_rad)), "deg", fixed(2),
               seen ? "" : "not in the window"},
              {"range_m", "Range", only(seen, sight.range_m), "m", fixed(1)}};
  if (doppler)
    append(facts, {{"doppler_hz", "Doppler", only(seen, sight.doppler_hz), "Hz", fixed(1)},
                   {"seen_doppler_hz", "Doppler as seen", only(seen, sight.seen_doppler_hz), "Hz", fixed(1)}});
  append(facts, {{"row", "Row", only(seen, sight.row)},
                 {"column", "Column", only(seen, sight.column)},
                 {"amplitude_v", "", only(seen, sight.amplitude_v)},
                 {"snr_db", "SNR", only(seen, core::power_db(sight.snr)), "dB", fixed(1)},
                 {"probability", "Detection probability", only(seen, finding.probability), "", significant(3)}});
  return facts;
}

Facts facts_of_strongest(const TargetFinding& finding, bool doppler) {
  const bool found = finding.best.has_value();
  const SearchDetection best = finding.best.value_or(SearchDetection{});
  Facts facts{{"interval", "", only(found, best.interval + 1)},
              {"time_s", "", only(found, best.time_s)},
              {"azimuth_deg", "", only(found, bearing_deg(best.azimuth_rad))},
              {"range_m", "", only(found, best.range_m)},
              {"", "Strongest: range error", only(found, best.range_m - finding.sight.range_m), "m", fixed(2)}};
  if (doppler)
    append(facts, {{"doppler_hz", "Strongest: Doppler", only(found, best.doppler_hz), "Hz", fixed(1)},
                   {"speed_mps", "Strongest: speed", only(found, best.speed_mps), "m/s", fixed(3)}});
  append(facts, {{"row", "", only(found, best.row)},
                 {"column", "", only(found, best.column)},
                 {"magnitude_v", "", only(found, best.magnitude_v)},
                 {"snr_db", "Strongest: SNR", only(found, core::power_db(best.snr)), "dB", fixed(1)},
                 {"threshold_v", "", only(found, best.threshold_v)}});
  return facts;
}

Facts facts_of_finding(const TargetFinding& finding, bool doppler) {
  const bool seen = finding.sight.in_window;
  const core::FactValue expected = only(finding.probability.has_value(), finding.expected);
  return {{"target", "Target", finding.target + 1},
          {"expected", "", facts_of_sight(finding, doppler)},
          {"intervals_expected", "", expected},
          {"", "Intervals expected", only(seen, expected)},
          {"intervals_found", "", finding.found},
          {"", "Intervals found", only(seen, finding.found)},
          {"strongest", "", facts_of_strongest(finding, doppler)}};
}

core::FactValue detector_of(const PulseReport& report) {
  if (!report.options.detect) return {};
  const signal::CfarOptions& cfar = report.options.cfar;
  const bool ordered = cfar.kind == signal::CfarOptions::Kind::ordered_statistic;
  return Facts{
      core::worded("cfar", "Detector", ordered ? "os" : "ca",
                   ordered ? "ordered statistic of the reference cells (OS)" : "mean of the reference cells (CA)"),
      {"false_alarm", "Probability of false alarm", cfar.false_alarm},
      {"reference_cells", "Reference cells", report.reference_cells},
      {"independent_cells", "Independent cells", report.independent_cells},
      {"detections", "Detections", report.detections},
      {"expected_false_alarms", "Expected false alarms", report.expected_false_alarms, "", significant(3)}};
}

// @param of_image  about the image
Facts facts_of_pulses(const PulseReport& report, Facts of_image) {
  const SearchOptions& options = report.options;
  core::FactRows targets;
  for (const TargetFinding& finding : report.findings) targets.push_back(facts_of_finding(finding, report.doppler()));
  Facts facts{{"sarsim", "", core::program_version},
              {"source", "", report.source},
              {"files", "", core::texts_of(report.files)},
              {"", "Simulation", report.simulation + 1},
              {"intervals", "Intervals", report.intervals},
              {"interval", "",
               Facts{{"pulses", "Pulses per interval", options.pulses},
                     {"step", "Interval step", options.step_pulses(), "pulses"},
                     {"frequencies", report.doppler() ? "Doppler frequencies" : "", options.rows()},
                     core::worded("canceller_pulses", "Canceller", options.canceller + 1,
                                  options.canceller == 0 ? "none" : fmt::format("{} pulses", options.canceller + 1)),
                     {"window", "Window over the pulses", signal::to_string(options.window)}}}};
  append(facts, std::move(of_image));
  append(facts, {core::worded("detector", report.options.detect ? "" : "Detector", detector_of(report), "none"),
                 {"targets", "Targets", std::move(targets)},
                 core::worded("seconds", "Time taken", report.seconds, core::duration_text(report.seconds)),
                 {"problems", "", report.problems}});
  return facts;
}

}  // namespace

Facts facts_of(const DopplerReport& report) {
  return facts_of_pulses(report,
                         {{"rows", "", report.rows},
                          {"columns", "", report.columns},
                          {"doppler_first_hz", "", report.doppler_first_hz},
                          {"doppler_step_hz", report.doppler() ? "Doppler spacing" : "", report.doppler_step_hz, "Hz"},
                          {"speed_first_mps", "", report.speed_first_mps},
                          {"speed_step_mps", "", report.speed_step_mps},
                          {"", report.doppler() ? "Speed spacing" : "", std::abs(report.speed_step_mps), "m/s"},
                          {"", "Ranges", report.columns},
                          {"range_first_m", "Range from", report.range_first_m, "m"},
                          {"", "Range to", report.range_last_m, "m"},
                          {"range_step_m", "Range spacing", report.range_step_m, "m"}});
}

Facts facts_of(const SearchReport& report) {
  if (!report.picture) return facts_of_pulses(report, {});
  const signal::PpiGrid& grid = report.picture->grid;
  return facts_of_pulses(report, {{"", "Turns of the antenna", report.picture->scans},
                                  {"rows", "Rows of the picture", grid.rows, "pixels"},
                                  {"columns", "Columns of the picture", grid.columns, "pixels"},
                                  {"scans", "", report.picture->scans},
                                  {"x_first_m", "", grid.first_x_m},
                                  {"x_step_m", "Side of a pixel", grid.pixel_m, "m"},
                                  {"", "X from", grid.first_x_m, "m"},
                                  {"y_first_m", "Y from", grid.first_y_m, "m"},
                                  {"y_step_m", "", -grid.pixel_m}});
}

}  // namespace sarsim::workflow
