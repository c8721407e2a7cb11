#include "workflow/search/pulse_pipeline.hpp"

#include <fmt/format.h>

#include "core/os/free_memory.hpp"
#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"
#include "workflow/search/search_checks.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

// What the machine has; without end where it does not say.
double memory_bytes() {
  const std::optional<std::uint64_t> bytes = core::machine_memory_bytes();
  return bytes ? static_cast<double>(*bytes) : 0x1p62;
}

}  // namespace

PulsePipeline::PulsePipeline(const PulseRequest& request, const core::Observer& observer, std::string suffix)
    : request_(request),
      observer_(observer),
      suffix_(std::move(suffix)),
      control_(observer.control(core::thread_count(request.threads))),
      begin_s_(core::now_s()) {}

fs::path PulsePipeline::output() const {
  if (!request_.output.empty()) return request_.output;
  return fs::path(request_.input.path).stem().string() + suffix_ + ".img";
}

fs::path PulsePipeline::table() const {
  if (!request_.table.empty()) return request_.table;
  return output().parent_path() / (output().stem().string() + "-detections.csv");
}

std::vector<fs::path> PulsePipeline::files() const {
  std::vector<fs::path> paths;
  if (request_.image && !keeps_image()) paths = files_of_image(output());
  if (options_.detect && !keeps_table()) paths.push_back(table());
  return paths;
}

void PulsePipeline::expect_free_files(const InputList& sources) const {
  const std::vector<fs::path> paths = files();
  if (request_.image) {
    expect_image_ending(output(), "--out");
    expect_no_sicd(output(), "--out");
  }
  if (!request_.image && !options_.detect)
    throw core::InvalidRequest("--no-map with --cfar none leaves nothing to do", "leave out one of them");
  expect_free_outputs(paths, {sources, request_.replace, "--out or --detections"});
}

void PulsePipeline::open(const std::function<std::size_t(const simulate::Acquisition&)>& usual_pulses,
                         const std::function<double(const PulseRows&)>& more_bytes) {
  options_.detect = request_.detect;
  expect_free_files(InputList::named(named_sources(request_.input)));
  input_ = open_pulse_input(request_.input, control_);
  expect_free_files(input_.sources);
  options_ = search_options(request_, acquisition(), usual_pulses(acquisition()));
  find_problems(more_bytes(rows()));
  for (const fs::path& path : files())
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
}

void PulsePipeline::find_problems(double more_bytes) {
  core::Problems& problems = input_.problems;
  core::append(problems, problems_of_search(acquisition(), options_));
  const double bytes = interval_bytes(options_, rows().pulses(), rows().samples()) + more_bytes;
  if (bytes > memory_bytes()) {
    problems.push_back(core::error("an interval and the picture do not fit into memory")
                           .found(core::bytes_text(bytes))
                           .expected("at most " + core::bytes_text(memory_bytes()))
                           .hint("take fewer pulses, frequencies or pixels at once"));
  }
  if (core::has_errors(problems)) throw core::InvalidRequest(core::ranked(std::move(problems)));
  core::append(problems, diagnose_search(acquisition(), options_, control_));
  problems = core::ranked(std::move(problems));
  observer_.remarks(problems);
}

void PulsePipeline::each(const std::string& stage, const SearchOptions& options,
                         const std::function<void(const SearchInterval&)>& consume) {
  each_interval(rows(), options, control_, observer_.stage(stage), consume);
}

void PulsePipeline::look_through(const std::string& stage, const std::function<void(const SearchInterval&)>& consume) {
  SearchOptions options = options_;
  options.detect = false;
  each(stage, options, consume);
}

void PulsePipeline::detect(const Placing& place, const std::function<void(const SearchInterval&)>& consume) {
  if (options_.detect && !options_.detector_known) {
    options_.cfar = detector_of(rows(), options_);
    options_.detector_known = true;
  }
  std::optional<DetectionTable> detections;
  if (options_.detect)
    detections.emplace(keeps_table() ? fs::path() : table(), request_.replace, doppler(), static_cast<bool>(place));
  SearchTargets targets(rows(), options_);
  each((request_.image ? output() : table()).string(), options_, [&](const SearchInterval& interval) {
    const auto of = targets.take(interval);
    for (std::size_t d = 0; d < of.size(); ++d) {
      const SearchDetection& detection = interval.detections[d];
      detections->append(detection, of[d], place ? place(interval, detection) : GroundPlace{});
    }
    consume(interval);
  });
  findings_ = targets.findings();
  if (!detections) return;
  detections->finish();
  detections_ = detections->count();
  if (keeps_table()) kept_table_ = detections->text();
}

PulseReport PulsePipeline::report() const {
  PulseReport report;
  report.source = request_.input.path;
  report.simulation = input_.simulation;
  report.files = files();
  report.options = options_;
  report.intervals = intervals();
  if (options_.detect) {
    if (!keeps_table()) report.table = table();
    report.kept_table = kept_table_;
    report.reference_cells = signal::reference_cells(options_.cfar, options_.rows(), rows().samples());
    report.independent_cells = static_cast<double>(report.reference_cells) * detector_of(rows(), options_).independence;
    report.detections = detections_;
    report.expected_false_alarms = options_.cfar.false_alarm * static_cast<double>(intervals()) *
                                   static_cast<double>(options_.rows()) * static_cast<double>(rows().samples());
  }
  report.findings = findings_;
  report.problems = input_.problems;
  report.seconds = core::now_s() - begin_s_;
  return report;
}

std::vector<std::pair<std::string, std::string>> PulsePipeline::origin_fields() const {
  return {{"source", request_.input.path},
          {"script", request_.input.script},
          {"settings", words_of_overrides(request_.input.overrides)},
          {"simulation", fmt::format("{}", input_.simulation + 1)},
          {"interval pulses", fmt::format("{}", options_.pulses)},
          {"interval step pulses", fmt::format("{}", options_.step_pulses())},
          {"window", signal::to_string(options_.window)},
          {"canceller pulses", fmt::format("{}", options_.canceller + 1)}};
}

}  // namespace sarsim::workflow
