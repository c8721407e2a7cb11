#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/focus_back_projection.hpp"
#include "cli/focus_input.hpp"
#include "cli/image_output.hpp"
#include "cli/options.hpp"
#include "cli/output_names.hpp"
#include "cli/progress_display.hpp"
#include "cli/report.hpp"
#include "simulate/sar_ghosts.hpp"
#include "simulate/sar_rows.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

enum class Algorithm { range_doppler, chirp_scaling, omega_k, back_projection };

struct FocusArguments {
  RecordingArguments input;
  std::string output;
  std::optional<Algorithm> algorithm;
  std::string window;
  std::string range_window;
  std::string azimuth_window;
  std::string centroid = "geometry";
  std::optional<double> bandwidth_hz;
  std::optional<std::int64_t> threads;
  std::string memory;
  std::string scratch;
  bool magnitude = false;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

const char* word_of(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::range_doppler: return "range-doppler";
    case Algorithm::chirp_scaling: return "chirp-scaling";
    case Algorithm::back_projection: return "back-projection";
    case Algorithm::omega_k: break;
  }
  return "omega-k";
}

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

SarWindow window_of(const std::string& option, const std::string& text) {
  if (text.empty()) return {};
  if (const auto window = window_from_text(text)) return *window;
  throw BadInput(fmt::format("{}: '{}' is no window", option, text),
                 "rectangular, hamming, hann, kaiser[:BETA] or taylor[:DB:NBAR]");
}

// Half of the memory that is free; 1 GiB where the system does not say.
std::size_t half_of_free_memory() {
  std::ifstream info("/proc/meminfo");
  std::string name;
  std::size_t kilobytes = 0;
  std::string unit;
  while (info >> name >> kilobytes) {
    std::getline(info, unit);
    if (name == "MemAvailable:") return kilobytes * 512;
  }
  return std::size_t{1} << 30;
}

// Bytes: a number with K, M, G or T (of 1024) behind it.
std::size_t memory_of(const std::string& text) {
  if (text.empty()) return half_of_free_memory();
  static constexpr std::string_view units = "KMGT";
  std::string number = text;
  double scale = 1.0;
  if (number.back() == 'B' || number.back() == 'b') number.pop_back();
  const char unit = number.empty() ? '\0' : static_cast<char>(std::toupper(static_cast<unsigned char>(number.back())));
  if (const std::size_t power = units.find(unit); unit != '\0' && power != std::string_view::npos) {
    scale = std::pow(1024.0, static_cast<double>(power) + 1.0);
    number.pop_back();
  }
  const auto value = parse_number(number);
  if (value && *value * scale >= 1048576.0 && *value * scale < 0x1p60) return static_cast<std::size_t>(*value * scale);
  throw BadInput(fmt::format("--memory: '{}' is no size", text), "give 1M or more, for instance 800M or 4G");
}

// One run of the command, from its input to the image's files.
class FocusRun {
 public:
  FocusRun(const FocusArguments& arguments, Streams& streams) : arguments_(arguments), streams_(streams) {
    control_ = {thread_count(static_cast<unsigned>(arguments.threads.value_or(0))), streams.stop};
  }

  ExitStatus run() {
    const double begin_s = now_s();
    const std::size_t memory = memory_of(arguments_.memory);
    read_windows();
    expect_free_outputs();
    input_ = open_focus_input(arguments_.input, control_);
    options_.memory_bytes = memory;
    options_.scratch_folder = arguments_.scratch;
    options_.doppler_bandwidth_hz = arguments_.bandwidth_hz.value_or(0.0);
    options_.doppler_centroid_hz = centroid_hz();
    find_problems();
    const FocusedRows image = focused();
    write(image);
    report(image, now_s() - begin_s);
    return exit_done;
  }

