#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/measure_cuts.hpp"
#include "cli/command/picture_program.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/recording_input.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "signal/measure/image_quality.hpp"
#include "signal/sar/ground_grid.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/sar_theory.hpp"
#include "workflow/image/image_fields.hpp"
#include "workflow/image/image_script.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

struct MeasureArguments {
  std::string image;
  RecordingArguments input;
  std::optional<double> search_m;
  std::optional<std::int64_t> target;
  std::string cuts;
  std::optional<std::int64_t> threads;
  bool dark = false;
  bool force = false;
  bool json = false;
};

// A target as it should be and as it is.
struct Measured {
  workflow::TargetTheory theory;
  std::optional<signal::PointResponse> found;
  signal::PointCuts cuts;  // where pictures of them are wanted
};

struct MeasuredImage {
  raster::EnviImage file;
  signal::FocusedImage image;
  workflow::ImageOrigin origin;
};

MeasuredImage opened_image(const std::string& path) {
  if (!fs::exists(path))
    throw core::Refused(fmt::format("there is no file '{}'", path), "name an image of sarsim focus");
  auto [file, problems] = raster::EnviImage::open(path);
  if (!file) throw core::Refused(std::move(problems));
  if (file->header().pixel != raster::EnviHeader::Pixel::complex_float)
    throw core::Refused(fmt::format("'{}' holds magnitudes", path), "measure the complex image beside it");
  MeasuredImage opened{std::move(*file), {}, {}};
  workflow::read_header(opened.file.header(), raster::envi_header_of(path).string(), opened.image, opened.origin);
  return opened;
}

// What was focused, as the header says, unless the command line says otherwise.
RecordingArguments input_of(const MeasureArguments& arguments, const MeasuredImage& opened, Streams& streams) {
  const workflow::ImageOrigin& origin = opened.origin;
  RecordingArguments input = arguments.input;
  if (!input.simulation) input.simulation = static_cast<std::int64_t>(origin.simulation) + 1;
  workflow::WayBack way = workflow::way_back(opened.file.header(), origin, arguments.image, input.script);
  print_problems(streams, way.problems);
  input.path = std::move(way.source);
  input.script = std::move(way.script);
  return input;
}

void expect_folder(const std::string& cuts) {
  if (!cuts.empty() && fs::exists(cuts) && !fs::is_directory(cuts))
    throw core::Refused(fmt::format("--cuts: '{}' is not a folder", cuts), "name a folder; it is made when missing");
}

