#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/report_parts.hpp"
#include "picture/figure/figure_axes.hpp"
#include "workflow/stepped/profiles.hpp"

namespace sarsim::picture {

namespace {

using workflow::ProfilesReport;

const char* word_of_speed(workflow::SeriesOptions::Velocity velocity) {
  using Velocity = workflow::SeriesOptions::Velocity;
  switch (velocity) {
    case Velocity::given: return "as given";
    case Velocity::scene: return "of the scene's targets";
    case Velocity::estimated: return "estimated";
    case Velocity::none: break;
  }
  return "none";
}

ReportTable profile_facts(const ProfilesReport& made) {
  const workflow::ProfileSeries& series = made.series;
  const signal::ProfileAxis& axis = series.axis;
  const signal::SteppedLimits& limits = series.limits;
  report::Facts facts;
  facts.count("Simulation", made.simulation + 1);
  facts.word("A profile for", workflow::word_of(made.set));
  facts.count("Bursts recorded", made.bursts);
  facts.count("Bursts illuminated", series.rows.size());
  facts.count("Scans", series.scans.size());
  facts.word("Speed compensated", word_of_speed(made.velocity));
  facts.count("Bins", axis.count);
  facts.number("Range from", axis.first_m, "m");
  facts.number("Range to", axis.at(static_cast<double>(axis.count) - 1.0), "m");
  facts.number("Bins apart", axis.step_m, "m");
  facts.number("Band", series.band_hz, "Hz");
  facts.number("Centre frequency", series.centre_hz, "Hz");
  facts.number("Resolution", limits.resolution_m, "m");
  facts.number("Steps repeat every", limits.unambiguous_range_m, "m");
  facts.number("Shift by each m/s", limits.shift_m_per_mps, "m");
  facts.number("Smear by each m/s", limits.smear_m_per_mps, "m");
  facts.number("Speed that smears half a cell", limits.tolerable_mps, "m/s");
  facts.number("Ambiguous speed", limits.ambiguous_mps, "m/s");
  facts.time(made.seconds);
  return facts.take();
}

ReportTable scans_table(const ProfilesReport& made) {
  ReportTable table{"Scans", {"Scan", "First burst", "Last burst", "From (s)", "To (s)", "Speed (m/s)"}, {}};
  const auto& scans = made.series.scans;
  const bool estimated = !scans.empty() && scans.front().estimate.has_value();
  if (estimated) table.columns.insert(table.columns.end(), {"Uncertainty (m/s)", "Entropy", "Entropy at rest"});
  for (std::size_t s = 0; s < scans.size(); ++s) {
    const workflow::ScanRecord& scan = scans[s];
    std::vector<std::string> row{fmt::format("{}", s + 1),
                                 fmt::format("{}", scan.bursts.first + 1),
                                 fmt::format("{}", scan.bursts.last + 1),
                                 report::six_digits(scan.from_s),
                                 report::six_digits(scan.to_s),
                                 report::six_digits(scan.speed_mps)};
    if (scan.estimate)
      row.insert(row.end(),
                 {report::six_digits(scan.estimate->uncertainty_mps), report::fixed(scan.estimate->entropy, 3),
                  report::fixed(scan.estimate->entropy_at_rest, 3)});
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable held_targets_table(const ProfilesReport& made, std::size_t burst) {
  ReportTable table{fmt::format("Targets in burst {}", burst + 1),
                    {"Target", "Range (m)", "Speed (m/s)", "Expected (m)", "Bin", "Found (m)", "Error (m)", "Width (m)",
                     "Error (dB)"},
                    {}};
  for (const workflow::HeldTarget& target : made.targets) {
    std::vector<std::string> row{fmt::format("{}", target.truth.target + 1), report::fixed(target.truth.range_m, 3),
                                 report::fixed(target.truth.speed_mps, 2), report::fixed(target.expected_m, 3),
                                 report::fixed(target.expected_bin, 2)};
    if (target.found)
      row.insert(row.end(),
                 {report::fixed(target.found->range_m, 3), report::fixed(target.found->range_m - target.expected_m, 3),
                  report::fixed(target.found->width_m, 3),
                  report::fixed(core::amplitude_db(target.found->amplitude / target.truth.amplitude), 2)});
    else
      row.emplace_back(target.outside ? "outside the profile" : report::no_peak);
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable peaks_table(const ProfilesReport& made, std::size_t burst) {
  ReportTable table{
      fmt::format("Peaks of burst {}", burst + 1), {"Range (m)", "Amplitude (V)", "Phase (rad)", "Width (m)"}, {}};
  for (const signal::ProfilePeak& peak : made.peaks)
    table.rows.push_back({report::fixed(peak.range_m, 3), report::six_digits(peak.amplitude),
                          report::fixed(peak.phase_rad, 3), report::fixed(peak.width_m, 3)});
  return table;
}

// The profile of a burst, with crosses where the scene's targets should be.
Figure profile_figure(const ProfilesReport& made, std::size_t row) {
  const workflow::ProfileSeries& series = made.series;
  std::vector<double> range_m;
  std::vector<double> magnitude;
  double largest = 0.0;
  for (const std::complex<double>& value : series.row(row)) {
    range_m.push_back(series.axis.at(static_cast<double>(range_m.size())));
    magnitude.push_back(std::abs(value));
    largest = std::max(largest, magnitude.back());
  }
  Figure figure;
  figure.title = fmt::format("Profile of burst {}", series.rows[row].burst + 1);
  figure.note = fmt::format("at {:.6g} s, largest {}", series.rows[row].time_s, core::with_prefix(largest, "V", 4));
  FigurePanel panel;
  panel.x = axis_along("Slant range", "m", range_m);
  constexpr double shown_db = 60.0;
  std::vector<double> level_db = decibels_of(std::move(magnitude), 20.0, shown_db);
  panel.y = {"Magnitude, re 1 V", "dB", 0.0, 1.0, {}};
  for (const workflow::HeldTarget& target : made.targets)
    if (target.expected_m >= range_m.front() && target.expected_m <= range_m.back() && target.truth.amplitude > 0.0)
      panel.marks.push_back(
          {target.expected_m, core::amplitude_db(target.truth.amplitude), fmt::format("{}", target.truth.target + 1)});
  std::vector<double> seen = level_db;
  for (const FigureMark& mark : panel.marks) seen.push_back(mark.y);
  fit(panel.y, seen);
  panel.y.last += 0.1 * (panel.y.last - panel.y.first);  // For the words of the highest mark.
  panel.curves.push_back({"", Role::curve, false, std::move(range_m), std::move(level_db)});
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

ReportPages pages_of(const ProfilesReport& made) {
  ReportPages pages;
  pages.tables.push_back(profile_facts(made));
  pages.tables.push_back(scans_table(made));
  if (made.held_row >= made.series.rows.size() || made.series.axis.count == 0) return pages;
  const std::size_t burst = made.series.rows[made.held_row].burst;
  if (!made.targets.empty()) pages.tables.push_back(held_targets_table(made, burst));
  if (!made.peaks.empty()) pages.tables.push_back(peaks_table(made, burst));
  pages.figures.push_back(profile_figure(made, made.held_row));
  return pages;
}

}  // namespace sarsim::picture
