#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/image_output.hpp"
#include "cli/command/stepped_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/window_option.hpp"
#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/stepped/isar_scene.hpp"
#include "workflow/stepped/stepped_input.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

using Algorithm = workflow::IsarOptions::Algorithm;
using Motion = workflow::IsarOptions::Motion;

struct IsarArguments {
  RecordingArguments input;
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

const char* word_of(Algorithm algorithm) {
  return algorithm == Algorithm::range_doppler ? "isar-range-doppler" : "isar-back-projection";
}

// One run of the command, from its input to the files of its images.
class IsarRun {
 public:
  IsarRun(const IsarArguments& arguments, Streams& streams) : arguments_(arguments), streams_(streams) {
    control_ = {core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0))), streams.stop};
  }

  ExitStatus run() {
    const auto begin = std::chrono::steady_clock::now();
    read_options();
    input_ = workflow::open_stepped_input(arguments_.input, workflow::SteppedUse::isar, control_);
    if (options_.motion == Motion::estimated) expect_searchable(options_.fastest_mps, input_.rows);
    find_platform();
    cut_bursts();
    expect_free_outputs();
    find_problems();
    for (std::size_t i = 0; i < firsts_.size(); ++i) make(i);
    report(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return exit_done;
  }

 private:
  void read_options() {
    options_.algorithm = arguments_.algorithm.value_or(Algorithm::range_doppler);
    options_.motion = arguments_.motion.value_or(Motion::scene);
    if (options_.algorithm == Algorithm::back_projection &&
        (options_.motion == Motion::estimated || arguments_.turn_rate_dps))
      throw core::Refused("back-projection needs the path of the target as the script has it",
                          "leave out --motion estimated and --turn-rate, or choose --algorithm range-doppler");
    if (arguments_.turn_rate_dps) {
      options_.turn_rate_radps = *arguments_.turn_rate_dps * core::pi / 180.0;
      if (*options_.turn_rate_radps == 0.0) throw core::Refused("--turn-rate: without turning there is no cross-range");
    }
    options_.cross_range_m = arguments_.cross_range_m;
    options_.range_m = arguments_.range_m;
    options_.oversampling = static_cast<std::size_t>(arguments_.oversampling.value_or(2));
    options_.range_window = options_.azimuth_window = window_of("--window", arguments_.window);
    if (!arguments_.range_window.empty()) options_.range_window = window_of("--range-window", arguments_.range_window);
    if (!arguments_.azimuth_window.empty())
      options_.azimuth_window = window_of("--azimuth-window", arguments_.azimuth_window);
    options_.fastest_mps = arguments_.fastest_mps.value_or(options_.fastest_mps);
    if (!(options_.fastest_mps > 0.0 && options_.fastest_mps < 1e6))
      throw core::Refused(fmt::format("--fastest: {} m/s is out of range", options_.fastest_mps), "above 0, below 1e6");
    options_.autofocus = arguments_.autofocus || options_.motion == Motion::estimated;
    if (arguments_.magnitude && !is_envi(output()))
      throw core::Refused("--magnitude makes ENVI images", "name the output .img");
  }

  void find_platform() {
    const auto& platforms = input_.rows.plan->scene->platforms;
    if (arguments_.platform.empty()) {
      const auto found = workflow::platform_of_targets(*input_.rows.plan);
      if (!found)
        throw core::Refused("no target is on a platform of its own", "name the target's platform with --platform");
      options_.platform = *found;
      return;
    }
    const auto found = std::ranges::find_if(platforms, [&](const simulate::ResolvedPlatform& p) {
      return core::equal_ignoring_case(p.name, arguments_.platform);
    });
    if (found == platforms.end()) {
      std::vector<std::string> names;
      names.reserve(platforms.size());
      for (const simulate::ResolvedPlatform& platform : platforms) names.push_back(platform.name);
      const std::string near = core::nearest_word(arguments_.platform, names);
      throw core::Refused(fmt::format("--platform: the script has no platform '{}'", arguments_.platform),
                          near.empty() ? "" : fmt::format("did you mean '{}'?", near));
    }
    options_.platform = static_cast<std::size_t>(found - platforms.begin());
    if (options_.platform == input_.rows.plan->radar.platform)
      throw core::Refused(fmt::format("--platform: '{}' carries the radar itself", found->name),
                          "name the platform of the target");
  }

  // Bursts of each image.
  void cut_bursts() {
    const std::size_t all = input_.rows.bursts;
    count_ = arguments_.bursts ? static_cast<std::size_t>(*arguments_.bursts) : all;
    const std::size_t step = arguments_.step ? static_cast<std::size_t>(*arguments_.step) : count_;
    if (count_ < 2 || count_ > all)
      throw core::Refused(
          fmt::format("an image needs from 2 to {} bursts, which the recording has, not {}", all, count_),
          "choose other --bursts, or record for longer");
    for (std::size_t first = 0; first + count_ <= all; first += step) firsts_.push_back(first);
  }

  [[nodiscard]] fs::path output() const {
    if (!arguments_.output.empty()) return arguments_.output;
    return fs::path(arguments_.input.path).stem().string() + "-isar.img";
  }

  // NAME.img, or NAME-1.img, NAME-2.img ... of several images.
  [[nodiscard]] fs::path output(std::size_t index) const {
    fs::path path = output();
    if (firsts_.size() == 1) return path;
    return path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string());
  }

  [[nodiscard]] std::vector<fs::path> outputs() const {
    std::vector<fs::path> paths;
    for (std::size_t i = 0; i < firsts_.size(); ++i) {
      std::ranges::copy(files_of_image(output(i)), std::back_inserter(paths));
      if (arguments_.magnitude) std::ranges::copy(files_of_image(magnitude_path(output(i))), std::back_inserter(paths));
    }
    return paths;
  }

  void expect_free_outputs() const { cli::expect_free_outputs(outputs(), {input_.sources, arguments_.force, "--out"}); }

  void find_problems() {
    core::Problems& problems = input_.problems;
    for (const std::size_t first : firsts_) {
      if (streams_.stop != nullptr && streams_.stop->requested()) throw core::Interrupted();
      std::ranges::move(workflow::plan_isar_image(input_.rows, first, count_, options_).problems,
                        std::back_inserter(problems));
    }
    std::ranges::move(workflow::remarks_on_stepped(input_.rows, workflow::SteppedUse::isar, {}),
                      std::back_inserter(problems));
    problems = core::ranked(std::move(problems));
    if (core::has_errors(problems)) throw core::Refused(problems);
    if (!arguments_.quiet) print_problems(streams_, problems);
  }

  void make(std::size_t index) {
    workflow::IsarImage made;
    {
      ProgressDisplay display(streams_.err, display_style(streams_, arguments_.quiet), output(index).string());
      made = workflow::make_isar_image(input_.rows, firsts_[index], count_, options_, control_,
                                       [&display](const core::Progress& p) { display.update(p); });
    }
    signal::FocusedRows rows;
    rows.image = made.image;
    rows.image.values.clear();
    rows.read = [&made](std::size_t row, std::span<std::complex<float>> out) {
      std::copy_n(made.image.values.data() + row * made.image.range.count, out.size(), out.data());
    };
    // Rows of recordings have times: here, as many metres in a second.
    rows.image.frame.speed_mps = 1.0;
    signal::FocusOptions focus;
    focus.range_window = options_.range_window;
    focus.azimuth_window = options_.azimuth_window;
    const simulate::Plan& plan = *input_.rows.plan;
    const ImageOrigin origin{
        arguments_.input.path, arguments_.input.script, input_.simulation, word_of(options_.algorithm), focus, "none",
        plan.radar.name,       plan.scene->options};
    const fs::path path = output(index);
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    write_image(rows, origin, path, arguments_.force, false, streams_.stop);
    if (arguments_.magnitude) write_image(rows, origin, magnitude_path(path), arguments_.force, true, streams_.stop);
    made.image.values.clear();
    made.image.values.shrink_to_fit();
    images_.push_back(std::move(made));
  }

  void report(double seconds) const {
    if (!arguments_.quiet)
      for (std::size_t i = 0; i < images_.size(); ++i) streams_.err << summary(i);
    if (!arguments_.quiet) streams_.err << fmt::format("done in {}\n", core::duration_text(seconds));
    if (arguments_.json) {
      write_out(streams_, json_text(seconds));
    } else if (!arguments_.quiet) {
      for (const workflow::IsarImage& image : images_) write_out(streams_, table(image));
    }
    flush_out(streams_);
  }

  [[nodiscard]] std::string summary(std::size_t index) const {
    const workflow::IsarImage& made = images_[index];
    return fmt::format(
        "{}: {} x {} pixels of {:.4g} x {:.4g} m, bursts {} to {}, {:.6g} to {:.6g} s; centre at {:.2f} m and {:.4g} "
        "m/s; turned by {:.4g} degrees; resolution {:.4g} m in cross-range (unambiguous {:.4g} m), {:.4g} m in range\n",
        output(index).string(), made.image.azimuth.count, made.image.range.count, made.image.azimuth.step_m,
        made.image.range.step_m, firsts_[index] + 1, firsts_[index] + count_, made.from_s, made.to_s, made.range_m,
        made.speed_mps, made.turn_rad * 180.0 / core::pi, made.cross_range_resolution_m, made.unambiguous_cross_range_m,
        made.range_resolution_m);
  }

  [[nodiscard]] static std::string table(const workflow::IsarImage& made) {
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

  [[nodiscard]] std::string json_text(double seconds) const {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("source", arguments_.input.path);
    json.member("algorithm", word_of(options_.algorithm)).key("files").begin_array();
    for (const fs::path& path : outputs()) json.value(path.string());
    json.end_array().key("images").begin_array();
    for (std::size_t i = 0; i < images_.size(); ++i) write_image_member(json, i);
    json.end_array().member("seconds", seconds).key("problems");
    write_json(json, input_.problems);
    return json.end_object().text();
  }

  void write_image_member(core::JsonWriter& json, std::size_t index) const {
    const workflow::IsarImage& made = images_[index];
    json.begin_object().member("file", output(index).string());
    json.member("first_burst", firsts_[index] + 1).member("last_burst", firsts_[index] + count_);
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
        json.member("cross_range_width_m", point.found->azimuth.width)
            .member("range_width_m", point.found->range.width);
        json.member("amplitude_error_db", core::amplitude_db(point.found->amplitude / point.amplitude)).end_object();
      } else {
        json.null();
      }
      json.end_object();
    }
    json.end_array().end_object();
  }

  const IsarArguments& arguments_;
  Streams& streams_;
  core::WorkControl control_;
  workflow::IsarOptions options_;
  workflow::SteppedInput input_;
  std::size_t count_ = 0;
  std::vector<std::size_t> firsts_;
  std::vector<workflow::IsarImage> images_;
};

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
  return [arguments](Streams& streams) { return IsarRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
