#include "workflow/stepped/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "radar/path/path.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/input/override_words.hpp"
#include "workflow/stepped/profile_output.hpp"
#include "workflow/stepped/stepped_input.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

std::string stretch_text(const RangeResampling& ranges) {
  const auto to_millimetres = [](double range_m) { return core::format_number(std::round(range_m * 1e3) / 1e3); };
  return fmt::format("{} m to {} m", to_millimetres(ranges.from_m), to_millimetres(ranges.to_m));
}

// The script's window is not known yet.
SeriesOptions series_options(const ProfilesRequest& request) {
  SeriesOptions options;
  options.velocity = request.velocity.velocity;
  options.speed_mps = request.velocity.speed_mps;
  options.fastest_mps = request.fastest_mps;
  expect_speed(options.fastest_mps);
  if (request.window)
    options.window = [weight = signal::weight_of(*request.window)](double x) { return weight(x - 0.5); };
  options.from_m = request.from_m;
  options.to_m = request.to_m;
  options.oversampling = request.oversampling;
  if (options.oversampling == 0)
    throw core::InvalidRequest("--oversampling: a resolution cell needs a bin", "1 or more");
  if (!(request.illumination_db >= 0.0)) throw core::InvalidRequest("--illumination must not be negative");
  options.illuminated_share = std::pow(10.0, -0.1 * request.illumination_db);
  const bool compensated = options.velocity != SeriesOptions::Velocity::none;
  // A mean of profiles in which the target is elsewhere would be of no use.
  options.align = request.align || (request.set != ProfileGrouping::bursts && compensated);
  if (options.align && !compensated)
    throw core::InvalidRequest("--align moves profiles by the speed that is compensated, but there is none",
                               "give --velocity scene, estimated or a number");
  return options;
}

// What of the script's window is not in the recording, where the user did not choose ranges.
void remark_on_window(SteppedInput& input, const SeriesOptions& options, const RangeResampling& shown) {
  const RangeResampling window{input.rows.from_m, input.rows.to_m};
  const bool short_begin = !options.from_m && shown.from_m > window.from_m;
  const bool short_end = !options.to_m && shown.to_m < window.to_m;
  if (!short_begin && !short_end) return;
  input.problems.push_back(
      core::note("profiles.window-not-shown",
                 "the recorded samples do not show all of the script's window: profiles end where the recording ends")
          .found(stretch_text(shown))
          .expected(stretch_text(window))
          .hint("to see the rest, simulate the script, or record a longer window"));
}

void expect_ranges(SteppedInput& input, const SeriesOptions& options) {
  const RangeResampling shown = shown_ranges(input.rows);
  if (!(shown.to_m > shown.from_m))
    throw core::InvalidRequest("the recording is too short: no range of the script's window has half of its echo in it",
                               "record a longer range window");
  const double from_m = options.from_m.value_or(shown.from_m);
  const double to_m = options.to_m.value_or(shown.to_m);
  const std::string recorded = stretch_text(shown);
  const std::string hint = fmt::format("the recording reaches from {}; see --from and --to", recorded);
  if (!(to_m > from_m))
    throw core::InvalidRequest(fmt::format("the range {} is empty", stretch_text({from_m, to_m})), hint);
  if (to_m <= shown.from_m || from_m >= shown.to_m)
    throw core::InvalidRequest(fmt::format("nothing was recorded from {}", stretch_text({from_m, to_m})), hint);
  const double bins = (to_m - from_m) /
                      (radar::range_of_cycle(input.rows.band->band_hz(), input.rows.band->waveform().light_speed_mps) /
                       static_cast<double>(options.oversampling));
  constexpr double max_bins = 0x1p26;
  if (bins > max_bins)
    throw core::InvalidRequest(fmt::format("a profile of {:.3g} bins cannot be held", bins),
                               "choose fewer ranges with --from and --to, or less --oversampling");
  if (from_m < shown.from_m || to_m > shown.to_m)
    input.problems.push_back(
        core::warning("profiles.ranges-not-recorded",
                      "the ranges go beyond those that were recorded: the profiles are empty there")
            .found(stretch_text({from_m, to_m}))
            .expected(recorded));
  else
    remark_on_window(input, options, shown);
}

void find_problems(SteppedInput& input, const SeriesOptions& options) {
  core::append(input.problems, diagnose_profiles(input.rows, {options.velocity, options.speed_mps}));
  input.problems = core::ranked(std::move(input.problems));
}

// The row that is compared with the scene.
std::size_t held_row_of(const ProfileSeries& series, std::optional<std::size_t> burst, std::size_t bursts) {
  if (!burst) return typical_row(series);
  const auto found = std::ranges::find(series.rows, *burst, &ProfileRow::burst);
  if (found == series.rows.end())
    throw core::InvalidRequest(fmt::format("--burst: burst {} is not illuminated", *burst + 1),
                               fmt::format("the recording has {} bursts; illuminated are {} to {}", bursts,
                                           series.rows.front().burst + 1, series.rows.back().burst + 1));
  return static_cast<std::size_t>(found - series.rows.begin());
}

