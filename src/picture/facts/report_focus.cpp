#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "picture/facts/report_parts.hpp"
#include "picture/figure/figure_axes.hpp"
#include "workflow/focus/focus.hpp"

namespace sarsim::picture {

namespace {

void add_autofocus(report::Facts& facts, const workflow::AutofocusFinding& found) {
  facts.word("Autofocus", found.applied ? "applied" : "failed, not applied");
  facts.number("Phase error, rms", found.rms_rad, "rad");
  facts.number("Sub-aperture length", found.piece_m, "m");
  facts.word("Entropy before", report::fixed(found.entropy_before, 3));
  facts.word("Entropy after", report::fixed(found.entropy_after, 3));
}

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
  const signal::FocusedImage& image = made.image.image;
  report::Facts facts;
  facts.count("Simulation", made.simulation + 1);
  facts.word("Algorithm", word_of(made.algorithm));
  facts.count("Rows, along azimuth", image.azimuth.count, "samples");
  facts.count("Columns, along range", image.range.count, "samples");
  facts.axis("Azimuth", image.azimuth);
  facts.axis(made.grid == workflow::FocusGrid::ground ? "Ground range" : "Slant range", image.range);
  facts.number("Doppler centroid", made.options.doppler_centroid_hz, "Hz");
  if (made.options.doppler_bandwidth_hz > 0.0)
    facts.number("Doppler bandwidth kept", made.options.doppler_bandwidth_hz, "Hz");
  facts.word("Window over range", signal::to_string(made.options.range_window));
  facts.word("Window over azimuth", signal::to_string(made.options.azimuth_window));
  facts.word("Motion compensation",
             made.motion == workflow::MotionOrder::none ? "none" : to_string(made.motion) + " order");
  if (made.motion != workflow::MotionOrder::none) facts.number("Largest deviation from the line", made.strays_m, "m");
  if (made.autofocus) add_autofocus(facts, *made.autofocus);
  facts.word("Worked", made.image.on_disk ? "on disk" : "in memory");
  facts.time(made.seconds);
  ReportPages pages;
  pages.tables.push_back(facts.take());
  if (made.autofocus && made.autofocus->along_m.size() > 1) pages.figures.push_back(phase_figure(*made.autofocus));
  return pages;
}

}  // namespace sarsim::picture
