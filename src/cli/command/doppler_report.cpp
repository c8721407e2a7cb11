#include "cli/command/doppler_report.hpp"

#include <cmath>
#include <ostream>
#include <ranges>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/search/detection_table.hpp"

namespace sarsim::cli {

namespace {

void write_sight(core::JsonWriter& json, const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetSight& sight = finding.sight;
  json.begin_object().member("interval", sight.interval + 1).member("time_s", sight.time_s);
  json.member("azimuth_deg", workflow::bearing_deg(sight.azimuth_rad)).member("range_m", sight.range_m);
  if (doppler) json.member("doppler_hz", sight.doppler_hz).member("seen_doppler_hz", sight.seen_doppler_hz);
  json.member("row", sight.row).member("column", sight.column).member("amplitude_v", sight.amplitude_v);
  json.member("snr_db", core::power_db(sight.snr)).key("probability");
  finding.probability ? json.value(*finding.probability) : json.null();
  json.end_object();
}

void write_detection(core::JsonWriter& json, const workflow::SearchDetection& detection, bool doppler) {
  json.begin_object().member("interval", detection.interval + 1).member("time_s", detection.time_s);
  json.member("azimuth_deg", workflow::bearing_deg(detection.azimuth_rad)).member("range_m", detection.range_m);
  if (doppler) json.member("doppler_hz", detection.doppler_hz).member("speed_mps", detection.speed_mps);
  json.member("row", detection.row).member("column", detection.column);
  json.member("magnitude_v", detection.magnitude_v).member("snr_db", core::power_db(detection.snr));
  json.member("threshold_v", detection.threshold_v).end_object();
}

std::string decibel_text(double ratio) {
  return std::isfinite(ratio) && ratio > 0.0 ? fmt::format("{:.1f} dB", core::power_db(ratio)) : std::string("-");
}

std::string finding_text(const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetSight& sight = finding.sight;
  std::string text = fmt::format("target {:<4}", finding.target + 1);
  if (!sight.in_window) return text + " is never within the recorded ranges\n";
  text += fmt::format(" azimuth {:.2f} deg, range {:.1f} m", workflow::bearing_deg(sight.azimuth_rad), sight.range_m);
  if (doppler) {
    text += fmt::format(", Doppler {} Hz", decimals(sight.doppler_hz, 1));
    if (std::abs(sight.seen_doppler_hz - sight.doppler_hz) > 1e-6 * (1.0 + std::abs(sight.doppler_hz)))
      text += fmt::format(" (seen {})", decimals(sight.seen_doppler_hz, 1));
  }
  text += fmt::format(", cell {} x {}, SNR {}", sight.row, sight.column, decibel_text(sight.snr));
  if (finding.probability)
    text += fmt::format(", Pd at best {:.3g}; found in {}, expected in {}", *finding.probability,
                        counted(finding.found, "interval"), finding.expected);
  else
    text += fmt::format("; found in {}", counted(finding.found, "interval"));
  if (!finding.best) return text + "\n";
  const workflow::SearchDetection& best = *finding.best;
  text += fmt::format("\n  strongest   azimuth {:.2f} deg, range {:+.2f} m away",
                      workflow::bearing_deg(best.azimuth_rad), finding.best_range_error_m);
  if (doppler)
    text += fmt::format(", Doppler {} Hz ({} m/s)", decimals(best.doppler_hz, 1), decimals(best.speed_mps, 3));
  return text + fmt::format(", SNR {}\n", decibel_text(best.snr));
}

std::string findings_text(const std::vector<workflow::TargetFinding>& findings, bool doppler) {
  constexpr std::size_t most = 20;
  std::string text;
  for (const workflow::TargetFinding& finding : findings | std::views::take(most))
    text += finding_text(finding, doppler);
  if (findings.size() > most)
    text += fmt::format("and {}; --json lists them\n", counted(findings.size() - most, "more target"));
  return text;
}

void write_findings(core::JsonWriter& json, const std::vector<workflow::TargetFinding>& findings, bool doppler) {
  json.begin_array();
  for (const workflow::TargetFinding& finding : findings) {
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

void write_interval(core::JsonWriter& json, const workflow::SearchOptions& options) {
  json.begin_object().member("pulses", options.pulses).member("step", options.step_pulses());
  json.member("frequencies", options.rows()).member("canceller_pulses", options.canceller + 1);
  json.member("window", signal::to_string(options.window)).end_object();
}

const char* word_of(signal::CfarOptions::Kind kind) {
  return kind == signal::CfarOptions::Kind::ordered_statistic ? "os" : "ca";
}

void write_detector(core::JsonWriter& json, const workflow::PulseReport& report) {
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

std::string summary_text(const workflow::PulseReport& report, const std::string& image) {
  std::string text =
      fmt::format("{}: {} of {}, {}{}\n", report.files.front().string(), counted(report.intervals, "interval"),
                  counted(report.options.pulses, "pulse"), image, core::duration_text(report.seconds));
  if (report.options.detect)
    text += fmt::format("{}: {}; noise alone would put {:.3g} cells above their thresholds\n", report.table.string(),
                        counted(report.detections, "detection"), report.expected_false_alarms);
  return text + findings_text(report.findings, report.doppler());
}

std::string json_text(const workflow::PulseReport& report, const std::function<void(core::JsonWriter&)>& members) {
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
  cli::write_json(json, report.problems);
  json.end_object();
  return json.text();
}

}  // namespace

void print_report(Streams& streams, const RequestArguments& arguments, const workflow::PulseReport& report,
                  const std::string& image, const std::function<void(core::JsonWriter&)>& members) {
  if (!arguments.quiet) streams.err << summary_text(report, image);
  if (!arguments.json) return;
  write_out(streams, json_text(report, members));
  flush_out(streams);
}

}  // namespace sarsim::cli