double phase_error(const Measured& target) {
  return std::remainder(target.found->phase_rad - target.theory.phase_rad, 2.0 * core::pi);
}

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
std::string text_of(const Measured& target) {
  const workflow::TargetTheory& theory = target.theory;
  std::string text = fmt::format("target {:<4} azimuth {:.3f} m, range {:.3f} m", theory.target + 1,
                                 theory.place.azimuth_m, theory.place.range_m);
  if (!(theory.amplitude > 0.0)) return text + ": no echoes\n";
  if (!target.found) return text + ": not found\n";
  const signal::PointResponse& found = *target.found;
  text += fmt::format(
      "; found {:+.4f} m, {:+.4f} m away; amplitude {:.4g} V ({:+.2f} dB), phase {:.3f} rad ({:+.3f})\n",
      found.place.azimuth_m - theory.place.azimuth_m, found.place.range_m - theory.place.range_m, found.amplitude,
      core::amplitude_db(found.amplitude / theory.amplitude), found.phase_rad, phase_error(target));
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

void write_target_json(core::JsonWriter& json, const Measured& target) {
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
  json.member("amplitude_error_db", core::amplitude_db(found.amplitude / theory.amplitude));
  json.member("phase_error_rad", phase_error(target)).end_object();
}

// Half the distance to the nearest other target, at most three cells: the peak found shall be that of the target.
double search_of(const std::vector<workflow::TargetTheory>& theories, const workflow::TargetTheory& theory) {
  const double cell_m = std::max(theory.azimuth ? theory.azimuth->null : 1.0, theory.range ? theory.range->null : 1.0);
  double search_m = 3.0 * cell_m;
  for (const workflow::TargetTheory& other : theories) {
    if (other.target == theory.target || !(other.amplitude > 0.0)) continue;
    const double distance_m =
        std::hypot(other.place.azimuth_m - theory.place.azimuth_m, other.place.range_m - theory.place.range_m);
    search_m = std::min(search_m, std::max(0.5 * distance_m, 0.5 * cell_m));
  }
  return search_m;
}

// On a ground grid ranges are as far apart as the ground is seen flat, and places along the flight as it climbs.
void lay_on_ground(workflow::TargetTheory& theory, const signal::ImageFrame& grid, const signal::ImageFrame& slant) {
  const signal::ImagePlace place = signal::place_on_ground(grid, slant, theory.place);
  const signal::ImagePlace farther =
      signal::place_on_ground(grid, slant, {theory.place.azimuth_m, theory.place.range_m + 1.0});
  const signal::ImagePlace ahead =
      signal::place_on_ground(grid, slant, {theory.place.azimuth_m + 1.0, theory.place.range_m});
  theory.place = place;
  if (theory.azimuth) {
    theory.azimuth->width *= ahead.azimuth_m - place.azimuth_m;
    theory.azimuth->null *= ahead.azimuth_m - place.azimuth_m;
  }
  if (!theory.range) return;
  theory.range->width *= farther.range_m - place.range_m;
  theory.range->null *= farther.range_m - place.range_m;
}

std::vector<workflow::TargetTheory> theories_of(const MeasuredImage& opened, const workflow::FocusInput& input,
                                                const core::WorkControl& control) {
  const bool time_domain = opened.origin.algorithm == "back-projection";
  signal::EchoRows echoes = input.echoes;
  echoes.compensated = time_domain || opened.origin.motion != "none";
  std::vector<workflow::TargetTheory> theories =
      workflow::theory_of_targets(*input.plan, echoes, opened.origin.options, time_domain, control);
  const signal::StraightTrack track = signal::fit_straight(echoes.track);
  const signal::ImageFrame& frame = opened.image.frame;
  if (frame.plane == signal::ImagePlane::slant_range) {
    // Compensated pulses lie elsewhere along the line, and so does the image's origin.
    for (workflow::TargetTheory& theory : theories)
      theory.place.azimuth_m -= core::dot(frame.origin_m - track.origin_m, track.along);
    return theories;
  }
  const signal::ImageFrame slant{.plane = signal::ImagePlane::slant_range,
                                 .origin_m = track.origin_m,
                                 .along = track.along,
                                 .speed_mps = track.speed_mps};
  for (workflow::TargetTheory& theory : theories)
    if (theory.amplitude > 0.0) lay_on_ground(theory, frame, slant);
  return theories;
}

bool is_asked_for(const MeasureArguments& arguments, const workflow::TargetTheory& theory) {
  return !arguments.target || static_cast<std::int64_t>(theory.target) + 1 == *arguments.target;
}

fs::path picture_of(const MeasureArguments& arguments, const workflow::TargetTheory& theory) {
  return fs::path(arguments.cuts) / fmt::format("target-{}.png", theory.target + 1);
}

// Before anything is measured.
void expect_free_pictures(const MeasureArguments& arguments, const std::vector<workflow::TargetTheory>& theories) {
  if (arguments.cuts.empty() || arguments.force) return;
  for (const workflow::TargetTheory& theory : theories)
    if (is_asked_for(arguments, theory) && fs::exists(picture_of(arguments, theory)))
      throw core::Refused(fmt::format("'{}' exists", picture_of(arguments, theory).string()),
                          "name another folder, or --force");
}

std::vector<Measured> measured_targets(const MeasuredImage& opened, const workflow::FocusInput& input,
                                       const MeasureArguments& arguments, const core::WorkControl& control) {
  const std::vector<workflow::TargetTheory> theories = theories_of(opened, input, control);
  expect_free_pictures(arguments, theories);
  const signal::ImageReader reader = [&](std::size_t row, std::size_t first, std::span<std::complex<float>> out) {
    opened.file.read(row, first, out);
  };
  std::vector<Measured> targets(theories.size());
  core::parallel_ranges(theories.size(), 1, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      targets[t].theory = theories[t];
      if (!(theories[t].amplitude > 0.0) || !is_asked_for(arguments, theories[t])) continue;
      const double search_m = arguments.search_m.value_or(search_of(theories, theories[t]));
      targets[t].found = signal::measure_point(opened.image, reader, theories[t].place, search_m,
                                               arguments.cuts.empty() ? nullptr : &targets[t].cuts);
    }
  });
  std::erase_if(targets, [&](const Measured& target) { return !is_asked_for(arguments, target.theory); });
  if (targets.empty())
    throw core::Refused(fmt::format("there is no target {}", arguments.target.value_or(0)),
                        fmt::format("the script has {}", theories.size()));
  return targets;
}

// One picture for each target that was found.
void draw_cuts(const MeasureArguments& arguments, const std::vector<Measured>& targets, const core::StopFlag* stop) {
  if (arguments.cuts.empty()) return;
  fs::create_directories(arguments.cuts);
  for (const Measured& target : targets) {
    if (stop != nullptr && stop->requested()) throw core::Interrupted();
    if (!target.found) continue;
    picture::Figure figure = figure_of_cuts(target.cuts, *target.found, target.theory.azimuth, target.theory.range);
    figure.title = fmt::format("Target {} of {}", target.theory.target + 1, arguments.image);
    draw_picture(figure, picture_of(arguments, target.theory),
                 {.width_px = 800, .height_px = 800, .dark = arguments.dark});
  }
}

ExitStatus measure(const MeasureArguments& arguments, Streams& streams) {
  if (arguments.search_m && !(*arguments.search_m > 0.0)) throw core::Refused("--search must be above 0");
  const core::WorkControl control{core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0))),
                                  streams.stop};
  const MeasuredImage opened = opened_image(arguments.image);
  expect_folder(arguments.cuts);
  const workflow::FocusInput input = workflow::open_focus_input(input_of(arguments, opened, streams), control);
  const std::vector<Measured> targets = measured_targets(opened, input, arguments, control);
  if (!arguments.json) {
    std::string text = fmt::format("{}: {} by {}; theory in parentheses\n  {:<8}{:>18}  {:>18}  {:>18}\n",
                                   arguments.image, counted(targets.size(), "target"), opened.origin.algorithm, "",
                                   "-3 dB width (m)", "PSLR (dB)", "ISLR (dB)");
    for (const Measured& target : targets) text += text_of(target);
    write_out(streams, text);
  } else {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("image", arguments.image);
    json.member("source", opened.origin.source).member("algorithm", opened.origin.algorithm);
    json.key("targets").begin_array();
    for (const Measured& target : targets) write_target_json(json, target);
    json.end_array().end_object();
    write_out(streams, json.text());
  }
  flush_out(streams);
  draw_cuts(arguments, targets, streams.stop);
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
  return [arguments](Streams& streams) { return measure(*arguments, streams); };
}

}  // namespace sarsim::cli
