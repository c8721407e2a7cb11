#include <filesystem>
#include <limits>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/measure_cuts.hpp"
#include "cli/command/picture_program.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/recording_options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::cli {

namespace {

struct MeasureArguments {
  std::string image;
  workflow::RecordingArguments input;
  std::optional<double> search_m;
  std::optional<std::int64_t> target;
  std::string cuts;
  std::optional<std::int64_t> threads;
  bool dark = false;
  bool force = false;
  bool json = false;
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

// Four lines for a target: where it is and how strong, and its two cuts. Theory in parentheses.
std::string text_of(const workflow::MeasuredTarget& target) {
  const workflow::TargetTheory& theory = target.theory;
  std::string text = fmt::format("target {:<4} azimuth {:.3f} m, range {:.3f} m", theory.target + 1,
                                 theory.place.azimuth_m, theory.place.range_m);
  if (!(theory.amplitude > 0.0)) return text + ": no echoes\n";
  if (!target.found) return text + ": not found\n";
  const signal::PointResponse& found = *target.found;
  text +=
      fmt::format("; found {:+.4f} m, {:+.4f} m away; amplitude {:.4g} V ({:+.2f} dB), phase {:.3f} rad ({:+.3f})\n",
                  found.place.azimuth_m - theory.place.azimuth_m, found.place.range_m - theory.place.range_m,
                  found.amplitude, target.amplitude_error_db(), found.phase_rad, target.phase_error_rad());
  text += fmt::format("  {:<8}{}\n", "azimuth", figures_row(theory.azimuth, found.azimuth));
  text += fmt::format("  {:<8}{}\n", "range", figures_row(theory.range, found.range));
  return text;
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

void write_target_json(core::JsonWriter& json, const workflow::MeasuredTarget& target) {
  const workflow::TargetTheory& theory = target.theory;
  json.begin_object().member("target", theory.target + 1).key("theory").begin_object();
  json.member("azimuth_m", theory.place.azimuth_m).member("range_m", theory.place.range_m);
  json.member("amplitude_v", theory.amplitude).member("phase_rad", theory.phase_rad);
  write_figures(json, "azimuth", theory.azimuth);
  write_figures(json, "range", theory.range);
  json.end_object().key("found");
  if (!target.found) {
    json.null().end_object();
    return;
  }
  const signal::PointResponse& found = *target.found;
  json.begin_object().member("azimuth_m", found.place.azimuth_m).member("range_m", found.place.range_m);
  json.member("amplitude_v", found.amplitude).member("phase_rad", found.phase_rad);
  write_figures(json, "azimuth", found.azimuth);
  write_figures(json, "range", found.range);
  json.end_object();
  json.member("azimuth_error_m", found.place.azimuth_m - theory.place.azimuth_m);
  json.member("range_error_m", found.place.range_m - theory.place.range_m);
  json.member("amplitude_error_db", target.amplitude_error_db());
  json.member("phase_error_rad", target.phase_error_rad()).end_object();
}

std::string text_of_measure(const std::string& image, const workflow::MeasureReport& report) {
  std::string text = fmt::format("{}: {} by {}; theory in parentheses\n  {:<8}{:>18}  {:>18}  {:>18}\n", image,
                                 counted(report.targets.size(), "target"), report.origin.algorithm, "",
                                 "-3 dB width (m)", "PSLR (dB)", "ISLR (dB)");
  for (const workflow::MeasuredTarget& target : report.targets) text += text_of(target);
  return text;
}

std::string json_of_measure(const std::string& image, const workflow::MeasureReport& report) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("image", image);
  json.member("source", report.origin.source).member("algorithm", report.origin.algorithm);
  json.key("targets").begin_array();
  for (const workflow::MeasuredTarget& target : report.targets) write_target_json(json, target);
  json.end_array().end_object();
  return json.text();
}

// One picture for each target that was found.
void draw_cuts(const MeasureArguments& arguments, const workflow::MeasureReport& report, const core::StopFlag* stop) {
  if (arguments.cuts.empty()) return;
  std::filesystem::create_directories(arguments.cuts);
  for (const workflow::MeasuredTarget& target : report.targets) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    if (!target.found) continue;
    picture::Figure figure = figure_of_cuts(target.cuts, *target.found, target.theory.azimuth, target.theory.range);
    figure.title = fmt::format("Target {} of {}", target.theory.target + 1, arguments.image);
    draw_picture(figure, target.picture, {.width_px = 800, .height_px = 800, .dark = arguments.dark});
  }
}

workflow::MeasureRequest measure_request_of(const MeasureArguments& arguments) {
  workflow::MeasureRequest request;
  request.image = arguments.image;
  request.input = arguments.input;
  request.search_m = arguments.search_m;
  if (arguments.target) request.target = static_cast<std::size_t>(*arguments.target);
  request.pictures = arguments.cuts;
  request.force = arguments.force;
  request.threads = static_cast<unsigned>(arguments.threads.value_or(0));
  return request;
}

ExitStatus run_measure(const MeasureArguments& arguments, Streams& streams) {
  Watch watch(streams, false);
  const workflow::MeasureReport report = workflow::measure(measure_request_of(arguments), watch.observer());
  write_out(streams,
            arguments.json ? json_of_measure(arguments.image, report) : text_of_measure(arguments.image, report));
  flush_out(streams);
  draw_cuts(arguments, report, streams.stop);
  return exit_done;
}

}  // namespace

Action add_measure(CLI::App& app) {
  auto arguments = std::make_shared<MeasureArguments>();
  add_text(app, "image", arguments->image, "IMAGE", "complex image that sarsim focus wrote as ENVI or NPY")->required();
  add_recording_arguments(app, arguments->input);
  add_real(app, "--search", arguments->search_m, "M",
           "how far from its place a target's peak may be (default: 3 cells, or half way to the next target)");
  add_integer(app, "--target", arguments->target, 1, std::numeric_limits<std::int64_t>::max(),
              "one target only, by its number in the script");
  add_text(app, "--cuts", arguments->cuts, "DIR", "draw the cuts through each target: DIR/target-1.png and so on");
  app.add_flag("--dark", arguments->dark, "the pictures in dark colours");
  app.add_flag("--force", arguments->force, "replace pictures that exist");
  add_integer(app, "--threads", arguments->threads, 0, 4096, "threads; 0 for one per core (default)");
  app.add_flag("--json", arguments->json, "as JSON");
  add_examples(app, {{"sarsim measure sar_r.img", "the targets of the script that was focused"},
                     {"sarsim measure sar_r.npy --json", "for programs"},
                     {"sarsim measure sar_r.img --target 5 --cuts pictures", "with a picture of the response"}});
  return [arguments](Streams& streams) { return run_measure(*arguments, streams); };
}

}  // namespace sarsim::cli
