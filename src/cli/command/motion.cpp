#include <memory>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/scene_options.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "workflow/motion/motion_files.hpp"

namespace sarsim::cli {

namespace {

struct MotionArguments {
  workflow::MotionRequest motion;
  std::optional<double> walker_mps;
  std::optional<double> height_m;
  std::optional<double> error_m;
  std::string parent;
  bool quiet = false;
};

void print_report(const workflow::MotionReport& report, Streams& streams) {
  print_problems(streams, report.remarks);
  std::string text = fmt::format("{}: {} {} from {} s to {} s, {} s apart\n", report.platform, report.samples,
                                 report.format == workflow::MotionFormat::aem ? "attitudes" : "states",
                                 core::format_number(report.first_s), core::format_number(report.last_s),
                                 core::format_number(report.spacing_s));
  if (report.format != workflow::MotionFormat::aem)
    text += fmt::format("between them the interpolation is within {:.2g} m and {:.2g} m/s\n", report.position_error_m,
                        report.velocity_error_mps);
  write_out(streams, text);
}

ExitStatus run_motion(const MotionArguments& arguments, Streams& streams) {
  workflow::MotionRequest motion = arguments.motion;
  if (arguments.error_m) motion.error_m = *arguments.error_m;
  if (!arguments.walker_mps) {
    if (arguments.height_m || !arguments.parent.empty())
      throw core::InvalidRequest("--height and --parent belong to --walker", "leave them out, or give --walker SPEED");
    if (motion.input.empty())
      throw core::InvalidRequest("no scene is given", "sarsim motion SCENE --platform P --out FILE");
    const workflow::MotionReport report = workflow::write_motion(motion, {core::thread_count(0), streams.stop});
    if (!arguments.quiet) print_report(report, streams);
    return exit_done;
  }
  if (!motion.input.empty() || !motion.platform.empty() || motion.navigation || motion.spacing_s)
    throw core::InvalidRequest("a walker needs no scene", "sarsim motion --walker 1.4 --out walker.toml");
  workflow::WalkerRequest walker;
  walker.speed_mps = *arguments.walker_mps;
  walker.height_m = arguments.height_m.value_or(walker.height_m);
  walker.start_s = motion.start_s.value_or(walker.start_s);
  walker.end_s = motion.end_s.value_or(walker.end_s);
  walker.parent = arguments.parent;
  walker.output = motion.output;
  walker.force = motion.force;
  workflow::write_walker(walker);
  return exit_done;
}

}  // namespace

Action add_motion(CLI::App& app) {
  auto arguments = std::make_shared<MotionArguments>();
  workflow::MotionRequest* const motion = &arguments->motion;
  add_text(app, "input", motion->input, "SCENE", "scene whose platform moves");
  add_text(app, "--platform", motion->platform, "NAME", "which platform (default: the only one)");
  add_text(app, "-o,--out,--output", motion->output, "FILE",
           "file to write: .csv, .oem (CCSDS, with an Earth), .aem (attitudes), .txt (data file of a script)")
      ->required();
  add_real(app, "--start", motion->start_s, "S", "first time (default: of the recordings)");
  add_real(app, "--end", motion->end_s, "S", "last time");
  add_real(app, "--spacing", motion->spacing_s, "S", "time between states (default: as --error needs)");
  add_real(app, "--error", arguments->error_m, "M", "largest error of the interpolation (default: 1e-6)");
  app.add_flag("--navigation", motion->navigation, "the platform's navigation solution, including its errors");
  add_real(app, "--walker", arguments->walker_mps, "M/S",
           "write a person who walks at that speed as 17 platforms of a scene");
  add_real(app, "--height", arguments->height_m, "M", "of the walker (default: 1.8)");
  add_text(app, "--parent", arguments->parent, "NAME", "platform along whose x axis the walker goes");
  add_scene_overrides(app, motion->overrides);
  app.add_flag("--force", motion->force, "replace the output file where it exists");
  app.add_flag("--quiet", arguments->quiet, "only errors on standard error");
  add_examples(app,
               {{"sarsim motion scene.toml --platform Aircraft --out track.csv", "states, with the error between them"},
                {"sarsim motion scene.toml --platform Aircraft --navigation --out nav.csv",
                 "the navigation solution, for focus --navigation nav.csv"},
                {"sarsim motion sat.toml --start -60 --end 60 --out sat.oem", "a CCSDS ephemeris message"},
                {"sarsim motion --walker 1.4 --end 10 --out walker.toml", "a person, to be included by a scene"}});
  return [arguments](Streams& streams) { return run_motion(*arguments, streams); };
}

}  // namespace sarsim::cli
