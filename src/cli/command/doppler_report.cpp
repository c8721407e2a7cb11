#include "cli/command/doppler_report.hpp"

#include <cmath>
#include <ranges>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

double degrees(double rad) { return rad * 180.0 / core::pi; }

// Azimuths as people say them, 0 to 360.
double bearing_deg(double azimuth_rad) {
  const double azimuth = degrees(azimuth_rad);
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

void add_field(std::string& line, std::optional<double> value) {
  line += ',';
  if (value && std::isfinite(*value)) core::append_number(line, *value);
}

void write_sight(core::JsonWriter& json, const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetSight& sight = finding.sight;
  json.begin_object().member("interval", sight.interval + 1).member("time_s", sight.time_s);
  json.member("azimuth_deg", bearing_deg(sight.azimuth_rad)).member("range_m", sight.range_m);
  if (doppler) json.member("doppler_hz", sight.doppler_hz).member("seen_doppler_hz", sight.seen_doppler_hz);
  json.member("row", sight.row).member("column", sight.column).member("amplitude_v", sight.amplitude_v);
  json.member("snr_db", core::power_db(sight.snr)).key("probability");
  finding.probability ? json.value(*finding.probability) : json.null();
  json.end_object();
}

void write_detection(core::JsonWriter& json, const workflow::SearchDetection& detection, bool doppler) {
  json.begin_object().member("interval", detection.interval + 1).member("time_s", detection.time_s);
  json.member("azimuth_deg", bearing_deg(detection.azimuth_rad)).member("range_m", detection.range_m);
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
  text += fmt::format(" azimuth {:.2f} deg, range {:.1f} m", bearing_deg(sight.azimuth_rad), sight.range_m);
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
  text += fmt::format("\n  strongest   azimuth {:.2f} deg, range {:+.2f} m away", bearing_deg(best.azimuth_rad),
                      best.range_m - sight.range_m);
  if (doppler)
    text += fmt::format(", Doppler {} Hz ({} m/s)", decimals(best.doppler_hz, 1), decimals(best.speed_mps, 3));
  return text + fmt::format(", SNR {}\n", decibel_text(best.snr));
}

}  // namespace

DetectionTable::DetectionTable(const std::filesystem::path& path, bool replace, bool doppler, bool places)
    : file_(path, replace), doppler_(doppler), places_(places) {
  pending_ = "interval,time_s,azimuth_deg,range_m,doppler_hz,speed_mps,magnitude_v,snr_db,threshold_v,target";
  if (places_) pending_ += ",x_m,y_m";
  pending_ += '\n';
}

void DetectionTable::append(const workflow::SearchDetection& d, std::optional<std::size_t> target,
                            const GroundPlace& place) {
  std::string line = std::to_string(d.interval + 1);
  add_field(line, d.time_s);
  add_field(line, bearing_deg(d.azimuth_rad));
  add_field(line, d.range_m);
  add_field(line, doppler_ ? std::optional(d.doppler_hz) : std::nullopt);
  add_field(line, doppler_ ? std::optional(d.speed_mps) : std::nullopt);
  add_field(line, d.magnitude_v);
  add_field(line, core::power_db(d.snr));
  add_field(line, d.threshold_v);
  line += ',';
  if (target) line += std::to_string(*target + 1);
  if (places_) {
    add_field(line, place.x_m);
    add_field(line, place.y_m);
  }
  pending_ += line + '\n';
  constexpr std::size_t enough = std::size_t{1} << 16;
  if (pending_.size() >= enough) write_pending();
  ++count_;
}

void DetectionTable::write_pending() {
  file_.write(std::as_bytes(std::span(pending_)));
  pending_.clear();
}

void DetectionTable::finish() {
  write_pending();
  file_.commit();
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

void write_json(core::JsonWriter& json, const std::vector<workflow::TargetFinding>& findings, bool doppler) {
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

void write_json(core::JsonWriter& json, const workflow::SearchOptions& options) {
  json.begin_object().member("pulses", options.pulses).member("step", options.step_pulses());
  json.member("frequencies", options.rows()).member("canceller_pulses", options.canceller + 1);
  json.member("window", signal::to_string(options.window)).end_object();
}

}  // namespace sarsim::cli
