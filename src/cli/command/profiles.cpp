#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include <fmt/format.h>

#include "cli/command/product_command.hpp"
#include "cli/shell/report.hpp"
#include "core/text/number_text.hpp"

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
      "band {} about {}: resolution {:.4g} m; unambiguous over {:.4g} m; motion shifts by {:.4g} m and smears over "
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
      "{} of {} lie within a resolution cell ({:.4g} m) of another (*): they are not resolved, and each listed peak is "
      "their coherent sum\n",
      crowded, counted(report.targets.size(), "target"), cell_m);
}

// Targets against the profile of one burst.
std::string targets_text(const workflow::ProfilesReport& report) {
  constexpr std::size_t most = 20;
  const workflow::ProfileRow& row = report.series.rows[report.held_row];
  std::string text = fmt::format("burst {} at {:.6g} s:\n{:>7} {:>12} {:>10} {:>12} {:>9} {:>12} {:>9} {:>8} {:>9}\n",
                                 row.burst + 1, row.time_s, "target", "range m", "speed m/s", "expected m", "bin",
                                 "found m", "error m", "width m", "error dB");
  constexpr std::array<std::size_t, 9> widths{7, 12, 10, 12, 9, 12, 9, 8, 9};
  for (const workflow::HeldTarget& target : report.targets | std::views::take(most)) {
    core::Facts facts = workflow::facts_of(target);
    const bool crowded = target.nearest_m < report.series.limits.resolution_m;
    facts.front().text = fmt::format("{}{}", target.truth.target + 1, crowded ? '*' : ' ');
    text += core::aligned_row(facts, widths);
  }
  if (report.targets.size() > most)
    text += fmt::format("and {}; --json lists them\n", counted(report.targets.size() - most, "more target"));
  return text + crowd_text(report);
}

ProductText text_of_profiles(const workflow::ProfilesReport& report, const workflow::ProfilesRequest& /*request*/) {
  return {summary_text(report), targets_text(report)};
}

}  // namespace

Action add_profiles(CLI::App& app) {
  return add_product(
      app, workflow::profiles_product,
      {{"sarsim profiles stepped_aircraft.toml", "simulate: stepped_aircraft-profiles.img and .hdr"},
       {"sarsim profiles stepped_aircraft.toml --velocity estimated --out a.csv", "sharpened, as a table"},
       {"sarsim profiles sim1.h5 --group scans --window taylor:35:5", "a recording, a profile for each scan"},
       {"sarsim profiles sim1.bin --script scene.toml --json", "a file without its script"}},
      text_of_profiles);
}

}  // namespace sarsim::cli
