#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/stepped_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/window_option.hpp"
#include "core/build/version.hpp"
#include "core/text/number_text.hpp"
#include "raster/table/formats.hpp"
#include "workflow/stepped/profile_output.hpp"
#include "workflow/stepped/stepped_input.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

enum class Set { bursts, scans, encounter };

struct ProfilesArguments {
  RecordingArguments input;
  std::string output;
  std::optional<Set> set;
  std::string velocity = "none";
  std::optional<double> fastest_mps;
  std::string window;
  std::optional<double> from_m;
  std::optional<double> to_m;
  std::optional<std::int64_t> oversampling;
  std::optional<double> illumination_db;
  std::optional<std::int64_t> burst;
  std::optional<std::int64_t> threads;
  bool align = false;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

const char* word_of(Set set) {
  switch (set) {
    case Set::scans: return "scans";
    case Set::encounter: return "encounter";
    case Set::bursts: break;
  }
  return "bursts";
}

// One run of the command, from its input to the files of profiles.
class ProfilesRun {
 public:
  ProfilesRun(const ProfilesArguments& arguments, Streams& streams) : arguments_(arguments), streams_(streams) {
    control_ = {core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0))), streams.stop};
  }

  ExitStatus run() {
    const auto begin = std::chrono::steady_clock::now();
    read_options();
    expect_free_outputs(named_sources(arguments_.input));
    input_ = workflow::open_stepped_input(arguments_.input, workflow::SteppedUse::profiles, control_);
    expect_free_outputs(input_.sources);
    if (arguments_.window.empty()) options_.window = input_.rows.plan->radar.window;
    expect_ranges();
    if (options_.velocity == workflow::SeriesOptions::Velocity::estimated)
      expect_searchable(options_.fastest_mps, input_.rows);
    find_problems();
    series_ = profiles();
    expect_scans();
    held_row_ = held_row();
    write();
    report(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return exit_done;
  }

 private:
  void read_options() {
    const VelocityChoice choice = velocity_choice(arguments_.velocity);
    options_.velocity = choice.velocity;
    options_.speed_mps = choice.speed_mps;
    options_.fastest_mps = arguments_.fastest_mps.value_or(options_.fastest_mps);
    if (!(options_.fastest_mps > 0.0 && options_.fastest_mps < 1e6))
      throw core::Refused(fmt::format("--fastest: {} m/s is out of range", options_.fastest_mps), "above 0, below 1e6");
    if (!arguments_.window.empty()) options_.window = window_function("--window", arguments_.window);
    options_.from_m = arguments_.from_m;
    options_.to_m = arguments_.to_m;
    options_.oversampling = static_cast<std::size_t>(arguments_.oversampling.value_or(4));
    const double decibels = arguments_.illumination_db.value_or(6.0);
    if (!(decibels >= 0.0)) throw core::Refused("--illumination: decibels below the strongest burst are not negative");
    options_.illuminated_share = std::pow(10.0, -0.1 * decibels);
    const bool compensated = options_.velocity != workflow::SeriesOptions::Velocity::none;
    // A mean of profiles in which the target is elsewhere would be of no use.
    options_.align = arguments_.align || (set() != Set::bursts && compensated);
    if (options_.align && !compensated)
      throw core::Refused("--align moves profiles by the speed that is compensated, but there is none",
                          "give --velocity scene, estimated or a number");
  }

  [[nodiscard]] Set set() const { return arguments_.set.value_or(Set::bursts); }

  [[nodiscard]] fs::path output() const {
    if (!arguments_.output.empty()) return arguments_.output;
    return fs::path(arguments_.input.path).stem().string() + "-profiles.img";
  }

  void expect_free_outputs(const std::vector<fs::path>& sources) const {
    cli::expect_free_outputs(workflow::files_of_profiles(output()), {sources, arguments_.force, "--out"});
  }

  void expect_ranges() {
    const workflow::RangeStretch shown = workflow::shown_ranges(input_.rows);
    if (!(shown.to_m > shown.from_m))
      throw core::Refused("the recording is too short: no range of the script's window has half of its echo in it",
                          "record a longer range window");
    const double from_m = options_.from_m.value_or(shown.from_m);
    const double to_m = options_.to_m.value_or(shown.to_m);
    const std::string recorded = stretch_text(shown);
    const std::string hint = fmt::format("the recording reaches from {}; see --from and --to", recorded);
    if (!(to_m > from_m))
      throw core::Refused(fmt::format("the ranges from {} are none", stretch_text({from_m, to_m})), hint);
    if (to_m <= shown.from_m || from_m >= shown.to_m)
      throw core::Refused(fmt::format("nothing was recorded from {}", stretch_text({from_m, to_m})), hint);
    const double bins = (to_m - from_m) / (0.5 * input_.rows.band->waveform().light_speed_mps /
                                           input_.rows.band->band_hz() / static_cast<double>(options_.oversampling));
    constexpr double most_bins = 0x1p26;
    if (bins > most_bins)
      throw core::Refused(fmt::format("a profile of {:.3g} bins cannot be held", bins),
                          "choose fewer ranges with --from and --to, or less --oversampling");
    if (from_m < shown.from_m || to_m > shown.to_m)
      input_.problems.push_back(core::problem_of(
          core::Severity::warning, "the ranges go beyond those that were recorded: the profiles are empty there",
          stretch_text({from_m, to_m}), recorded, {}));
    else
      remark_on_window(shown);
  }

  // What of the script's window is not in the recording, where the user did not choose ranges.
  void remark_on_window(const workflow::RangeStretch& shown) {
    const workflow::RangeStretch window{input_.rows.from_m, input_.rows.to_m};
    const bool short_begin = !options_.from_m && shown.from_m > window.from_m;
    const bool short_end = !options_.to_m && shown.to_m < window.to_m;
    if (!short_begin && !short_end) return;
    input_.problems.push_back(core::problem_of(
        core::Severity::note,
        "the recorded samples do not show all of the script's window: profiles end with what they show",
        stretch_text(shown), stretch_text(window), "to see the rest, simulate the script, or record a longer window"));
  }

  static std::string stretch_text(const workflow::RangeStretch& ranges) {
    const auto to_millimetres = [](double range_m) { return core::format_number(std::round(range_m * 1e3) / 1e3); };
    return fmt::format("{} m to {} m", to_millimetres(ranges.from_m), to_millimetres(ranges.to_m));
  }

  void find_problems() {
    std::optional<double> speed;
    if (options_.velocity == workflow::SeriesOptions::Velocity::given) speed = options_.speed_mps;
    if (options_.velocity == workflow::SeriesOptions::Velocity::scene ||
        options_.velocity == workflow::SeriesOptions::Velocity::estimated)
      speed = workflow::mean_speed_mps(input_.rows, input_.rows.bursts / 2, 1);
    std::ranges::move(workflow::remarks_on_stepped(input_.rows, workflow::SteppedUse::profiles, speed),
                      std::back_inserter(input_.problems));
    input_.problems = core::ranked(std::move(input_.problems));
    if (!arguments_.quiet) print_problems(streams_, input_.problems);
  }

  [[nodiscard]] workflow::ProfileSeries profiles() {
    ProgressDisplay display(streams_.err, display_style(streams_, arguments_.quiet), output().string());
    return workflow::make_profiles(input_.rows, options_, control_,
                                   [&display](const core::Progress& p) { display.update(p); });
  }

  void expect_scans() const {
    if (series_.rows.empty())
      throw core::Refused("no burst is illuminated: the targets give no echo",
                          "see sarsim check, and the beam of the script's radar");
  }

  void write() const {
    const workflow::ProfileOrigin origin{arguments_.input.path,
                                         arguments_.input.script,
                                         input_.simulation,
                                         word_of(set()),
                                         arguments_.velocity,
                                         arguments_.window.empty() ? "of the script" : arguments_.window,
                                         input_.rows.band->waveform().light_speed_mps,
                                         input_.rows.plan->radar.name,
                                         input_.rows.plan->scene->options};
    if (output().has_parent_path()) fs::create_directories(output().parent_path());
    if (set() == Set::bursts)
      return workflow::write_profiles(series_, origin, output(), arguments_.force, streams_.stop);
    const workflow::ProfileSeries means =
        set() == Set::scans ? workflow::mean_of_scans(series_) : workflow::mean_of_encounter(series_);
    workflow::write_profiles(means, origin, output(), arguments_.force, streams_.stop);
  }

  // The row that is held against the scene.
  [[nodiscard]] std::size_t held_row() const {
    if (!arguments_.burst) return workflow::typical_row(series_);
    const auto wanted = static_cast<std::size_t>(*arguments_.burst - 1);
    const auto found = std::ranges::find(series_.rows, wanted, &workflow::ProfileRow::burst);
    if (found == series_.rows.end())
      throw core::Refused(fmt::format("--burst: burst {} is not illuminated", wanted + 1),
                          fmt::format("the recording has {} bursts; illuminated are {} to {}", input_.rows.bursts,
                                      series_.rows.front().burst + 1, series_.rows.back().burst + 1));
    return static_cast<std::size_t>(found - series_.rows.begin());
  }

  void report(double seconds) const {
    const std::size_t row = held_row_;
    const std::vector<workflow::HeldTarget> targets = workflow::hold_against_scene(input_.rows, series_, options_, row);
    if (!arguments_.quiet) streams_.err << summary(seconds);
    if (arguments_.json)
      write_out(streams_, json_text(targets, row, seconds));
    else if (!arguments_.quiet)
      write_out(streams_, table(targets, row));
    flush_out(streams_);
  }

  [[nodiscard]] std::string summary(double seconds) const {
    const signal::ProfileAxis& axis = series_.axis;
    const signal::SteppedLimits& limits = series_.limits;
    std::string text = fmt::format(
        "{}: {} of {} bursts in {} scan{}, {} bins from {:.6g} to {:.6g} m, {:.3g} m apart, {}\n", output().string(),
        series_.rows.size(), input_.rows.bursts, series_.scans.size(), series_.scans.size() == 1 ? "" : "s", axis.count,
        axis.first_m, axis.at(static_cast<double>(axis.count) - 1.0), axis.step_m, core::duration_text(seconds));
    text += fmt::format(
        "band {} about {}: resolution {:.4g} m; steps repeat every {:.4g} m; speed shifts by {:.4g} m and smears over "
        "{:.4g} m for each m/s\n",
        core::with_prefix(series_.band_hz, "Hz", 4), core::with_prefix(series_.centre_hz, "Hz", 5), limits.resolution_m,
        limits.unambiguous_range_m, limits.shift_m_per_mps, limits.smear_m_per_mps);
    for (std::size_t s = 0; s < series_.scans.size(); ++s) {
      const workflow::ScanRecord& scan = series_.scans[s];
      text += fmt::format("scan {}: bursts {} to {}, {:.6g} to {:.6g} s", s + 1, scan.bursts.first + 1,
                          scan.bursts.last + 1, scan.from_s, scan.to_s);
      if (options_.velocity != workflow::SeriesOptions::Velocity::none)
        text += fmt::format(", compensated {:.6g} m/s", scan.speed_mps);
      if (scan.estimate) text += fmt::format(" +- {:.2g} m/s", scan.estimate->uncertainty_mps);
      text += '\n';
    }
    return text;
  }

  // Targets against the profile of one burst.
  [[nodiscard]] std::string table(const std::vector<workflow::HeldTarget>& targets, std::size_t row) const {
    std::string text = fmt::format("burst {} at {:.6g} s:\n{:>6} {:>12} {:>10} {:>12} {:>9} {:>12} {:>9} {:>8} {:>9}\n",
                                   series_.rows[row].burst + 1, series_.rows[row].time_s, "target", "range m",
                                   "speed m/s", "expected m", "bin", "found m", "error m", "width m", "error dB");
    for (const workflow::HeldTarget& target : targets) {
      text += fmt::format("{:>6} {:>12.3f} {:>10.2f} {:>12.3f} {:>9.2f}", target.truth.target + 1, target.truth.range_m,
                          target.truth.speed_mps, target.expected_m, target.expected_bin);
      if (target.found)
        text += fmt::format(" {:>12.3f} {:>9.3f} {:>8.3f} {:>9.2f}\n", target.found->range_m,
                            target.found->range_m - target.expected_m, target.found->width_m,
                            20.0 * std::log10(target.found->amplitude / target.truth.amplitude));
      else
        text += "  no peak\n";
    }
    return text;
  }

  [[nodiscard]] std::string json_text(const std::vector<workflow::HeldTarget>& targets, std::size_t row,
                                      double seconds) const {
    core::JsonWriter json;
    json.begin_object().member("sarsim", core::program_version).member("source", arguments_.input.path);
    json.key("files").begin_array();
    for (const fs::path& path : workflow::files_of_profiles(output())) json.value(path.string());
    json.end_array().member("set", word_of(set()));
    const signal::SteppedLimits& limits = series_.limits;
    json.member("bursts", series_.rows.size()).member("columns", series_.axis.count);
    json.member("range_first_m", series_.axis.first_m).member("range_step_m", series_.axis.step_m);
    json.member("carrier_hz", series_.centre_hz).member("bandwidth_hz", series_.band_hz);
    json.member("resolution_m", limits.resolution_m).member("unambiguous_range_m", limits.unambiguous_range_m);
    json.member("shift_m_per_mps", limits.shift_m_per_mps).member("smear_m_per_mps", limits.smear_m_per_mps);
    json.member("tolerable_speed_mps", limits.tolerable_mps).member("ambiguous_speed_mps", limits.ambiguous_mps);
    json.key("scans").begin_array();
    for (const workflow::ScanRecord& scan : series_.scans) write_scan(json, scan);
    json.end_array().member("burst", series_.rows[row].burst + 1).member("time_s", series_.rows[row].time_s);
    json.key("targets").begin_array();
    for (const workflow::HeldTarget& target : targets) write_target(json, target);
    json.end_array().key("peaks").begin_array();
    constexpr std::size_t most_peaks = 20;
    for (const signal::ProfilePeak& peak :
         signal::highest_peaks(series_.row(row), series_.axis, most_peaks, limits.resolution_m, 0.03)) {
      json.begin_object().member("range_m", peak.range_m).member("amplitude_v", peak.amplitude);
      json.member("phase_rad", peak.phase_rad).member("width_m", peak.width_m).end_object();
    }
    json.end_array().member("seconds", seconds).key("problems");
    write_json(json, input_.problems);
    return json.end_object().text();
  }

  static void write_scan(core::JsonWriter& json, const workflow::ScanRecord& scan) {
    json.begin_object().member("first_burst", scan.bursts.first + 1).member("last_burst", scan.bursts.last + 1);
    json.member("from_s", scan.from_s).member("to_s", scan.to_s).member("speed_mps", scan.speed_mps);
    if (scan.estimate)
      json.member("uncertainty_mps", scan.estimate->uncertainty_mps)
          .member("entropy", scan.estimate->entropy)
          .member("entropy_at_rest", scan.estimate->entropy_at_rest);
    json.end_object();
  }

  static void write_target(core::JsonWriter& json, const workflow::HeldTarget& target) {
    json.begin_object().member("target", target.truth.target + 1).member("range_m", target.truth.range_m);
    json.member("speed_mps", target.truth.speed_mps).member("amplitude_v", target.truth.amplitude);
    json.member("expected_m", target.expected_m).member("expected_bin", target.expected_bin);
    json.member("smear_cells", target.smear_cells);
    json.key("found");
    if (target.found) {
      json.begin_object().member("range_m", target.found->range_m);
      json.member("range_error_m", target.found->range_m - target.expected_m);
      json.member("width_m", target.found->width_m).member("phase_rad", target.found->phase_rad);
      json.member("amplitude_error_db", 20.0 * std::log10(target.found->amplitude / target.truth.amplitude));
      json.end_object();
    } else {
      json.null();
    }
    json.end_object();
  }

  const ProfilesArguments& arguments_;
  Streams& streams_;
  core::WorkControl control_;
  workflow::SeriesOptions options_;
  workflow::SteppedInput input_;
  workflow::ProfileSeries series_;
  std::size_t held_row_ = 0;
};