std::string window_words_of(const ProfilesRequest& request) {
  return request.window ? signal::to_string(*request.window) : "of the script";
}

// Nothing is written where it is kept.
bool keeps(const ProfilesRequest& request) { return request.keep && request.output.empty(); }

// Profiles as they are asked for, written or kept.
std::optional<InMemoryImage> made_set(const ProfileSeries& series, const SteppedInput& input,
                                      const ProfilesRequest& request, const fs::path& output,
                                      const core::StopFlag* stop) {
  ProfileOrigin origin{request.input.path,
                       request.input.script,
                       words_of_overrides(request.input.overrides),
                       input.simulation,
                       word_of(request.set),
                       request.velocity.words,
                       window_words_of(request),
                       input.rows.band->waveform().light_speed_mps,
                       {},
                       input.rows.acquisition->link.name,
                       input.rows.acquisition->scene->options};
  if (!keeps(request) && output.has_parent_path()) fs::create_directories(output.parent_path());
  const auto write = [&](const ProfileSeries& made) -> std::optional<InMemoryImage> {
    origin.aspects_rad = aspects_rad(input.rows, made);
    if (keeps(request)) return kept_profiles(made, origin);
    write_profiles(made, origin, output, request.replace, stop);
    return std::nullopt;
  };
  switch (request.set) {
    case ProfileGrouping::bursts: return write(series);
    case ProfileGrouping::scans: return write(mean_of_scans(series));
    case ProfileGrouping::encounter: return write(mean_of_encounter(series));
  }
  return std::nullopt;
}

SteppedInput input_of_profiles(const ProfilesRequest& request, const fs::path& output,
                               const core::WorkControl& control) {
  const auto expect_free = [&](const InputList& sources) {
    if (keeps(request)) return;
    expect_free_outputs(files_of_profiles(output), {sources, request.replace, "--out"});
  };
  expect_free(InputList::named(named_sources(request.input)));
  SteppedInput input = open_stepped_input(request.input, SteppedUse::profiles, control);
  expect_free(input.sources);
  return input;
}

}  // namespace

const char* word_of(ProfileGrouping grouping) {
  switch (grouping) {
    case ProfileGrouping::scans: return "scans";
    case ProfileGrouping::encounter: return "encounter";
    case ProfileGrouping::bursts: break;
  }
  return "bursts";
}

core::Problems diagnose_profiles(const SteppedRows& rows, const VelocityChoice& velocity) {
  std::optional<double> speed_mps;
  if (velocity.velocity == SeriesOptions::Velocity::given) speed_mps = velocity.speed_mps;
  if (velocity.velocity == SeriesOptions::Velocity::scene || velocity.velocity == SeriesOptions::Velocity::estimated)
    speed_mps = mean_speed_mps(rows, rows.bursts / 2, 1);
  return diagnose_stepped(rows, SteppedUse::profiles, speed_mps);
}

ProfilesReport profiles(const ProfilesRequest& request, const core::Observer& observer) {
  const double begin_s = core::now_s();
  const core::WorkControl control = observer.control(core::thread_count(request.threads));
  SeriesOptions options = series_options(request);
  ProfilesReport report;
  report.output = request.output.empty() ? fs::path(fs::path(request.input.path).stem().string() + "-profiles.img")
                                         : request.output;
  SteppedInput input = input_of_profiles(request, report.output, control);
  if (!request.window) options.window = input.rows.acquisition->link.window;
  expect_ranges(input, options);
  if (options.velocity == SeriesOptions::Velocity::estimated) expect_searchable(options.fastest_mps, input.rows);
  find_problems(input, options);
  observer.remarks(input.problems);
  report.series = make_profiles(input.rows, options, control, observer.stage(report.output.string()));
  if (report.series.rows.empty())
    throw core::InvalidRequest("no burst is illuminated: the targets give no echo",
                               "see sarsim check, and the beam of the script's radar");
  report.held_row = held_row_of(report.series, request.burst, input.rows.bursts);
  report.kept = made_set(report.series, input, request, report.output, observer.stop);
  report.source = request.input.path;
  report.simulation = input.simulation;
  if (!report.kept) report.files = files_of_profiles(report.output);
  report.set = request.set;
  report.velocity = options.velocity;
  report.bursts = input.rows.bursts;
  report.targets = hold_against_scene(input.rows, report.series, options, report.held_row);
  constexpr std::size_t max_peaks = 20;
  report.peaks = signal::highest_peaks(report.series.row(report.held_row), report.series.axis, max_peaks,
                                       report.series.limits.resolution_m, 0.03);
  report.problems = std::move(input.problems);
  report.seconds = core::now_s() - begin_s;
  return report;
}

}  // namespace sarsim::workflow