 private:
  void read_windows() {
    options_.range_window = window_of("--window", arguments_.window);
    options_.azimuth_window = options_.range_window;
    if (!arguments_.range_window.empty()) options_.range_window = window_of("--range-window", arguments_.range_window);
    if (!arguments_.azimuth_window.empty())
      options_.azimuth_window = window_of("--azimuth-window", arguments_.azimuth_window);
    if (algorithm() == Algorithm::range_doppler) options_.method = FocusMethod::range_doppler;
    if (algorithm() == Algorithm::chirp_scaling) options_.method = FocusMethod::chirp_scaling;
  }

  [[nodiscard]] Algorithm algorithm() const { return arguments_.algorithm.value_or(Algorithm::omega_k); }

  [[nodiscard]] fs::path output() const {
    if (!arguments_.output.empty()) return arguments_.output;
    return fs::path(arguments_.input.path).stem().string() + ".img";
  }

  [[nodiscard]] std::vector<fs::path> outputs() const {
    std::vector<fs::path> paths = files_of_image(output());
    if (arguments_.magnitude) std::ranges::copy(files_of_image(magnitude_path(output())), std::back_inserter(paths));
    return paths;
  }

  void expect_free_outputs() const {
    if (arguments_.magnitude && !is_envi(output()))
      throw BadInput("--magnitude makes ENVI images", "name the output .img");
    Problems problems;
    for (const fs::path& path : outputs())
      std::ranges::move(problems_of_output(path, arguments_.input.path, arguments_.force),
                        std::back_inserter(problems));
    if (!problems.empty()) throw BadInput(std::move(problems));
  }

  [[nodiscard]] double centroid_hz() const {
    const std::string& text = arguments_.centroid;
    if (const auto number = parse_number(text)) return *number;
    const bool measured = equal_ignoring_case(text, "measured");
    if (!measured && !equal_ignoring_case(text, "geometry"))
      throw BadInput(fmt::format("--doppler-centroid: '{}' is none", text), "geometry, measured or a number of Hz");
    if (has_errors(problems_of_focusing(input_.echoes, options_))) return 0.0;
    const double geometry_hz = geometric_doppler_centroid_hz(*input_.plan);
    return measured ? measured_doppler_centroid_hz(input_.echoes, geometry_hz, control_) : geometry_hz;
  }

  void find_problems() {
    Problems& problems = input_.problems;
    Problems found = problems_of_focusing(input_.echoes, options_);
    // Back projection takes any track: of evenness and straightness it needs neither.
    if (algorithm() == Algorithm::back_projection)
      std::erase_if(found, [](const Problem& problem) { return problem.subject.field == track_field; });
    std::ranges::move(found, std::back_inserter(problems));
    if (has_errors(problems)) throw BadInput(ranked(std::move(problems)));
    std::ranges::move(remarks_on_sar(*input_.plan, input_.echoes, options_.doppler_centroid_hz),
                      std::back_inserter(problems));
    problems = ranked(std::move(problems));
    if (!arguments_.quiet) print_problems(streams_, problems);
  }

  [[nodiscard]] FocusedRows focused() {
    ProgressDisplay display(streams_.err, style(), output().string());
    const auto progress = [&display](const Progress& p) { display.update(p); };
    if (algorithm() == Algorithm::back_projection) return back_projected(input_, options_, control_, progress);
    return focus_rows(input_.echoes, options_, control_, progress);
  }

  [[nodiscard]] ProgressDisplay::Style style() const {
    if (arguments_.quiet) return ProgressDisplay::Style::none;
    return streams_.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines;
  }

  void write(const FocusedRows& image) const {
    const ImageOrigin origin{arguments_.input.path, arguments_.input.script, input_.simulation, word_of(algorithm()),
                             options_};
    if (output().has_parent_path()) fs::create_directories(output().parent_path());
    write_image(image, origin, output(), arguments_.force, false, streams_.stop);
    if (arguments_.magnitude)
      write_image(image, origin, magnitude_path(output()), arguments_.force, true, streams_.stop);
  }

