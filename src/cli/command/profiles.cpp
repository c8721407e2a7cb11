#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <ranges>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "core/build/version.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/stepped/profiles.hpp"
#include "workflow/stepped/profiles_options.hpp"

namespace sarsim::cli {

namespace {

std::string summary_text(const workflow::ProfilesReport& report) {
  const workflow::ProfileSeries& series = report.series;
  const signal::ProfileAxis& axis = series.axis;
  const signal::SteppedLimits& limits = series.limits;
  std::string text = fmt::format(
      "{}: {} of {} bursts in {} scan{}, {} bins from {:.6g} to {:.6g} m, {:.3g} m apart, {}\n", report.output.string(),
      series.rows.size(), report.bursts, series.scans.size(), series.scans.size() == 1 ? "" : "s", axis.count,
      axis.first_m, axis.at(static_cast<double>(axis.count) - 1.0), axis.step_m, core::duration_text(report.seconds));
  text += fmt::format(
      "band {} about {}: resolution {:.4g} m; steps repeat every {:.4g} m; speed shifts by {:.4g} m and smears over "
      "{:.4g} m for each m/s\n",
      core::with_prefix(series.band_hz, "Hz", 4), core::with_prefix(series.centre_hz, "Hz", 5), limits.resolution_m,
      limits.unambiguous_range_m, limits.shift_m_per_mps, limits.smear_m_per_mps);
  for (std::size_t s = 0; s < series.scans.size(); ++s) {
    const workflow::ScanRecord& scan = series.scans[s];
    text += fmt::format("scan {}: bursts {} to {}, {:.6g} to {:.6g} s", s + 1, scan.bursts.first + 1,
                        scan.bursts.last + 1, scan.from_s, scan.to_s);
    if (report.velocity != workflow::SeriesOptions::Velocity::none)
      text += fmt::format(", compensated {:.6g} m/s", scan.speed_mps);
    if (scan.estimate) text += fmt::format(" +- {:.2g} m/s", scan.estimate->uncertainty_mps);
    text += '\n';
  }
  return text;
}

// Why the figures of some targets are those of several.
std::string crowd_text(const workflow::ProfilesReport& report) {
  const double cell_m = report.series.limits.resolution_m;
  const auto crowded = std::ranges::count_if(
      report.targets, [cell_m](const workflow::HeldTarget& target) { return target.nearest_m < cell_m; });
  if (crowded == 0) return {};
  return fmt::format(
      "{} of {} lie within a resolution cell ({:.4g} m) of another (*): they share peaks, whose places and heights "
      "are those of their sums\n",
      crowded, counted(report.targets.size(), "target"), cell_m);
}

// Targets against the profile of one burst.
std::string targets_text(const workflow::ProfilesReport& report) {
  constexpr std::size_t most = 20;
  const workflow::ProfileRow& row = report.series.rows[report.held_row];
  std::string text = fmt::format("burst {} at {:.6g} s:\n{:>7} {:>12} {:>10} {:>12} {:>9} {:>12} {:>9} {:>8} {:>9}\n",
                                 row.burst + 1, row.time_s, "target", "range m", "speed m/s", "expected m", "bin",
                                 "found m", "error m", "width m", "error dB");
  for (const workflow::HeldTarget& target : report.targets | std::views::take(most)) {
    text += fmt::format("{:>6}{} {:>12.3f} {:>10.2f} {:>12.3f} {:>9.2f}", target.truth.target + 1,
                        target.nearest_m < report.series.limits.resolution_m ? '*' : ' ', target.truth.range_m,
                        target.truth.speed_mps, target.expected_m, target.expected_bin);
    if (target.found)
      text += fmt::format(" {:>12.3f} {:>9.3f} {:>8.3f} {:>9.2f}\n", target.found->range_m,
                          target.found->range_m - target.expected_m, target.found->width_m,
                          core::amplitude_db(target.found->amplitude / target.truth.amplitude));
    else
      text += "  no peak\n";
  }
  if (report.targets.size() > most)
    text += fmt::format("and {}; --json lists them\n", counted(report.targets.size() - most, "more target"));
  return text + crowd_text(report);
}

void write_scan(core::JsonWriter& json, const workflow::ScanRecord& scan) {
  json.begin_object().member("first_burst", scan.bursts.first + 1).member("last_burst", scan.bursts.last + 1);
  json.member("from_s", scan.from_s).member("to_s", scan.to_s).member("speed_mps", scan.speed_mps);
  if (scan.estimate)
    json.member("uncertainty_mps", scan.estimate->uncertainty_mps)
        .member("entropy", scan.estimate->entropy)
        .member("entropy_at_rest", scan.estimate->entropy_at_rest);
  json.end_object();
}

void write_held_target(core::JsonWriter& json, const workflow::HeldTarget& target) {
  json.begin_object().member("target", target.truth.target + 1).member("range_m", target.truth.range_m);
  json.member("speed_mps", target.truth.speed_mps).member("amplitude_v", target.truth.amplitude);
  json.member("expected_m", target.expected_m).member("expected_bin", target.expected_bin);
  json.member("smear_cells", target.smear_cells).key("nearest_target_m");
  std::isfinite(target.nearest_m) ? json.value(target.nearest_m) : json.null();
  json.key("found");
  if (target.found) {
    json.begin_object().member("range_m", target.found->range_m);
    json.member("range_error_m", target.found->range_m - target.expected_m);
    json.member("width_m", target.found->width_m).member("phase_rad", target.found->phase_rad);
    json.member("amplitude_error_db", core::amplitude_db(target.found->amplitude / target.truth.amplitude));
    json.end_object();
  } else {
    json.null();
  }
  json.end_object();
}

std::string json_text(const workflow::ProfilesReport& report) {
  const workflow::ProfileSeries& series = report.series;
  const workflow::ProfileRow& row = series.rows[report.held_row];
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("source", report.source);
  json.key("files").begin_array();
  for (const std::filesystem::path& path : report.files) json.value(path.string());
  json.end_array().member("set", workflow::word_of(report.set));
  const signal::SteppedLimits& limits = series.limits;
  json.member("bursts", series.rows.size()).member("columns", series.axis.count);
  json.member("range_first_m", series.axis.first_m).member("range_step_m", series.axis.step_m);
  json.member("carrier_hz", series.centre_hz).member("bandwidth_hz", series.band_hz);
  json.member("resolution_m", limits.resolution_m).member("unambiguous_range_m", limits.unambiguous_range_m);
  json.member("shift_m_per_mps", limits.shift_m_per_mps).member("smear_m_per_mps", limits.smear_m_per_mps);
  json.member("tolerable_speed_mps", limits.tolerable_mps).member("ambiguous_speed_mps", limits.ambiguous_mps);
  json.key("scans").begin_array();
  for (const workflow::ScanRecord& scan : series.scans) write_scan(json, scan);
  json.end_array().member("burst", row.burst + 1).member("time_s", row.time_s);
  json.key("targets").begin_array();
  for (const workflow::HeldTarget& target : report.targets) write_held_target(json, target);
  json.end_array().key("peaks").begin_array();
  for (const signal::ProfilePeak& peak : report.peaks) {
    json.begin_object().member("range_m", peak.range_m).member("amplitude_v", peak.amplitude);
    json.member("phase_rad", peak.phase_rad).member("width_m", peak.width_m).end_object();
  }
  json.end_array().member("seconds", report.seconds).key("problems");
  cli::write_json(json, report.problems);
  return json.end_object().text();
}

ExitStatus run_profiles(const RequestArguments& arguments, Streams& streams) {
  Watch watch(streams, arguments.quiet);
  const workflow::ProfilesReport report =
      workflow::profiles(workflow::profiles_request(arguments.input, arguments.given()), watch.observer());
  watch.close();
  if (!arguments.quiet) streams.err << summary_text(report);
  if (arguments.json)
    write_out(streams, json_text(report));
  else if (!arguments.quiet)
    write_out(streams, targets_text(report));
  flush_out(streams);
  return exit_done;
}

}  // namespace

Action add_profiles(CLI::App& app) {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, workflow::profiles_option_table().options(), *arguments);
  add_examples(app,
               {{"sarsim profiles stepped_aircraft.toml", "simulate: stepped_aircraft-profiles.img and .hdr"},
                {"sarsim profiles stepped_aircraft.toml --velocity estimated --out a.csv", "sharpened, as a table"},
                {"sarsim profiles sim1.h5 --group scans --window taylor:35:5", "a recording, a profile for each scan"},
                {"sarsim profiles sim1.bin --script scene.toml --json", "a file that carries no script"}});
  return [arguments](Streams& streams) { return run_profiles(*arguments, streams); };
}

}  // namespace sarsim::cli
