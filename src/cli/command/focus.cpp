#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/focus_arguments.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/window_option.hpp"
#include "core/build/version.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "signal/sar/sar_track.hpp"
#include "workflow/focus/autofocus.hpp"
#include "workflow/focus/back_projection.hpp"
#include "workflow/focus/focus_input.hpp"
#include "workflow/focus/sar_ghosts.hpp"
#include "workflow/focus/sar_rows.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/scene_input.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

// One run of the command, from its input to the image's files.
class FocusRun {
 public:
  FocusRun(const FocusArguments& arguments, Streams& streams) : arguments_(arguments), streams_(streams) {
    control_ = {core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0))), streams.stop};
  }

  ExitStatus run() {
    const double begin_s = core::now_s();
    options_.memory_bytes = memory_of(arguments_.memory);
    read_windows();
    read_centroid();
    expect_sense();
    expect_free_outputs();
    input_ = workflow::open_focus_input(arguments_.input, control_);
    options_.scratch_folder = arguments_.scratch;
    options_.doppler_bandwidth_hz = arguments_.bandwidth_hz.value_or(0.0);
    find_centroid();
    expect_focusable();
    compensate_track();
    find_problems();
    signal::FocusedRows image = focused();
    if (arguments_.autofocus)
      image = workflow::autofocused(image, input_, autofocus_choice(), options_, control_, autofocus_);
    write(image);
    report(image, core::now_s() - begin_s);
    return exit_done;
  }

 private:
  void read_windows() {
    options_.range_window = window_of("--window", arguments_.window);
    options_.azimuth_window = options_.range_window;
    if (!arguments_.range_window.empty()) options_.range_window = window_of("--range-window", arguments_.range_window);
    if (!arguments_.azimuth_window.empty())
      options_.azimuth_window = window_of("--azimuth-window", arguments_.azimuth_window);
    if (algorithm() == FocusAlgorithm::range_doppler) options_.method = signal::FocusMethod::range_doppler;
    if (algorithm() == FocusAlgorithm::chirp_scaling) options_.method = signal::FocusMethod::chirp_scaling;
  }

  void read_centroid() {
    const std::string& text = arguments_.centroid;
    given_centroid_hz_ = core::parse_number(text);
    centroid_is_measured_ = core::equal_ignoring_case(text, "measured");
    if (!given_centroid_hz_ && !centroid_is_measured_ && !core::equal_ignoring_case(text, "geometry"))
      throw core::Refused(fmt::format("--doppler-centroid: '{}' is none", text),
                          "geometry, measured or a number of Hz");
  }

  [[nodiscard]] FocusAlgorithm algorithm() const { return arguments_.algorithm.value_or(FocusAlgorithm::omega_k); }

  [[nodiscard]] fs::path output() const {
    if (!arguments_.output.empty()) return arguments_.output;
    return fs::path(arguments_.input.path).stem().string() + ".img";
  }

  [[nodiscard]] std::vector<fs::path> outputs() const {
    std::vector<fs::path> paths = workflow::files_of_image(output());
    if (arguments_.magnitude)
      std::ranges::copy(workflow::files_of_image(workflow::magnitude_path(output())), std::back_inserter(paths));
    if (!arguments_.autofocus_phase.empty()) paths.emplace_back(arguments_.autofocus_phase);
    return paths;
  }

  [[nodiscard]] bool on_ground() const { return arguments_.grid == FocusGrid::ground; }

  void expect_sense() const {
    const bool back_projection = algorithm() == FocusAlgorithm::back_projection;
    if (!back_projection && on_ground())
      throw core::Refused("--grid ground needs an algorithm that takes any points", "add --algorithm back-projection");
    if (!back_projection && arguments_.start_stop)
      throw core::Refused("--start-stop is for back-projection", "add --algorithm back-projection");
    if (back_projection && arguments_.motion.value_or(workflow::MotionOrder::none) != workflow::MotionOrder::none)
      throw core::Refused("back-projection takes the track as it is, and needs no motion compensation",
                          "leave out --motion-compensation");
    if (on_ground() && arguments_.autofocus)
      throw core::Refused("--autofocus needs an image of slant range", "leave out --grid ground");
    if (!arguments_.autofocus && (arguments_.autofocus_piece_m || !arguments_.autofocus_phase.empty()))
      throw core::Refused("--autofocus-piece and --autofocus-phase say how --autofocus works", "add --autofocus");
    if (arguments_.autofocus_piece_m && !(*arguments_.autofocus_piece_m > 0.0))
      throw core::Refused("--autofocus-piece must be above 0", "give metres along the track");
  }

  void expect_free_outputs() const {
    if (arguments_.magnitude && !workflow::is_envi(output()))
      throw core::Refused("--magnitude makes ENVI images", "name the output .img");
    const std::vector<fs::path> paths = outputs();
    workflow::OutputCare care{named_sources(arguments_.input), arguments_.force, "--out"};
    if (arguments_.force)  // Otherwise nothing that exists is replaced.
      std::ranges::move(workflow::sources_of_script(script_path()), std::back_inserter(care.sources));
    workflow::expect_free_outputs(paths, care);
    for (const fs::path& path : paths) {
      const fs::path folder = first_that_exists(path.parent_path());
      std::error_code ignored;
      if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw core::Refused(fmt::format("'{}' cannot be made: '{}' is no folder", path.string(), folder.string()),
                            "give the output another name");
    }
  }

  [[nodiscard]] std::string script_path() const {
    if (!arguments_.input.script.empty()) return arguments_.input.script;
    return fs::path(arguments_.input.path).extension() == ".scr" ? arguments_.input.path : std::string();
  }

  // A folder, or else the nearest one above it.
  static fs::path first_that_exists(fs::path folder) {
    std::error_code ignored;
    while (!folder.empty() && folder != folder.root_path() && !fs::exists(folder, ignored))
      folder = folder.parent_path();
    return folder;
  }

  // The middle of the Doppler band as it is known before motion is compensated; measured, it is that of the echoes as
  // they came.
  void find_centroid() {
    if (given_centroid_hz_) options_.doppler_centroid_hz = *given_centroid_hz_;
    if (given_centroid_hz_ || !has_speed()) return;
    options_.doppler_centroid_hz = workflow::geometric_doppler_centroid_hz(*input_.plan);
    measure_centroid();
  }

  void measure_centroid() {
    if (!centroid_is_measured_ || input_.echoes.samples == 0) return;
    options_.doppler_centroid_hz =
        signal::measured_doppler_centroid_hz(input_.echoes, options_.doppler_centroid_hz, control_);
  }

  // What compensation does not mend is said before it.
  void expect_focusable() {
    core::Problems problems = problems_of_echoes();
    const bool in_time = algorithm() == FocusAlgorithm::back_projection;
    const bool mended =
        !in_time && arguments_.motion.value_or(workflow::MotionOrder::second) != workflow::MotionOrder::none;
    if (mended && has_speed() && wants_motion() != workflow::MotionOrder::none) workflow::expect_one_way(input_.echoes);
    std::erase_if(problems, [&](const core::Problem& problem) {
      return problem.severity != core::Severity::error || (mended && problem.subject.field == signal::track_field);
    });
    if (!problems.empty()) {
      std::ranges::copy(input_.problems, std::back_inserter(problems));
      throw core::Refused(core::ranked(std::move(problems)));
    }
    if (!arguments_.autofocus || !has_speed()) return;
    workflow::expect_autofocus(in_time ? workflow::back_projection_axes(input_, options_, control_)
                                       : signal::image_of(input_.echoes, options_),
                               input_, autofocus_choice(), options_, control_);
  }

  [[nodiscard]] workflow::AutofocusChoice autofocus_choice() const {
    return {arguments_.autofocus_piece_m.value_or(0.0), options_.memory_bytes};
  }

  void compensate_track() {
    if (algorithm() == FocusAlgorithm::back_projection || !has_speed()) return;
    motion_ = wants_motion();
    if (motion_ == workflow::MotionOrder::none) return;
    strays_m_ = signal::fit_straight(input_.echoes.track).worst_position_m;
    ProgressDisplay display(streams_.err, style(), output().string() + ": motion compensation");
    workflow::compensate(input_, motion_, arguments_.ground_m, options_, control_,
                         [&display](const core::Progress& p) { display.update(p); });
    measure_centroid();
  }

  [[nodiscard]] workflow::MotionOrder wants_motion() const {
    if (arguments_.motion) return *arguments_.motion;
    return workflow::wants_compensation(input_.echoes, options_) ? workflow::MotionOrder::second
                                                                 : workflow::MotionOrder::none;
  }

  // Without it nothing can be focused, which `find_problems` says.
  [[nodiscard]] bool has_speed() const {
    return input_.echoes.track.size() >= 2 && signal::fit_straight(input_.echoes.track).speed_mps > 0.0;
  }

  [[nodiscard]] core::Problems problems_of_echoes() const {
    return algorithm() == FocusAlgorithm::back_projection
               ? signal::problems_of_focusing_in_time(input_.echoes, options_)
               : signal::problems_of_focusing(input_.echoes, options_);
  }

  void find_problems() {
    core::Problems& problems = input_.problems;
    std::ranges::move(problems_of_echoes(), std::back_inserter(problems));
    if (core::has_errors(problems)) throw core::Refused(core::ranked(std::move(problems)));
    const workflow::DopplerBand kept{options_.doppler_centroid_hz, options_.doppler_bandwidth_hz};
    std::ranges::move(workflow::remarks_on_sar(*input_.plan, input_.echoes, kept, control_),
                      std::back_inserter(problems));
    problems = core::ranked(std::move(problems));
    if (!arguments_.quiet) print_problems(streams_, problems);
  }

  [[nodiscard]] signal::FocusedRows focused() {
    ProgressDisplay display(streams_.err, style(), output().string());
    const auto progress = [&display](const core::Progress& p) { display.update(p); };
    if (algorithm() == FocusAlgorithm::back_projection) {
      const workflow::BackProjectionChoice choice{on_ground(), arguments_.ground_m, arguments_.start_stop};
      return workflow::back_projected(input_, choice, options_, control_, progress);
    }
    signal::FocusOptions options = options_;
    // The compensated echoes have the other half.
    if (motion_ != workflow::MotionOrder::none) options.memory_bytes /= 2;
    return signal::focus_rows(input_.echoes, options, control_, progress);
  }

  [[nodiscard]] ProgressDisplay::Style style() const {
    if (arguments_.quiet) return ProgressDisplay::Style::none;
    return streams_.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines;
  }

  void write(const signal::FocusedRows& image) const {
    const workflow::ImageOrigin origin{
        arguments_.input.path, arguments_.input.script, input_.simulation,          word_of(algorithm()), options_,
        to_string(motion_),    input_.plan->radar.name, input_.plan->scene->options};
    for (const fs::path& path : outputs())
      if (path.has_parent_path()) fs::create_directories(path.parent_path());
    workflow::write_image(image, origin, output(), arguments_.force, false, streams_.stop);
    if (arguments_.magnitude)
      workflow::write_image(image, origin, workflow::magnitude_path(output()), arguments_.force, true, streams_.stop);
    if (!arguments_.autofocus_phase.empty())
      workflow::write_phase(autofocus_, arguments_.autofocus_phase, arguments_.force);
  }

  void report(const signal::FocusedRows& rows, double seconds) const {
    const signal::FocusedImage& image = rows.image;
    const auto last = [](const signal::ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); };
    if (!arguments_.quiet)
      streams_.err << fmt::format(
          "{}: {} x {} samples by {}, azimuth {:.1f} to {:.1f} m, {} {:.1f} to {:.1f} m, Doppler centroid {} Hz, "
          "{}{}\n",
          output().string(), image.azimuth.count, image.range.count, word_of(algorithm()), image.azimuth.first_m,
          last(image.azimuth), on_ground() ? "ground range" : "slant range", image.range.first_m, last(image.range),
          decimals(options_.doppler_centroid_hz, 1), core::duration_text(seconds),
          rows.on_disk ? " (worked on disk)" : "");
    if (!arguments_.quiet && motion_ != workflow::MotionOrder::none)
      streams_.err << fmt::format("  motion compensation of {} order: the antenna strays by up to {:.3g} m\n",
                                  to_string(motion_), strays_m_);
    if (!arguments_.quiet && arguments_.autofocus)
      streams_.err << fmt::format(
          "  autofocus {} {:.3g} rad rms, in pieces of {:.4g} m: entropy {:.3f} before, {:.3f} after{}\n",
          autofocus_.applied ? "took out" : "would take out", autofocus_.rms_rad, autofocus_.piece_m,
          autofocus_.entropy_before, autofocus_.entropy_after,
          autofocus_.applied ? "" : "; the image is left as it was, which is sharper");
    if (!arguments_.json) return;
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("source", arguments_.input.path);
    json.key("files").begin_array();
    for (const fs::path& path : outputs()) json.value(path.string());
    json.end_array().member("algorithm", word_of(algorithm()));
    json.member("rows", image.azimuth.count).member("columns", image.range.count);
    json.member("azimuth_first_m", image.azimuth.first_m).member("azimuth_step_m", image.azimuth.step_m);
    json.member("range_first_m", image.range.first_m).member("range_step_m", image.range.step_m);
    json.member("doppler_centroid_hz", options_.doppler_centroid_hz);
    json.member("range_window", signal::to_string(options_.range_window));
    json.member("azimuth_window", signal::to_string(options_.azimuth_window));
    json.member("motion_compensation", to_string(motion_)).key("autofocus");
    write_autofocus(json);
    json.member("on_disk", rows.on_disk).member("seconds", seconds).key("problems");
    write_json(json, input_.problems);
    json.end_object();
    write_out(streams_, json.text());
    flush_out(streams_);
  }

  void write_autofocus(core::JsonWriter& json) const {
    if (!arguments_.autofocus) {
      json.null();
      return;
    }
    json.begin_object()
        .member("applied", autofocus_.applied)
        .member("piece_m", autofocus_.piece_m)
        .member("rms_rad", autofocus_.rms_rad);
    json.member("entropy_before", autofocus_.entropy_before).member("entropy_after", autofocus_.entropy_after);
    json.end_object();
  }

  const FocusArguments& arguments_;
  Streams& streams_;
  core::WorkControl control_;
  workflow::FocusInput input_;
  signal::FocusOptions options_;
  std::optional<double> given_centroid_hz_;
  bool centroid_is_measured_ = false;
  workflow::MotionOrder motion_ = workflow::MotionOrder::none;
  double strays_m_ = 0.0;  // from the straight line, before compensation
  workflow::AutofocusFinding autofocus_;
};

}  // namespace

Action add_focus(CLI::App& app) {
  auto arguments = std::make_shared<FocusArguments>();
  add_text(app, "input", arguments->input.path, "SCENE|DATA", "script to simulate and focus, or file of samples")
      ->required();
  add_focus_arguments(app, *arguments);
  add_examples(app, {{"sarsim focus sar_r.scr", "simulate and focus: sar_r.img with its header sar_r.hdr"},
                     {"sarsim focus sim1.h5 --window taylor:35:5", "a recording, with lower sidelobes"},
                     {"sarsim focus sim1.bin --script scene.scr --out image.npy", "a file that carries no script"},
                     {"sarsim focus flight.h5 --autofocus --autofocus-phase phase.csv", "with phase errors taken out"},
                     {"sarsim focus sar_r.scr --algorithm back-projection --grid ground", "onto level ground"},
                     {"sarsim focus big.h5 --memory 500M --scratch /data", "in less memory than the image"}});
  return [arguments](Streams& streams) { return FocusRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