  void report(const FocusedRows& rows, double seconds) const {
    const FocusedImage& image = rows.image;
    const auto last = [](const ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); };
    if (!arguments_.quiet)
      streams_.err << fmt::format(
          "{}: {} x {} samples by {}, azimuth {:.1f} to {:.1f} m, {} {:.1f} to {:.1f} m, Doppler centroid {:.1f} Hz, "
          "{}{}\n",
          output().string(), image.azimuth.count, image.range.count, word_of(algorithm()), image.azimuth.first_m,
          last(image.azimuth), "slant range", image.range.first_m, last(image.range), options_.doppler_centroid_hz,
          duration_text(seconds), rows.on_disk ? " (worked on disk)" : "");
    if (!arguments_.json) return;
    JsonWriter json;
    json.begin_object().member("sarsim", program_version).member("source", arguments_.input.path);
    json.key("files").begin_array();
    for (const fs::path& path : outputs()) json.value(path.string());
    json.end_array().member("algorithm", word_of(algorithm()));
    json.member("rows", image.azimuth.count).member("columns", image.range.count);
    json.member("azimuth_first_m", image.azimuth.first_m).member("azimuth_step_m", image.azimuth.step_m);
    json.member("range_first_m", image.range.first_m).member("range_step_m", image.range.step_m);
    json.member("doppler_centroid_hz", options_.doppler_centroid_hz);
    json.member("range_window", to_string(options_.range_window));
    json.member("azimuth_window", to_string(options_.azimuth_window));
    json.member("on_disk", rows.on_disk).member("seconds", seconds).key("problems");
    write_json(json, input_.problems);
    json.end_object();
    write_out(streams_, json.text());
    flush_out(streams_);
  }

  const FocusArguments& arguments_;
  Streams& streams_;
  WorkControl control_;
  FocusInput input_;
  FocusOptions options_;
};

void add_focus_options(CLI::App& app, FocusArguments& a) {
  add_text(app, "--out", a.output, "OUT",
           "image to write: ENVI (.img, default), or .npy, .h5, .csv, .asc, .bin, .brk; default: the input's name");
  add_choice<Algorithm>(app, "--algorithm", a.algorithm,
                        {{"range-doppler", Algorithm::range_doppler},
                         {"chirp-scaling", Algorithm::chirp_scaling},
                         {"omega-k", Algorithm::omega_k},
                         {"back-projection", Algorithm::back_projection}},
                        "omega-k by default; back-projection for tracks that are not straight");
  add_text(app, "--window", a.window, "WINDOW",
           "over range and azimuth: rectangular (default), hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]");
  add_text(app, "--range-window", a.range_window, "WINDOW", "over range alone");
  add_text(app, "--azimuth-window", a.azimuth_window, "WINDOW", "over azimuth alone");
  add_text(app, "--doppler-centroid", a.centroid, "geometry|measured|HZ",
           "the middle of the Doppler band, as the geometry has it (default), measured, or given");
  add_real(app, "--doppler-bandwidth", a.bandwidth_hz, "HZ", "band to keep about the centroid (default: all)");
  add_recording_arguments(app, a.input);
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  add_text(app, "--memory", a.memory, "SIZE",
           "memory to work in, as 800M or 4G (default: half of what is free); more goes to disk");
  add_text(app, "--scratch", a.scratch, "DIR", "where on disk (default: the system's folder for temporary files)");
  app.add_flag("--magnitude", a.magnitude, "also an ENVI image of magnitudes, NAME-magnitude.img");
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

}  // namespace

Action add_focus(CLI::App& app) {
  auto arguments = std::make_shared<FocusArguments>();
  add_text(app, "input", arguments->input.path, "SCENE|DATA", "script to simulate and focus, or file of samples")
      ->required();
  add_focus_options(app, *arguments);
  add_examples(app, {{"sarsim focus sar_r.scr", "simulate and focus: sar_r.img with its header sar_r.hdr"},
                     {"sarsim focus sim1.h5 --window taylor:35:5", "a recording, with lower sidelobes"},
                     {"sarsim focus sim1.bin --script scene.scr --out image.npy", "a file that carries no script"},
                     {"sarsim focus big.h5 --memory 500M --scratch /data", "in less memory than the image"}});
  return [arguments](Streams& streams) { return FocusRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
