#include "workflow/sweep/post_processing.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "core/hash/fnv1a.hpp"
#include "core/maths/decibels.hpp"
#include "core/maths/rounding.hpp"
#include "core/os/free_memory.hpp"
#include "core/report/invalid_request.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/focus/measure.hpp"
#include "workflow/image/image_output.hpp"
#include "workflow/options/option_words.hpp"
#include "workflow/search/search.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/stepped/profiles.hpp"
#include "workflow/stepped/profiles_options.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// Collects figures under their names.
class Figures {
 public:
  void add(const std::string& name, double value) {
    constexpr int digits = 10;
    all_.push_back({name, std::isfinite(value) ? core::tidy(value, digits) : value});
  }
  // Of a target.
  void add(std::size_t target, const char* name, double value) {
    add(fmt::format("target{}_{}", target + 1, name), value);
  }
  [[nodiscard]] std::vector<SweepFigure> take() && { return std::move(all_); }

 private:
  std::vector<SweepFigure> all_;
};

double number(std::size_t count) { return static_cast<double>(count); }

GivenWords words_of(const PostProcessing& post_processing) {
  switch (post_processing.kind) {
    case PostProcessing::Kind::focus:
      return given_words(focus_option_table().options(), words_of_line(post_processing.words));
    case PostProcessing::Kind::search:
      return given_words(search_option_table().options(), words_of_line(post_processing.words));
    case PostProcessing::Kind::profiles:
      return given_words(profiles_option_table().options(), words_of_line(post_processing.words));
    case PostProcessing::Kind::none: break;
  }
  return {};
}

void add_target(Figures& figures, const MeasuredTarget& target) {
  const std::size_t t = target.theory.target;
  const signal::PointResponse* const peak = target.response();
  const auto add = [&](const char* name, auto value) { figures.add(t, name, peak != nullptr ? value() : no_number); };
  figures.add(t, "found", target.found ? 1.0 : 0.0);
  add("azimuth_error_m", [&] { return peak->place.azimuth_m - target.theory.place.azimuth_m; });
  add("range_error_m", [&] { return peak->place.range_m - target.theory.place.range_m; });
  add("amplitude_v", [&] { return peak->amplitude; });
  add("amplitude_error_db", [&] { return target.amplitude_error_db(); });
  add("phase_error_rad", [&] { return target.phase_error_rad(); });
  add("snr_db", [&] { return target.snr_db(); });
  add("azimuth_width_m", [&] { return peak->azimuth.width; });
  add("azimuth_pslr_db", [&] { return peak->azimuth.pslr_db; });
  add("range_width_m", [&] { return peak->range.width; });
  add("range_pslr_db", [&] { return peak->range.pslr_db; });
}

void add_measured(Figures& figures, const MeasureReport& report) {
  const MeasureSummary summary = summary_of(report);
  const bool any = summary.found > 0;
  figures.add("targets", number(summary.expected));
  figures.add("found", number(summary.found));
  figures.add("farthest_m", any ? summary.farthest_m : no_number);
  figures.add("lowest_amplitude_error_db", any ? summary.lowest_amplitude_db : no_number);
  figures.add("highest_amplitude_error_db", any ? summary.highest_amplitude_db : no_number);
  figures.add("lowest_snr_db", any ? summary.lowest_snr_db : no_number);
  if (report.targets.size() > max_followed_targets) return;
  for (const MeasuredTarget& target : report.targets) add_target(figures, target);
}

PostProcessed followed_by_focus(const PostProcessing& post_processing, const FollowedRecording& recording,
                                const core::Observer& observer) {
  FocusRequest request = focus_request(recording.input.path, words_of(post_processing));
  request.input = recording.input;
  request.output = recording.stem.string() + ".img";
  request.threads = recording.threads;
  request.force = recording.replace;
  if (!request.memory_bytes)
    if (const auto free_bytes = core::free_memory_bytes()) request.memory_bytes = *free_bytes / 2 / recording.sharers;
  const FocusReport image = focus(request, observer);
  PostProcessed followed{{}, image.problems};
  Figures figures;
  figures.add("image_rows", number(image.image.image.azimuth.count));
  figures.add("image_columns", number(image.image.image.range.count));
  figures.add("doppler_centroid_hz", image.options.doppler_centroid_hz);
  if (image.autofocus) {
    figures.add("autofocus_applied", image.autofocus->applied ? 1.0 : 0.0);
    figures.add("entropy_before", image.autofocus->entropy_before);
    figures.add("entropy_after", image.autofocus->entropy_after);
  }
  if (post_processing.measure) {
    MeasureRequest measured;
    measured.image = request.output;
    if (recording.input.held)  // No file leads back to it.
      measured.kept = std::make_shared<const InMemoryImage>(in_memory_image(image));
    measured.threads = recording.threads;
    const MeasureReport report = measure(measured, observer);
    add_measured(figures, report);
    core::append(followed.remarks, report.problems);
  }
  followed.figures = std::move(figures).take();
  return followed;
}

