#include "workflow/stepped/isar.hpp"

#include <algorithm>
#include <complex>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"
#include "workflow/stepped/stepped_input.hpp"
#include "workflow/stepped/velocity_choice.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

using Algorithm = IsarOptions::Algorithm;
using Motion = IsarOptions::Motion;

fs::path output_of(const IsarRequest& request) {
  if (!request.output.empty()) return request.output;
  return fs::path(request.input.path).stem().string() + "-isar.img";
}

// Options that make sense together; the platform is not known yet.
IsarOptions isar_options(const IsarRequest& request) {
  IsarOptions options = request.options;
  if (options.algorithm == Algorithm::back_projection &&
      (options.motion == Motion::estimated || options.turn_rate_radps))
    throw core::InvalidRequest("back-projection needs the path of the target from the scene",
                               "leave out --motion estimated and --turn-rate, or choose --algorithm range-doppler");
  if (options.turn_rate_radps && *options.turn_rate_radps == 0.0)
    throw core::InvalidRequest("--turn-rate: without rotation there is no cross-range resolution");
  expect_speed(options.fastest_mps);
  if (options.oversampling == 0)
    throw core::InvalidRequest("--oversampling: a resolution cell needs a pixel", "1 or more");
  options.autofocus = options.autofocus || options.motion == Motion::estimated;
  expect_image_ending(output_of(request), "--out");
  expect_no_sicd(output_of(request), "--out");
  if (request.magnitude && !is_envi(output_of(request)))
    throw core::InvalidRequest("--magnitude makes ENVI images", "name the output .img");
  return options;
}

// The platform of that name, or the one with the strongest targets.
std::size_t platform_of_name(const std::string& name, const simulate::Acquisition& acquisition) {
  if (name.empty()) {
    if (const auto strongest = platform_of_targets(acquisition)) return *strongest;
    throw core::InvalidRequest("no target is on a platform of its own", "name the target's platform with --platform");
  }
  const auto& platforms = acquisition.scene->platforms;
  const auto found = std::ranges::find_if(
      platforms, [&](const simulate::ResolvedPlatform& p) { return core::equal_ignoring_case(p.name, name); });
  if (found == platforms.end()) {
    std::vector<std::string> names;
    names.reserve(platforms.size());
    for (const simulate::ResolvedPlatform& platform : platforms) names.push_back(platform.name);
    const std::string near = core::nearest_word(name, names);
    throw core::InvalidRequest(fmt::format("--platform: the scene has no platform '{}'", name),
                               near.empty() ? "" : fmt::format("did you mean '{}'?", near));
  }
  const auto index = static_cast<std::size_t>(found - platforms.begin());
  if (index == acquisition.link.platform)
    throw core::InvalidRequest(fmt::format("--platform: '{}' carries the radar itself", found->name),
                               "name the platform of the target");
  return index;
}

// One run, from its input to the files of its images.
class IsarRun {
 public:
  IsarRun(const IsarRequest& request, const core::Observer& observer)
      : request_(request), observer_(observer), control_(observer.control(core::thread_count(request.threads))) {}

  IsarReport run() {
    const double begin_s = core::now_s();
    options_ = isar_options(request_);
    input_ = open_stepped_input(request_.input, SteppedUse::isar, control_);
    if (options_.motion == Motion::estimated) expect_searchable(options_.fastest_mps, input_.rows);
    options_.platform = platform_of_name(request_.platform, *input_.rows.acquisition);
    cut_bursts();
    expect_free_outputs(outputs(), {input_.sources, request_.replace, "--out"});
    find_problems();
    IsarReport report;
    for (std::size_t i = 0; i < firsts_.size(); ++i) {
      report.images.push_back(made(i));
      const core::Problems& losses = report.images.back().image.losses;
      observer_.remarks(losses);
      core::append(input_.problems, losses);
    }
    report.source = request_.input.path;
    report.simulation = input_.simulation;
    report.algorithm = algorithm();
    report.files = outputs();
    report.problems = std::move(input_.problems);
    report.seconds = core::now_s() - begin_s;
    return report;
  }

 private:
  [[nodiscard]] const char* algorithm() const {
    return options_.algorithm == Algorithm::range_doppler ? "isar-range-doppler" : "isar-back-projection";
  }

