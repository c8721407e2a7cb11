#include "cli/command/doppler_report.hpp"

#include <cmath>
#include <ostream>
#include <ranges>

#include <fmt/format.h>

#include "cli/shell/report.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/search/detection_table.hpp"

namespace sarsim::cli {

namespace {

std::string decibel_text(double ratio) {
  return std::isfinite(ratio) && ratio > 0.0 ? fmt::format("{:.1f} dB", core::power_db(ratio)) : std::string("-");
}

std::string finding_text(const workflow::TargetFinding& finding, bool doppler) {
  const workflow::TargetVisibility& sight = finding.sight;
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
    text += fmt::format(", best Pd {:.3g}; found in {}, expected in {}", *finding.probability,
                        counted(finding.found, "interval"), finding.expected);
  else
    text += fmt::format("; found in {}", counted(finding.found, "interval"));
  if (!finding.best) return text + "\n";
  const workflow::SearchDetection& best = *finding.best;
  text += fmt::format("\n  strongest detection: azimuth {:.2f} deg, range error {:+.2f} m",
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

}  // namespace

std::string text_of_pulses(const workflow::PulseReport& report, const std::string& image) {
  std::string text =
      fmt::format("{}: {} of {}, {}{}\n", report.files.front().string(), counted(report.intervals, "interval"),
                  counted(report.options.pulses, "pulse"), image, core::duration_text(report.seconds));
  if (report.options.detect)
    text += fmt::format("{}: {}; expected false alarms: {:.3g}\n", report.table.string(),
                        counted(report.detections, "detection"), report.expected_false_alarms);
  return text + findings_text(report.findings, report.doppler());
}

}  // namespace sarsim::cli