void add_profiles_options(CLI::App& app, ProfilesArguments& a) {
  add_text(app, "--out", a.output, "OUT",
           fmt::format("profiles to write: ENVI (.img, default), .csv for magnitudes against range, or {}",
                       raster::image_extensions(true)));
  add_choice<Set>(app, "--set", a.set, {{"bursts", Set::bursts}, {"scans", Set::scans}, {"encounter", Set::encounter}},
                  "a profile for each burst (default), or the mean power of each scan or of all scans");
  add_text(app, "--velocity", a.velocity, "none|scene|estimated|M/S",
           "radial speed that is compensated: none (default), that of the scene's targets, the one that makes profiles "
           "sharpest, or given, positive receding");
  add_real(app, "--fastest", a.fastest_mps, "M/S", "speeds that --velocity estimated looks through (default: 500)");
  app.add_flag("--align", a.align,
               "show targets where they are in the middle of their scan, not of each burst; means of sets always do");
  add_text(app, "--window", a.window, "WINDOW",
           "over the band: rectangular, hamming, hann, kaiser[:BETA], taylor[:DB:NBAR]; default: the script's");
  add_real(app, "--from", a.from_m, "M", "first range (default: the script's)");
  add_real(app, "--to", a.to_m, "M", "last range (default: the script's, as far as the recording shows it)");
  add_integer(app, "--oversampling", a.oversampling, 1, 64, "bins for each resolution cell (default: 4)");
  add_real(app, "--illumination", a.illumination_db, "DB",
           "bursts within so many dB of the strongest, two-way, belong to a scan (default: 6)");
  add_integer(app, "--burst", a.burst, 1, std::int64_t{1} << 40,
              "which burst is held against the script (default: the middle of the strongest scan)");
  add_stepped_input_arguments(app, a.input);
  add_integer(app, "--threads", a.threads, 0, 4096, "threads; 0 for one per core (default); never changes a byte");
  app.add_flag("--force", a.force, "replace files that exist");
  app.add_flag("--json", a.json, "a report as JSON on standard output");
  app.add_flag("--quiet", a.quiet, "only errors on standard error");
}

}  // namespace

Action add_profiles(CLI::App& app) {
  auto arguments = std::make_shared<ProfilesArguments>();
  add_text(app, "input", arguments->input.path, "SCENE|DATA", "script to simulate, or file of samples")->required();
  add_profiles_options(app, *arguments);
  add_examples(app,
               {{"sarsim profiles stepped_aircraft.scr", "simulate: stepped_aircraft-profiles.img and .hdr"},
                {"sarsim profiles stepped_aircraft.scr --velocity estimated --out a.csv", "sharpened, as a table"},
                {"sarsim profiles sim1.h5 --set scans --window taylor:35:5", "a recording, a profile for each scan"},
                {"sarsim profiles sim1.bin --script scene.scr --json", "a file that carries no script"}});
  return [arguments](Streams& streams) { return ProfilesRun(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
