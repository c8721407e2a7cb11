#include "workflow/stepped/stepped_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/build/version.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"
#include "core/text/problem_json.hpp"

namespace sarsim::workflow {

namespace {

void write_image_member(core::JsonWriter& json, const WrittenIsarImage& written) {
  const IsarImage& made = written.image;
  json.begin_object().member("file", written.file.string());
  json.member("first_burst", written.first_burst + 1).member("last_burst", written.first_burst + written.bursts);
  json.member("from_s", made.from_s).member("to_s", made.to_s);
  json.member("rows", made.image.azimuth.count).member("columns", made.image.range.count);
  json.member("cross_range_first_m", made.image.azimuth.first_m);
  json.member("cross_range_step_m", made.image.azimuth.step_m);
  json.member("range_first_m", made.image.range.first_m).member("range_step_m", made.image.range.step_m);
  json.member("centre_range_m", made.range_m).member("speed_mps", made.speed_mps).member("turn_rad", made.turn_rad);
  json.member("range_resolution_m", made.range_resolution_m);
  json.member("cross_range_resolution_m", made.cross_range_resolution_m);
  json.member("unambiguous_cross_range_m", made.unambiguous_cross_range_m).key("targets").begin_array();
  for (const HeldPoint& point : made.points) {
    json.begin_object().member("target", point.target + 1);
    json.member("cross_range_m", point.expected.azimuth_m).member("range_m", point.expected.range_m);
    json.member("outside", point.outside).key("found");
    if (point.found) {
      json.begin_object();
      json.member("cross_range_error_m", point.found->place.azimuth_m - point.expected.azimuth_m);
      json.member("range_error_m", point.found->place.range_m - point.expected.range_m);
      json.member("cross_range_width_m", point.found->azimuth.width).member("range_width_m", point.found->range.width);
      json.member("amplitude_error_db", core::amplitude_db(point.found->amplitude / point.amplitude)).end_object();
    } else {
      json.null();
    }
    json.end_object();
  }
  json.end_array().end_object();
}

void write_scan(core::JsonWriter& json, const ScanRecord& scan) {
  json.begin_object().member("first_burst", scan.bursts.first + 1).member("last_burst", scan.bursts.last + 1);
  json.member("from_s", scan.from_s).member("to_s", scan.to_s).member("speed_mps", scan.speed_mps);
  if (scan.estimate)
    json.member("uncertainty_mps", scan.estimate->uncertainty_mps)
        .member("entropy", scan.estimate->entropy)
        .member("entropy_at_rest", scan.estimate->entropy_at_rest);
  json.end_object();
}

void write_held_target(core::JsonWriter& json, const HeldTarget& target) {
  json.begin_object().member("target", target.truth.target + 1).member("range_m", target.truth.range_m);
  json.member("speed_mps", target.truth.speed_mps).member("amplitude_v", target.truth.amplitude);
  json.member("expected_m", target.expected_m).member("expected_bin", target.expected_bin);
  json.member("outside", target.outside);
  json.member("smear_cells", target.smear_cells).key("nearest_target_m");
  std::isfinite(target.nearest_m) ? json.value(target.nearest_m) : json.null();
  json.key("found");
  if (target.found) {
    json.begin_object().member("range_m", target.found->range_m);
    json.member("range_error_m", target.found->range_m - target.expected_m);
    json.member("width_m", target.found->width_m).member("phase_rad", target.found->phase_rad);
    json.member("amplitude_error_db", core::amplitude_db(target.found->amplitude / target.truth.amplitude));
    json.end_object();
  } else {
    json.null();
  }
  json.end_object();
}

}  // namespace

std::string json_of(const IsarReport& report) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", report.source);
  json.member("algorithm", report.algorithm).key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().key("images").begin_array();
  for (const WrittenIsarImage& image : report.images) write_image_member(json, image);
  json.end_array().member("seconds", report.seconds).key("problems");
  core::write_json(json, report.problems);
  return json.end_object().text();
}

std::string json_of(const ProfilesReport& report) {
  const ProfileSeries& series = report.series;
  const ProfileRow& row = series.rows[report.held_row];
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", report.source);
  json.key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().member("set", word_of(report.set));
  const signal::SteppedLimits& limits = series.limits;
  json.member("bursts", series.rows.size()).member("columns", series.axis.count);
  json.member("range_first_m", series.axis.first_m).member("range_step_m", series.axis.step_m);
  json.member("carrier_hz", series.centre_hz).member("bandwidth_hz", series.band_hz);
  json.member("resolution_m", limits.resolution_m).member("unambiguous_range_m", limits.unambiguous_range_m);
  json.member("shift_m_per_mps", limits.shift_m_per_mps).member("smear_m_per_mps", limits.smear_m_per_mps);
  json.member("tolerable_speed_mps", limits.tolerable_mps).member("ambiguous_speed_mps", limits.ambiguous_mps);
  json.key("scans").begin_array();
  for (const ScanRecord& scan : series.scans) write_scan(json, scan);
  json.end_array().member("burst", row.burst + 1).member("time_s", row.time_s);
  json.key("targets").begin_array();
  for (const HeldTarget& target : report.targets) write_held_target(json, target);
  json.end_array().key("peaks").begin_array();
  for (const signal::ProfilePeak& peak : report.peaks) {
    json.begin_object().member("range_m", peak.range_m).member("amplitude_v", peak.amplitude);
    json.member("phase_rad", peak.phase_rad).member("width_m", peak.width_m).end_object();
  }
  json.end_array().member("seconds", report.seconds).key("problems");
  core::write_json(json, report.problems);
  return json.end_object().text();
}

std::string csv_of(const std::vector<HeldTarget>& targets) {
  std::string text =
      "target,range_m,speed_mps,amplitude_v,expected_m,expected_bin,smear_cells,nearest_target_m,found_m,found_width_m,"
      "found_phase_rad,found_amplitude_v\n";
  for (const HeldTarget& target : targets) {
    std::vector<std::optional<double>> values{target.truth.range_m, target.truth.speed_mps, target.truth.amplitude,
                                              target.expected_m,    target.expected_bin,    target.smear_cells,
                                              target.nearest_m};
    values.resize(values.size() + 4);
    if (target.found)
      std::ranges::copy(
          std::array{target.found->range_m, target.found->width_m, target.found->phase_rad, target.found->amplitude},
          values.end() - 4);
    text += std::to_string(target.truth.target + 1);
    for (const std::optional<double>& value : values) {
      text += ',';
      if (value && std::isfinite(*value)) core::append_number(text, *value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace sarsim::workflow