  // Bursts of each image.
  void cut_bursts() {
    const std::size_t all = input_.rows.bursts;
    count_ = request_.bursts.value_or(all);
    const std::size_t step = request_.step > 0 ? request_.step : count_;
    if (count_ < 2 || count_ > all)
      throw core::InvalidRequest(
          fmt::format("an image takes 2 to {} bursts (all that are recorded), not {}", all, count_),
          "choose other --bursts, or record for longer");
    for (std::size_t first = 0; first + count_ <= all; first += step) firsts_.push_back(first);
  }

  // NAME.img, or NAME-1.img, NAME-2.img ... of several images.
  [[nodiscard]] fs::path output(std::size_t index) const {
    fs::path path = output_of(request_);
    if (firsts_.size() == 1) return path;
    return path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string());
  }

  [[nodiscard]] bool keeps() const { return request_.keep && request_.output.empty(); }

  [[nodiscard]] std::vector<fs::path> outputs() const {
    std::vector<fs::path> paths;
    if (keeps()) return paths;
    for (std::size_t i = 0; i < firsts_.size(); ++i) {
      std::ranges::copy(files_of_image(output(i)), std::back_inserter(paths));
      if (request_.magnitude) std::ranges::copy(files_of_image(magnitude_path(output(i))), std::back_inserter(paths));
    }
    return paths;
  }

  void find_problems() {
    core::Problems& problems = input_.problems;
    core::append(problems, diagnose_isar(input_.rows, firsts_, count_, options_, control_));
    problems = core::ranked(std::move(problems));
    if (core::has_errors(problems)) throw core::InvalidRequest(problems);
    observer_.remarks(problems);
  }

  [[nodiscard]] WrittenIsarImage made(std::size_t index) const {
    const fs::path path = output(index);
    IsarImage image =
        make_isar_image(input_.rows, firsts_[index], count_, options_, control_, observer_.stage(path.string()));
    std::vector<std::complex<float>> values = std::exchange(image.image.values, {});
    const auto pixels = std::make_shared<signal::FocusedImage>(image.image);
    pixels->values = std::move(values);
    signal::FocusedRows rows = signal::rows_of(pixels);
    // Rows of recordings have times: here, as many metres in a second.
    rows.image.frame.speed_mps = 1.0;
    WrittenIsarImage written{path, firsts_[index], count_, std::move(image)};
    if (keeps())
      written.kept = in_memory_image(rows, origin());
    else
      write(rows, path);
    return written;
  }

  [[nodiscard]] ImageOrigin origin() const {
    signal::FocusOptions focus;
    focus.range_window = options_.range_window;
    focus.azimuth_window = options_.azimuth_window;
    const simulate::Acquisition& acquisition = *input_.rows.acquisition;
    ImageOrigin origin{request_.input.path,
                       request_.input.script,
                       words_of_overrides(request_.input.overrides),
                       input_.simulation,
                       algorithm(),
                       focus,
                       "none",
                       acquisition.link.name,
                       acquisition.scene->options,
                       std::nullopt};
    if (request_.input.dataset.empty()) origin.recording = input_.recording;
    return origin;
  }

  void write(const signal::FocusedRows& rows, const fs::path& path) const {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    write_image(rows, origin(), path, request_.replace, false, observer_.stop);
    if (request_.magnitude) write_image(rows, origin(), magnitude_path(path), request_.replace, true, observer_.stop);
  }

  const IsarRequest& request_;
  const core::Observer& observer_;
  core::WorkControl control_;
  IsarOptions options_;
  SteppedInput input_;
  std::size_t count_ = 0;
  std::vector<std::size_t> firsts_;
};

}  // namespace

core::Problems diagnose_isar(const SteppedRows& rows, const std::vector<std::size_t>& firsts, std::size_t count,
                             const IsarOptions& options, const core::WorkControl& control) {
  core::Problems problems;
  for (const std::size_t first : firsts) {
    if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
    core::append(problems, plan_isar_image(rows, first, count, options).problems);
  }
  core::append(problems, diagnose_stepped(rows, SteppedUse::isar, {}));
  return problems;
}

IsarReport isar(const IsarRequest& request, const core::Observer& observer) { return IsarRun(request, observer).run(); }

}  // namespace sarsim::workflow
