#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "picture/facts/report_parts.hpp"
#include "picture/figure/figure_axes.hpp"
#include "workflow/stepped/stepped_report.hpp"

namespace sarsim::picture {

namespace {

using workflow::ProfilesReport;

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
  ReportPages pages = report::pages_of(facts_of(made));
  if (made.held_row < made.series.rows.size() && made.series.axis.count > 0)
    pages.figures.push_back(profile_figure(made, made.held_row));
  return pages;
}

}  // namespace sarsim::picture
