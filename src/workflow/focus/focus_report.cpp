#include "workflow/focus/focus_report.hpp"

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/json.hpp"
#include "core/text/problem_json.hpp"

namespace sarsim::workflow {

namespace {

void write_autofocus(core::JsonWriter& json, const std::optional<AutofocusFinding>& found) {
  json.key("autofocus");
  if (!found) {
    json.null();
    return;
  }
  json.begin_object().member("applied", found->applied).member("piece_m", found->piece_m);
  json.member("rms_rad", found->rms_rad);
  json.member("entropy_before", found->entropy_before).member("entropy_after", found->entropy_after);
  json.member("contrast_before", found->contrast_before).member("contrast_after", found->contrast_after);
  json.member("points", found->points).member("point_gain_db", found->point_gain_db);
  json.member("point_snr_before_db", found->point_snr_before_db);
  json.member("point_snr_after_db", found->point_snr_after_db);
  json.end_object();
}

void write_figures(core::JsonWriter& json, const char* name, const std::optional<signal::ResponseFigures>& figures) {
  json.key(name);
  if (!figures) {
    json.null();
    return;
  }
  json.begin_object().member("width_m", figures->width).member("null_m", figures->null);
  json.member("pslr_db", figures->pslr_db).member("islr_db", figures->islr_db).end_object();
}

// Members of the open object, on a ground grid over the Earth.
void write_place(core::JsonWriter& json, const MeasureReport& report, const signal::ImagePlace& place) {
  const auto at = report.on_earth(place);
  if (!at) return;
  json.member("latitude_deg", core::deg_per_rad * at->latitude_rad);
  json.member("longitude_deg", core::deg_per_rad * at->longitude_rad).member("height_m", at->height_m);
}

void write_target_json(core::JsonWriter& json, const MeasuredTarget& target, const MeasureReport& report) {
  const TargetTheory& theory = target.theory;
  json.begin_object().member("target", theory.target + 1).key("theory").begin_object();
  json.member("azimuth_m", theory.place.azimuth_m).member("range_m", theory.place.range_m);
  if (target.expected()) write_place(json, report, theory.place);
  json.member("amplitude_v", theory.amplitude).member("phase_rad", theory.phase_rad);
  write_figures(json, "azimuth", theory.azimuth);
  write_figures(json, "range", theory.range);
  json.end_object();
  json.member("outside_image", target.outside).member("state", to_string(target.state));
  if (target.expected() && !target.outside) {
    json.member("search_m", target.search_m).member("noise_v", target.noise_v);
    json.member("threshold_db", core::power_db(target.threshold)).key("snr_db");
    target.peak_v > 0.0 && target.noise_v > 0.0 ? json.value(target.snr_db()) : json.null();
    json.member("false_alarm_probability", target.false_alarm_probability);
  }
  json.key("found");
  if (!target.found) json.null();
  if (target.response() == nullptr) {
    json.end_object();
    return;
  }
  if (!target.found) json.key("peak");
  const signal::PointResponse& found = *target.response();
  json.begin_object().member("azimuth_m", found.place.azimuth_m).member("range_m", found.place.range_m);
  write_place(json, report, found.place);
  json.member("amplitude_v", found.amplitude).member("phase_rad", found.phase_rad);
  write_figures(json, "azimuth", found.azimuth);
  write_figures(json, "range", found.range);
  json.end_object();
  json.member("azimuth_error_m", found.place.azimuth_m - theory.place.azimuth_m);
  json.member("range_error_m", found.place.range_m - theory.place.range_m);
  json.member("amplitude_error_db", target.amplitude_error_db());
  json.member("phase_error_rad", target.phase_error_rad()).end_object();
}

}  // namespace

std::string json_of(const std::string& source, const FocusReport& report) {
  const signal::FocusedImage& image = report.image.image;
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", source);
  json.key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().member("algorithm", word_of(report.algorithm));
  json.member("rows", image.azimuth.count).member("columns", image.range.count);
  json.member("azimuth_first_m", image.azimuth.first_m).member("azimuth_step_m", image.azimuth.step_m);
  json.member("range_first_m", image.range.first_m).member("range_step_m", image.range.step_m);
  json.member("doppler_centroid_hz", report.options.doppler_centroid_hz);
  json.member("range_window", signal::to_string(report.options.range_window));
  json.member("azimuth_window", signal::to_string(report.options.azimuth_window));
  json.member("motion_compensation", to_string(report.motion));
  write_autofocus(json, report.autofocus);
  json.member("on_disk", report.image.on_disk).member("seconds", report.seconds).key("problems");
  core::write_json(json, report.problems);
  json.end_object();
  return json.text();
}

std::string json_of(const std::string& image, const MeasureReport& report) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("image", image);
  json.member("source", report.origin.source).member("algorithm", report.origin.algorithm);
  json.key("targets").begin_array();
  for (const MeasuredTarget& target : report.targets) write_target_json(json, target, report);
  const MeasureSummary sum = summary_of(report);
  json.end_array().member("false_alarm", report.false_alarm);
  json.member("expected_targets", sum.expected).member("found_targets", sum.found);
  json.member("displaced_targets", sum.displaced).member("weak_targets", sum.weak);
  json.member("strong_targets", sum.strong).member("truth", report.truth).end_object();
  return json.text();
}

}  // namespace sarsim::workflow
