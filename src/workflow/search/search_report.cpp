#include "workflow/search/search_report.hpp"

#include <functional>

#include "core/build/version.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/json.hpp"
#include "core/text/problem_json.hpp"
#include "workflow/search/detection_table.hpp"

namespace sarsim::workflow {

namespace {

void write_sight(core::JsonWriter& json, const TargetFinding& finding, bool doppler) {
  const TargetVisibility& sight = finding.sight;
  json.begin_object().member("interval", sight.interval + 1).member("time_s", sight.time_s);
  json.member("azimuth_deg", bearing_deg(sight.azimuth_rad)).member("range_m", sight.range_m);
  if (doppler) json.member("doppler_hz", sight.doppler_hz).member("seen_doppler_hz", sight.seen_doppler_hz);
  json.member("row", sight.row).member("column", sight.column).member("amplitude_v", sight.amplitude_v);
  json.member("snr_db", core::power_db(sight.snr)).key("probability");
  finding.probability ? json.value(*finding.probability) : json.null();
  json.end_object();
}

void write_detection(core::JsonWriter& json, const SearchDetection& detection, bool doppler) {
  json.begin_object().member("interval", detection.interval + 1).member("time_s", detection.time_s);
  json.member("azimuth_deg", bearing_deg(detection.azimuth_rad)).member("range_m", detection.range_m);
  if (doppler) json.member("doppler_hz", detection.doppler_hz).member("speed_mps", detection.speed_mps);
  json.member("row", detection.row).member("column", detection.column);
  json.member("magnitude_v", detection.magnitude_v).member("snr_db", core::power_db(detection.snr));
  json.member("threshold_v", detection.threshold_v).end_object();
}

void write_findings(core::JsonWriter& json, const std::vector<TargetFinding>& findings, bool doppler) {
  json.begin_array();
  for (const TargetFinding& finding : findings) {
    json.begin_object().member("target", finding.target + 1).key("expected");
    if (finding.sight.in_window)
      write_sight(json, finding, doppler);
    else
      json.null();
    json.key("intervals_expected");
    finding.probability ? json.value(finding.expected) : json.null();
    json.member("intervals_found", finding.found).key("strongest");
    if (finding.best)
      write_detection(json, *finding.best, doppler);
    else
      json.null();
    json.end_object();
  }
  json.end_array();
}

void write_interval(core::JsonWriter& json, const SearchOptions& options) {
  json.begin_object().member("pulses", options.pulses).member("step", options.step_pulses());
  json.member("frequencies", options.rows()).member("canceller_pulses", options.canceller + 1);
  json.member("window", signal::to_string(options.window)).end_object();
}

const char* word_of(signal::CfarOptions::Kind kind) {
  return kind == signal::CfarOptions::Kind::ordered_statistic ? "os" : "ca";
}

void write_detector(core::JsonWriter& json, const PulseReport& report) {
  if (!report.options.detect) {
    json.null();
    return;
  }
  const signal::CfarOptions& cfar = report.options.cfar;
  json.begin_object().member("cfar", word_of(cfar.kind));
  json.member("false_alarm", cfar.false_alarm).member("reference_cells", report.reference_cells);
  json.member("independent_cells", report.independent_cells);
  json.member("detections", report.detections).member("expected_false_alarms", report.expected_false_alarms);
  json.end_object();
}

// @param members  of the open object, about the image
std::string json_of_pulses(const PulseReport& report, const std::function<void(core::JsonWriter&)>& members) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", report.source);
  json.key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().member("intervals", report.intervals).key("interval");
  write_interval(json, report.options);
  members(json);
  json.key("detector");
  write_detector(json, report);
  json.key("targets");
  write_findings(json, report.findings, report.doppler());
  json.member("seconds", report.seconds).key("problems");
  core::write_json(json, report.problems);
  json.end_object();
  return json.text();
}

void write_maps(core::JsonWriter& json, const DopplerReport& report) {
  json.member("rows", report.rows).member("columns", report.columns);
  json.member("doppler_first_hz", report.doppler_first_hz).member("doppler_step_hz", report.doppler_step_hz);
  json.member("speed_first_mps", report.speed_first_mps).member("speed_step_mps", report.speed_step_mps);
  json.member("range_first_m", report.range_first_m).member("range_step_m", report.range_step_m);
}

void write_picture(core::JsonWriter& json, const SearchReport& report) {
  if (!report.picture) return;
  const signal::PpiGrid& grid = report.picture->grid;
  json.member("rows", grid.rows).member("columns", grid.columns).member("scans", report.picture->scans);
  json.member("x_first_m", grid.first_x_m).member("x_step_m", grid.pixel_m);
  json.member("y_first_m", grid.first_y_m).member("y_step_m", -grid.pixel_m);
}

}  // namespace

std::string json_of(const DopplerReport& report) {
  return json_of_pulses(report, [&report](core::JsonWriter& json) { write_maps(json, report); });
}

std::string json_of(const SearchReport& report) {
  return json_of_pulses(report, [&report](core::JsonWriter& json) { write_picture(json, report); });
}

}  // namespace sarsim::workflow
