#include <utility>

#include <fmt/format.h>

#include "picture/facts/report_parts.hpp"
#include "picture/figure/figure_axes.hpp"
#include "workflow/focus/focus_report.hpp"

namespace sarsim::picture {

namespace {

Figure phase_figure(const workflow::AutofocusFinding& found) {
  FigureAxis up{"Phase", "rad", 0.0, 1.0, {}};
  fit(up, found.phase_rad);
  Figure figure;
  figure.title = "Phase error estimated by autofocus";
  figure.note =
      fmt::format("{:.3g} rad rms, {}", found.rms_rad,
                  found.applied ? std::string("removed from the echoes") : "not removed: " + failure_of(found));
  figure.panels.push_back(curve_panel("", axis_along("Along the track", "m", found.along_m), std::move(up),
                                      found.along_m, found.phase_rad));
  return figure;
}

}  // namespace

ReportPages pages_of(const workflow::FocusReport& made) {
  ReportPages pages = report::pages_of(facts_of(made));
  if (made.autofocus && made.autofocus->along_m.size() > 1) pages.figures.push_back(phase_figure(*made.autofocus));
  return pages;
}

}  // namespace sarsim::picture
