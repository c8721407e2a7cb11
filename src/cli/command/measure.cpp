#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/measure_cuts.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "picture/figure/picture_file.hpp"
#include "workflow/focus/focus_report.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/focus/measure_options.hpp"

namespace sarsim::cli {

namespace {

struct MeasureArguments {
  std::string image;
  std::string cuts;
  workflow::MeasureRequest request;  ///< Without those two.
  bool dark = false;
  bool json = false;
  bool csv = false;
};

std::string figures_row(const std::optional<signal::ResponseFigures>& theory, const signal::ResponseFigures& found) {
  const auto against = [](double value, std::optional<double> reference, int digits) {
    return reference ? fmt::format("{:8.{}f} ({:.{}f})", value, digits, *reference, digits)
                     : fmt::format("{:8.{}f} (-)", value, digits);
  };
  const auto part = [&](auto member) { return theory ? std::optional((*theory).*member) : std::nullopt; };
  return fmt::format("{:>18}  {:>18}  {:>18}", against(found.width, part(&signal::ResponseFigures::width), 3),
                     against(found.pslr_db, part(&signal::ResponseFigures::pslr_db), 2),
                     against(found.islr_db, part(&signal::ResponseFigures::islr_db), 2));
}

// "SNR 31.2 dB, false-alarm probability 2.1e-09"
std::string noise_text(const workflow::MeasuredTarget& target) {
  if (!(target.noise_v > 0.0)) return "no noise";
  return fmt::format("SNR {:.1f} dB, false-alarm probability {:.2g}", target.snr_db(), target.false_alarm_probability);
}

// Why a target counts as missing: what is there and what would have to be.
std::string missing_text(const workflow::MeasuredTarget& target) {
  std::string text = fmt::format(": not found within {:.4g} m in azimuth and range", target.search_m);
  if (!(target.peak_v > 0.0)) return text + ": no peak there\n";
  text += fmt::format(": largest peak {:.4g} V, expected {:.4g} V; {}", target.peak_v, target.theory.amplitude,
                      noise_text(target));
  if (!(target.noise_v > 0.0)) return text + "\n";
  return text + fmt::format("; threshold {:.1f} dB, expected {:.1f} dB\n", core::power_db(target.threshold),
                            target.expected_snr_db());
}

std::string earth_text(const radar::Geodetic& place) {
  return fmt::format("{:.7f} deg, {:.7f} deg, {:.3f} m", core::deg_per_rad * place.latitude_rad,
                     core::deg_per_rad * place.longitude_rad, place.height_m);
}

// Three lines for a target: where it is and how strong, and its two cuts; on a ground grid over the Earth a fourth.
// Theory in parentheses.
std::string text_of(const workflow::MeasuredTarget& target, const workflow::MeasureReport& report) {
  const workflow::TargetTheory& theory = target.theory;
  if (target.state == workflow::TargetState::no_echoes)
    return fmt::format("target {:<4} no echoes\n", theory.target + 1);
  std::string text = fmt::format("target {:<4} azimuth {:.3f} m, range {:.3f} m", theory.target + 1,
                                 theory.place.azimuth_m, theory.place.range_m);
  if (target.outside) return text + (theory.unrecorded ? ": outside the recorded ranges\n" : ": outside the image\n");
  if (target.response() == nullptr) return text + missing_text(target);
  const signal::PointResponse& found = *target.response();
  text += fmt::format(
      ": {}; position error {:+.4f} m in azimuth, {:+.4f} m in range; amplitude {:.4g} V, {:+.2f} dB; phase {:.3f} "
      "rad, {:+.3f}; {}\n",
      workflow::to_string(target.state), found.place.azimuth_m - theory.place.azimuth_m,
      found.place.range_m - theory.place.range_m, found.amplitude, target.amplitude_error_db(), found.phase_rad,
      target.phase_error_rad(), noise_text(target));
  text += fmt::format("  {:<8}{}\n", "azimuth", figures_row(theory.azimuth, found.azimuth));
  text += fmt::format("  {:<8}{}\n", "range", figures_row(theory.range, found.range));
  const auto found_at = report.on_earth(found.place);
  const auto theory_at = report.on_earth(theory.place);
  if (found_at && theory_at)
    text += fmt::format("  {:<8}  {} ({})\n", "position", earth_text(*found_at), earth_text(*theory_at));
  return text;
}

// " (2 displaced, 1 weak)"
std::string other_states(const workflow::MeasureSummary& sum, std::size_t targets) {
  std::string text;
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", count, what);
  };
  add(sum.displaced, "displaced");
  add(sum.weak, "weak");
  add(sum.strong, "strong");
  add(targets - sum.expected - sum.outside, "without echoes");
  add(sum.outside, "outside the image");
  return text.empty() ? text : text + ")";
}

// One line for all of them.
std::string summary_text(const workflow::MeasureReport& report) {
  const workflow::MeasureSummary sum = workflow::summary_of(report);
  std::string text = fmt::format("{} of {} found", sum.found, counted(sum.expected, "target")) +
                     other_states(sum, report.targets.size());
  if (sum.found > 0)
    text += fmt::format(
        "; position errors up to {:.4f} m, amplitude errors {:+.2f} to {:+.2f} dB, phase errors {:+.3f} to {:+.3f} rad",
        sum.farthest_m, sum.lowest_amplitude_db, sum.highest_amplitude_db, sum.lowest_phase_rad, sum.highest_phase_rad);
  if (sum.found > 0 && std::isfinite(sum.highest_snr_db))
    text += fmt::format("; SNR {:.1f} to {:.1f} dB", sum.lowest_snr_db, sum.highest_snr_db);
  return text + fmt::format("; detection threshold set for a false-alarm probability of {:g}\n", report.false_alarm);
}

std::string text_of_measure(const std::string& image, const workflow::MeasureReport& report) {
  std::string text = fmt::format(
      "{}: {} by {}; expected values in parentheses; signed values are measured minus expected\n  {:<8}{:>18}  {:>18}  "
      "{:>18}\n",
      image, counted(report.targets.size(), "target"), report.origin.algorithm, "", "-3 dB width (m)", "PSLR (dB)",
      "ISLR (dB)");
  for (const workflow::MeasuredTarget& target : report.targets) text += text_of(target, report);
  return text + summary_text(report);
}

// One picture for each response.
void draw_cuts(const MeasureArguments& arguments, const workflow::MeasureReport& report, const core::StopFlag* stop) {
  if (arguments.cuts.empty()) return;
  std::filesystem::create_directories(arguments.cuts);
  for (const workflow::MeasuredTarget& target : report.targets) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    if (target.response() == nullptr) continue;
    picture::Figure figure =
        figure_of_cuts(target.cuts, *target.response(), target.theory.azimuth, target.theory.range);
    figure.title = fmt::format("Target {} of {}", target.theory.target + 1, arguments.image);
    picture::write_picture(figure, target.picture, {.width_px = 800, .height_px = 800, .dark = arguments.dark}, stop);
  }
}

