#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/stepped_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/watch.hpp"
#include "cli/shell/window_option.hpp"
#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/stepped/isar.hpp"
#include "workflow/stepped/isar_scene.hpp"
#include "workflow/stepped/stepped_input.hpp"

namespace sarsim::cli {

namespace {

using Algorithm = workflow::IsarOptions::Algorithm;
using Motion = workflow::IsarOptions::Motion;

struct IsarArguments {
  workflow::RecordingArguments input;
  std::string output;
  std::optional<Algorithm> algorithm;
  std::optional<Motion> motion;
  std::string platform;
  std::optional<double> turn_rate_dps;
  std::optional<std::int64_t> bursts;
  std::optional<std::int64_t> step;
  std::optional<double> cross_range_m;
  std::optional<double> range_m;
  std::optional<std::int64_t> oversampling;
  std::string window;
  std::string range_window;
  std::string azimuth_window;
  std::optional<double> fastest_mps;
  std::optional<std::int64_t> threads;
  bool autofocus = false;
  bool magnitude = false;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

workflow::IsarOptions isar_options(const IsarArguments& a) {
  workflow::IsarOptions options;
  options.algorithm = a.algorithm.value_or(options.algorithm);
  options.motion = a.motion.value_or(options.motion);
  if (a.turn_rate_dps) options.turn_rate_radps = *a.turn_rate_dps * core::pi / 180.0;
  options.cross_range_m = a.cross_range_m;
  options.range_m = a.range_m;
  if (a.oversampling) options.oversampling = static_cast<std::size_t>(*a.oversampling);
  options.range_window = options.azimuth_window = window_of("--window", a.window);
  if (!a.range_window.empty()) options.range_window = window_of("--range-window", a.range_window);
  if (!a.azimuth_window.empty()) options.azimuth_window = window_of("--azimuth-window", a.azimuth_window);
  options.fastest_mps = a.fastest_mps.value_or(options.fastest_mps);
  options.autofocus = a.autofocus;
  return options;
}

workflow::IsarRequest isar_request(const IsarArguments& a) {
  workflow::IsarRequest request{a.input};
  request.output = a.output;
  request.options = isar_options(a);
  request.platform = a.platform;
  if (a.bursts) request.bursts = static_cast<std::size_t>(*a.bursts);
  request.step = static_cast<std::size_t>(a.step.value_or(0));
  request.magnitude = a.magnitude;
  request.replace = a.force;
  request.threads = static_cast<unsigned>(a.threads.value_or(0));
  return request;
}

std::string summary_text(const workflow::WrittenIsarImage& written) {
  const workflow::IsarImage& made = written.image;
  return fmt::format(
      "{}: {} x {} pixels of {:.4g} x {:.4g} m, bursts {} to {}, {:.6g} to {:.6g} s; centre at {:.2f} m and {:.4g} "
      "m/s; turned by {:.4g} degrees; resolution {:.4g} m in cross-range (unambiguous {:.4g} m), {:.4g} m in range\n",
      written.file.string(), made.image.azimuth.count, made.image.range.count, made.image.azimuth.step_m,
      made.image.range.step_m, written.first_burst + 1, written.first_burst + written.bursts, made.from_s, made.to_s,
      made.range_m, made.speed_mps, made.turn_rad * 180.0 / core::pi, made.cross_range_resolution_m,
      made.unambiguous_cross_range_m, made.range_resolution_m);
}

std::string points_text(const workflow::IsarImage& made) {
  std::string text = fmt::format("{:>6} {:>14} {:>10} {:>11} {:>11} {:>10} {:>10} {:>9}\n", "target", "cross-range m",
                                 "range m", "error m", "error m", "width m", "width m", "error dB");
  for (const workflow::HeldPoint& point : made.points) {
    text +=
        fmt::format("{:>6} {:>14.3f} {:>10.3f}", point.target + 1, point.expected.azimuth_m, point.expected.range_m);
    if (point.found)
      text += fmt::format(" {:>11.3f} {:>11.3f} {:>10.3f} {:>10.3f} {:>9.2f}\n",
                          point.found->place.azimuth_m - point.expected.azimuth_m,
                          point.found->place.range_m - point.expected.range_m, point.found->azimuth.width,
                          point.found->range.width, core::amplitude_db(point.found->amplitude / point.amplitude));
    else
      text += "  no peak\n";
  }
  return text;
}

void write_image_member(core::JsonWriter& json, const workflow::WrittenIsarImage& written) {
  const workflow::IsarImage& made = written.image;
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
  for (const workflow::HeldPoint& point : made.points) {
    json.begin_object().member("target", point.target + 1);
    json.member("cross_range_m", point.expected.azimuth_m).member("range_m", point.expected.range_m).key("found");
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

std::string json_text(const workflow::IsarReport& report) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", report.source);
  json.member("algorithm", report.algorithm).key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().key("images").begin_array();
  for (const workflow::WrittenIsarImage& image : report.images) write_image_member(json, image);
  json.end_array().member("seconds", report.seconds).key("problems");
  cli::write_json(json, report.problems);
  return json.end_object().text();
}

ExitStatus run_isar(const IsarArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.quiet);
  const workflow::IsarReport report = workflow::isar(isar_request(arguments), watch.observer());
  watch.close();
  if (!arguments.quiet) {
    for (const workflow::WrittenIsarImage& image : report.images) streams.err << summary_text(image);
    streams.err << fmt::format("done in {}\n", core::duration_text(report.seconds));
  }
  if (arguments.json)
    write_out(streams, json_text(report));
  else if (!arguments.quiet)
    for (const workflow::WrittenIsarImage& image : report.images) write_out(streams, points_text(image.image));
  flush_out(streams);
  return exit_done;
}

void add_isar_options(CLI::App& app, IsarArguments& a) {
  add_text(app, "--out", a.output, "OUT",
           fmt::format("image to write: ENVI (.img, default), or {}; several get numbers", raster::image_extensions()));
  add_choice<Algorithm>(app, "--algorithm", a.algorithm,
                        {{"range-doppler", Algorithm::range_doppler}, {"back-projection", Algorithm::back_projection}},
                        "range-doppler by default; back-projection for large angles, exact and slower");
  add_choice<Motion>(app, "--motion", a.motion, {{"scene", Motion::scene}, {"estimated", Motion::estimated}},
                     "path of the target: the script's (default), or found in the echoes, with autofocus");
  add_text(app, "--platform", a.platform, "NAME",
           "the target's platform (default: the one with the strongest targets)");
  add_real(app, "--turn-rate", a.turn_rate_dps, "DEG/S",
           "how fast the target turns against the line of sight (default: as the script has it)");
  add_integer(app, "--bursts", a.bursts, 2, std::int64_t{1} << 40,
              "bursts, or pulses of one carrier, of an image "
              "(default: all)");
  add_integer(app, "--step", a.step, 1, std::int64_t{1} << 40,
              "bursts from the first of an image to the first of the next (default: those of an image)");
  add_real(app, "--cross-range", a.cross_range_m, "M", "width of the image (default: as large as the target)");
  add_real(app, "--range", a.range_m, "M", "depth of the image (default: as large as the target)");
  add_integer(app, "--oversampling", a.oversampling, 1, 64, "pixels for each resolution cell (default: 2)");
  add_text(app, "--window", a.window, "WINDOW",
           "over range and cross-range: rectangular (default), hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]");
  add_text(app, "--range-window", a.range_window, "WINDOW", "over range alone");
  add_text(app, "--azimuth-window", a.azimuth_window, "WINDOW", "over cross-range alone");
  app.add_flag("--autofocus", a.autofocus, "take out phase errors along the bursts (phase gradient)");
  add_real(app, "--fastest", a.fastest_mps, "M/S", "speeds that --motion estimated looks through (default: 500)");
  add_stepped_input_arguments(app, a.input);
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  app.add_flag("--magnitude", a.magnitude, "also an ENVI image of magnitudes, NAME-magnitude.img");
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

}  // namespace

Action add_isar(CLI::App& app) {
  auto arguments = std::make_shared<IsarArguments>();
  add_text(app, "input", arguments->input.path, "SCENE|DATA", "script to simulate, or file of samples")->required();
  add_isar_options(app, *arguments);
  add_examples(app, {{"sarsim isar turning_ship.scr", "simulate and image: turning_ship-isar.img"},
                     {"sarsim isar turning_ship.scr --bursts 64 --step 32", "a series of images"},
                     {"sarsim isar sim1.h5 --motion estimated --window taylor:35:5", "without knowing the path"},
                     {"sarsim isar turning_ship.scr --algorithm back-projection", "exact for any turning"}});
  return [arguments](Streams& streams) { return run_isar(*arguments, streams); };
}

}  // namespace sarsim::cli
