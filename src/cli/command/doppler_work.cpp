#include "cli/command/doppler_work.hpp"

#include <algorithm>
#include <ostream>

#include <unistd.h>

#include <fmt/format.h>

#include "cli/command/image_output.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "core/build/version.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "workflow/search/search_checks.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

// What the machine has; without end where it does not say.
double memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long bytes = sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0 ? static_cast<double>(pages) * static_cast<double>(bytes) : 0x1p62;
}

}  // namespace

PulseWork::PulseWork(const SearchArguments& arguments, Streams& streams, std::string suffix)
    : arguments_(arguments),
      streams_(streams),
      suffix_(std::move(suffix)),
      control_{core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0))), streams.stop},
      begin_s_(core::now_s()) {}

fs::path PulseWork::output() const {
  if (!arguments_.output.empty()) return arguments_.output;
  return fs::path(arguments_.input.path).stem().string() + suffix_ + ".img";
}

fs::path PulseWork::table() const {
  if (!arguments_.detections.empty()) return arguments_.detections;
  return output().parent_path() / (output().stem().string() + "-detections.csv");
}

std::vector<fs::path> PulseWork::files() const {
  std::vector<fs::path> paths;
  if (!arguments_.no_map) paths = files_of_image(output());
  if (options_.detect) paths.push_back(table());
  return paths;
}

void PulseWork::expect_free_outputs(const std::vector<fs::path>& sources) const {
  const std::vector<fs::path> paths = files();
  if (paths.empty()) throw core::Refused("--no-map with --cfar none leaves nothing to do", "leave out one of them");
  cli::expect_free_outputs(paths, {sources, arguments_.force, "--out or --detections"});
}

void PulseWork::open(const std::function<std::size_t(const simulate::Plan&)>& usual_pulses,
                     const std::function<double(const workflow::PulseRows&)>& more_bytes) {
  options_.detect = arguments_.detector.value_or(Detector::cell_averaging) != Detector::none;
  expect_free_outputs(named_sources(arguments_.input));
  input_ = workflow::open_pulse_input(arguments_.input, control_);
  expect_free_outputs(input_.sources);
  options_ = search_options(arguments_, rows(), usual_pulses(plan()));
  find_problems(more_bytes(rows()));
  for (const fs::path& path : files())
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
}

void PulseWork::find_problems(double more_bytes) {
  core::Problems& problems = input_.problems;
  std::ranges::move(workflow::problems_of_search(plan(), options_), std::back_inserter(problems));
  const double bytes = workflow::interval_bytes(options_, rows().pulses(), rows().samples()) + more_bytes;
  if (bytes > memory_bytes()) {
    core::Problem problem;
    problem.message = "an interval and the picture do not fit into memory";
    problem.found = core::bytes_text(bytes);
    problem.expected = "at most " + core::bytes_text(memory_bytes());
    problem.hint = "take fewer pulses, frequencies or pixels at once";
    problems.push_back(problem);
  }
  if (core::has_errors(problems)) throw core::Refused(core::ranked(std::move(problems)));
  std::ranges::move(workflow::remarks_on_search(plan(), options_, control_), std::back_inserter(problems));
  problems = core::ranked(std::move(problems));
  if (!arguments_.quiet) print_problems(streams_, problems);
}

void PulseWork::each(const std::string& label, const workflow::SearchOptions& options,
                     const std::function<void(const workflow::SearchInterval&)>& consume) {
  const auto style = arguments_.quiet    ? ProgressDisplay::Style::none
                     : streams_.terminal ? ProgressDisplay::Style::bar
                                         : ProgressDisplay::Style::lines;
  ProgressDisplay display(streams_.err, style, label);
  workflow::each_interval(
      rows(), options, control_, [&display](const core::Progress& p) { display.update(p); }, consume);
}

void PulseWork::look_through(const std::string& label,
                             const std::function<void(const workflow::SearchInterval&)>& consume) {
  workflow::SearchOptions options = options_;
  options.detect = false;
  each(label, options, consume);
}

void PulseWork::detect(const Placing& place, const std::function<void(const workflow::SearchInterval&)>& consume) {
  std::optional<DetectionTable> detections;
  if (options_.detect) detections.emplace(table(), arguments_.force, doppler(), static_cast<bool>(place));
  workflow::SearchTargets targets(rows(), options_);
  each(arguments_.no_map ? table().string() : output().string(), options_,
       [&](const workflow::SearchInterval& interval) {
         const auto of = targets.take(interval);
         for (std::size_t d = 0; d < of.size(); ++d) {
           const workflow::SearchDetection& detection = interval.detections[d];
           detections->append(detection, of[d], place ? place(interval, detection) : GroundPlace{});
         }
         consume(interval);
       });
  findings_ = targets.findings();
  if (!detections) return;
  detections->finish();
  detections_ = detections->count();
}

double PulseWork::expected_false_alarms() const {
  return options_.cfar.false_alarm * static_cast<double>(intervals()) * static_cast<double>(options_.rows()) *
         static_cast<double>(rows().samples());
}

void PulseWork::report(const std::string& image, const std::function<void(core::JsonWriter&)>& members) {
  if (!arguments_.quiet) {
    streams_.err << fmt::format("{}: {} of {}, {}{}\n", files().front().string(), counted(intervals(), "interval"),
                                counted(options_.pulses, "pulse"), image,
                                core::duration_text(core::now_s() - begin_s_));
    if (options_.detect)
      streams_.err << fmt::format("{}: {}; noise alone would put {:.3g} cells above their thresholds\n",
                                  table().string(), counted(detections_, "detection"), expected_false_alarms());
    streams_.err << findings_text(findings_, doppler());
  }
  if (arguments_.json) write_report(members);
}

void PulseWork::write_report(const std::function<void(core::JsonWriter&)>& members) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", arguments_.input.path);
  json.key("files").begin_array();
  for (const fs::path& path : files()) json.value(path.string());
  json.end_array().member("intervals", intervals()).key("interval");
  write_json(json, options_);
  members(json);
  json.key("detector");
  if (options_.detect) {
    const signal::CfarOptions& cfar = options_.cfar;
    json.begin_object().member("cfar", word_of(arguments_.detector.value_or(Detector::cell_averaging)));
    const std::size_t cells = signal::reference_cells(cfar, options_.rows(), rows().samples());
    json.member("false_alarm", cfar.false_alarm).member("reference_cells", cells);
    json.member("independent_cells", static_cast<double>(cells) * workflow::detector_of(rows(), options_).independence);
    json.member("detections", detections_).member("expected_false_alarms", expected_false_alarms()).end_object();
  } else {
    json.null();
  }
  json.key("targets");
  write_json(json, findings_, doppler());
  json.member("seconds", core::now_s() - begin_s_).key("problems");
  write_json(json, input_.problems);
  json.end_object();
  write_out(streams_, json.text());
  flush_out(streams_);
}

std::vector<std::pair<std::string, std::string>> PulseWork::origin_fields() const {
  return {{"source", arguments_.input.path},
          {"script", arguments_.input.script},
          {"simulation", fmt::format("{}", input_.simulation + 1)},
          {"interval pulses", fmt::format("{}", options_.pulses)},
          {"interval step pulses", fmt::format("{}", options_.step_pulses())},
          {"window", signal::to_string(options_.window)},
          {"canceller pulses", fmt::format("{}", options_.canceller + 1)}};
}

}  // namespace sarsim::cli