ExitStatus run_measure(const MeasureArguments& arguments, Streams& streams) {
  workflow::MeasureRequest request = arguments.request;
  request.image = arguments.image;
  request.pictures = arguments.cuts;
  Watch watch(streams, false);
  const workflow::MeasureReport report = workflow::measure(request, watch.observer());
  write_out(streams, arguments.json  ? core::json_of(workflow::facts_of(arguments.image, report))
                     : arguments.csv ? workflow::csv_of(report)
                                     : text_of_measure(arguments.image, report));
  flush_out(streams);
  draw_cuts(arguments, report, streams.stop);
  const workflow::MeasureSummary sum = workflow::summary_of(report);
  return sum.found + sum.displaced + sum.weak + sum.strong == 0 ? exit_failed : exit_done;
}

}  // namespace

Action add_measure(CLI::App& app) {
  auto arguments = std::make_shared<MeasureArguments>();
  add_text(app, "image", arguments->image, "IMAGE", "complex image that sarsim focus wrote as ENVI or NPY")->required();
  add_table_options(app, workflow::measure_option_table(), arguments->request);
  add_text(app, "--cuts", arguments->cuts, "DIR", "draw the cuts through each target: DIR/target-1.png and so on");
  app.add_flag("--dark", arguments->dark, "plots in dark colours");
  app.add_flag("--force", arguments->request.force, "replace existing plots");
  CLI::Option* const csv = app.add_flag("--csv", arguments->csv, "a CSV table, one line per target");
  app.add_flag("--json", arguments->json, "as JSON")->excludes(csv);
  add_examples(app, {{"sarsim measure sar_r.img", "the targets of the script that was focused"},
                     {"sarsim measure sar_r.npy --json", "for programs"},
                     {"sarsim measure sar_r.npy --csv", "for a table"},
                     {"sarsim measure sar_r.img --target 5 --cuts pictures", "with a picture of the response"}});
  return [arguments](Streams& streams) { return run_measure(*arguments, streams); };
}

}  // namespace sarsim::cli