PostProcessed followed_by_search(const PostProcessing& post_processing, const FollowedRecording& recording,
                                 const core::Observer& observer) {
  SearchRequest request = search_request(recording.input.path, words_of(post_processing));
  request.input = recording.input;
  request.output = recording.stem.string() + "-ppi.img";
  request.threads = recording.threads;
  request.replace = recording.replace;
  const SearchReport report = search(request, observer);
  Figures figures;
  figures.add("intervals", number(report.intervals));
  figures.add("detections", number(report.detections));
  figures.add("expected_false_alarms", report.expected_false_alarms);
  if (report.findings.size() <= max_followed_targets)
    for (const TargetFinding& finding : report.findings) {
      figures.add(finding.target, "intervals_expected", finding.probability ? number(finding.expected) : no_number);
      figures.add(finding.target, "intervals_found", number(finding.found));
      figures.add(finding.target, "probability", finding.probability.value_or(no_number));
      figures.add(finding.target, "snr_db", finding.best ? core::power_db(finding.best->snr) : no_number);
      figures.add(finding.target, "range_error_m", finding.best ? finding.best_range_error_m : no_number);
    }
  return {std::move(figures).take(), report.problems};
}

PostProcessed followed_by_profiles(const PostProcessing& post_processing, const FollowedRecording& recording,
                                   const core::Observer& observer) {
  ProfilesRequest request = profiles_request(recording.input.path, words_of(post_processing));
  request.input = recording.input;
  request.output = recording.stem.string() + "-profiles.img";
  request.threads = recording.threads;
  request.replace = recording.replace;
  const ProfilesReport report = profiles(request, observer);
  Figures figures;
  figures.add("profiles", number(report.series.rows.size()));
  figures.add("scans", number(report.series.scans.size()));
  if (!report.series.scans.empty()) figures.add("compensated_speed_mps", report.series.scans.front().speed_mps);
  if (report.targets.size() <= max_followed_targets)
    for (const HeldTarget& target : report.targets) {
      const std::size_t t = target.truth.target;
      figures.add(t, "range_error_m", target.found ? target.found->range_m - target.expected_m : no_number);
      figures.add(t, "width_m", target.found ? target.found->width_m : no_number);
      figures.add(t, "amplitude_error_db",
                  target.found ? core::amplitude_db(target.found->amplitude / target.truth.amplitude) : no_number);
    }
  return {std::move(figures).take(), report.problems};
}

}  // namespace

std::string mark_of(const PostProcessing& post_processing) {
  const std::uint64_t hash = core::fnv1a(fmt::format("{} {}", post_processing.measure, post_processing.words));
  return fmt::format("{}-{:016x}", word_of(post_processing.kind), hash);
}

std::vector<fs::path> files_read_by(const PostProcessing& post_processing) {
  std::vector<fs::path> files;
  const GivenWords words = words_of(post_processing);
  const auto [first, last] = words.equal_range("--navigation");
  for (auto word = first; word != last; ++word) files.emplace_back(word->second);
  return files;
}

const char* word_of(PostProcessing::Kind kind) {
  switch (kind) {
    case PostProcessing::Kind::focus: return "focus";
    case PostProcessing::Kind::search: return "search";
    case PostProcessing::Kind::profiles: return "profiles";
    case PostProcessing::Kind::none: break;
  }
  return "none";
}

void validate(const PostProcessing& post_processing) {
  if (post_processing.measure && post_processing.kind != PostProcessing::Kind::focus)
    throw core::InvalidRequest("--measure measures images", "add --focus");
  if (!post_processing) {
    if (!post_processing.words.empty())
      throw core::InvalidRequest("--with gives options of --focus, --search or --profiles", "add one of them");
    return;
  }
  const GivenWords words = words_of(post_processing);
  for (const char* option :
       {"--out", "--detections", "--threads", "--script", "--simulation", "--set", "--targets", "--seed", "--profile",
        "--pulse", "--tolerance", "--force", "--magnitude", "--autofocus-phase"})
    if (words.contains(option))
      throw core::InvalidRequest(fmt::format("--with: the sweep decides {}", option),
                                 "leave it out of --with; give it to sweep itself if sweep has it");
  // What a request makes of the words.
  if (post_processing.kind == PostProcessing::Kind::focus) static_cast<void>(focus_request("x", words));
  if (post_processing.kind == PostProcessing::Kind::search) static_cast<void>(search_request("x", words));
  if (post_processing.kind == PostProcessing::Kind::profiles) static_cast<void>(profiles_request("x", words));
}

std::vector<fs::path> files_of(const PostProcessing& post_processing, const fs::path& stem) {
  const std::string name = stem.string();
  const GivenWords words = words_of(post_processing);
  std::vector<fs::path> files;
  switch (post_processing.kind) {
    case PostProcessing::Kind::focus: return files_of_image(name + ".img");
    case PostProcessing::Kind::search:
      if (!words.contains("--no-map")) files = files_of_image(name + "-ppi.img");
      if (!words.contains("--cfar") || words.find("--cfar")->second != "none")
        files.emplace_back(name + "-ppi-detections.csv");
      return files;
    case PostProcessing::Kind::profiles: return files_of_image(name + "-profiles.img");
    case PostProcessing::Kind::none: break;
  }
  return files;
}

PostProcessed follow(const PostProcessing& post_processing, const FollowedRecording& recording,
                     const core::StopFlag* stop) {
  core::Observer alone;  // Remarks are in the report.
  alone.stop = stop;
  switch (post_processing.kind) {
    case PostProcessing::Kind::focus: return followed_by_focus(post_processing, recording, alone);
    case PostProcessing::Kind::search: return followed_by_search(post_processing, recording, alone);
    case PostProcessing::Kind::profiles: return followed_by_profiles(post_processing, recording, alone);
    case PostProcessing::Kind::none: break;
  }
  return {};
}

}  // namespace sarsim::workflow
