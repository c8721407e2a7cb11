#include "workflow/focus/focus_report.hpp"

#include "core/build/version.hpp"
#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"

namespace sarsim::workflow {

namespace {

using core::Facts;
using core::FactValue;
using core::fixed;
using core::only;

FactValue autofocus_of(const std::optional<AutofocusFinding>& found) {
  if (!found) return {};
  return Facts{core::worded("applied", "Autofocus", found->applied, found->applied ? "applied" : "failed, not applied"),
               {"piece_m", "", found->piece_m},
               {"rms_rad", "Phase error, rms", found->rms_rad, "rad"},
               {"", "Sub-aperture length", found->piece_m, "m"},
               {"entropy_before", "Entropy before", found->entropy_before, "", fixed(3)},
               {"entropy_after", "Entropy after", found->entropy_after, "", fixed(3)},
               {"contrast_before", "", found->contrast_before},
               {"contrast_after", "", found->contrast_after},
               {"points", "", found->points},
               {"point_gain_db", "", found->point_gain_db},
               {"point_snr_before_db", "", found->point_snr_before_db},
               {"point_snr_after_db", "", found->point_snr_after_db}};
}

FactValue figures_of(const std::optional<signal::ResponseFigures>& figures) {
  if (!figures) return {};
  return Facts{{"width_m", "", figures->width},
               {"null_m", "", figures->null},
               {"pslr_db", "", figures->pslr_db},
               {"islr_db", "", figures->islr_db}};
}

// On a ground grid over the Earth.
Facts facts_of_place(const MeasureReport& report, const signal::ImagePlace& place) {
  const auto at = report.on_earth(place);
  if (!at) return {};
  return {{"latitude_deg", "", core::deg_per_rad * at->latitude_rad},
          {"longitude_deg", "", core::deg_per_rad * at->longitude_rad},
          {"height_m", "", at->height_m}};
}

Facts facts_of_point(const signal::ImagePlace& place, Facts on_earth, double amplitude, double phase_rad,
                     const std::optional<signal::ResponseFigures>& azimuth,
                     const std::optional<signal::ResponseFigures>& range) {
  Facts facts{{"azimuth_m", "", place.azimuth_m}, {"range_m", "", place.range_m}};
  append(facts, std::move(on_earth));
  append(facts, {{"amplitude_v", "", amplitude},
                 {"phase_rad", "", phase_rad},
                 {"azimuth", "", figures_of(azimuth)},
                 {"range", "", figures_of(range)}});
  return facts;
}

Facts facts_of_target(const MeasuredTarget& target, const MeasureReport& report) {
  const TargetTheory& theory = target.theory;
  Facts facts{{"target", "", theory.target + 1},
              {"theory", "",
               facts_of_point(theory.place, target.expected() ? facts_of_place(report, theory.place) : Facts{},
                              theory.amplitude, theory.phase_rad, theory.azimuth, theory.range)},
              {"outside_image", "", target.outside},
              {"state", "", to_string(target.state)}};
  if (target.expected() && !target.outside)
    append(facts, {{"search_m", "", target.search_m},
                   {"noise_v", "", target.noise_v},
                   {"threshold_db", "", core::power_db(target.threshold)},
                   {"snr_db", "", only(target.peak_v > 0.0 && target.noise_v > 0.0, target.snr_db())},
                   {"false_alarm_probability", "", target.false_alarm_probability}});
  if (!target.found) facts.push_back({"found", "", {}});
  if (target.response() == nullptr) return facts;
  const signal::PointResponse& found = *target.response();
  append(facts, {{target.found ? "found" : "peak", "",
                  facts_of_point(found.place, facts_of_place(report, found.place), found.amplitude, found.phase_rad,
                                 found.azimuth, found.range)},
                 {"azimuth_error_m", "", found.place.azimuth_m - theory.place.azimuth_m},
                 {"range_error_m", "", found.place.range_m - theory.place.range_m},
                 {"amplitude_error_db", "", target.amplitude_error_db()},
                 {"phase_error_rad", "", target.phase_error_rad()}});
  return facts;
}

}  // namespace

Facts facts_of(const FocusReport& report) {
  const signal::ImageAxis& azimuth = report.image.image.azimuth;
  const signal::ImageAxis& range = report.image.image.range;
  const auto last_m = [](const signal::ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); };
  const std::string across = report.grid == FocusGrid::ground ? "Ground range" : "Slant range";
  const bool moved = report.motion != MotionOrder::none;
  return {{"sarsim", "", core::program_version},
          {"source", "", report.input.path},
          {"files", "", core::texts_of(report.files)},
          {"", "Simulation", report.simulation + 1},
          {"algorithm", "Algorithm", word_of(report.algorithm)},
          {"rows", "Rows, along azimuth", azimuth.count, "samples"},
          {"columns", "Columns, along range", range.count, "samples"},
          {"azimuth_first_m", "Azimuth from", azimuth.first_m, "m"},
          {"", "Azimuth to", last_m(azimuth), "m"},
          {"azimuth_step_m", "Azimuth spacing", azimuth.step_m, "m"},
          {"range_first_m", across + " from", range.first_m, "m"},
          {"", across + " to", last_m(range), "m"},
          {"range_step_m", across + " spacing", range.step_m, "m"},
          {"doppler_centroid_hz", "Doppler centroid", report.options.doppler_centroid_hz, "Hz"},
          {"", "Doppler bandwidth kept",
           only(report.options.doppler_bandwidth_hz > 0.0, report.options.doppler_bandwidth_hz), "Hz"},
          {"range_window", "Window over range", signal::to_string(report.options.range_window)},
          {"azimuth_window", "Window over azimuth", signal::to_string(report.options.azimuth_window)},
          core::worded("motion_compensation", "Motion compensation", to_string(report.motion),
                       moved ? to_string(report.motion) + " order" : "none"),
          {"", "Largest deviation from the line", only(moved, report.strays_m), "m"},
          {"autofocus", "", autofocus_of(report.autofocus)},
          core::worded("on_disk", "Worked", report.image.on_disk, report.image.on_disk ? "on disk" : "in memory"),
          core::worded("seconds", "Time taken", report.seconds, core::duration_text(report.seconds)),
          {"problems", "", report.problems}};
}

Facts facts_of(const std::string& image, const MeasureReport& report) {
  core::FactRows targets;
  for (const MeasuredTarget& target : report.targets) targets.push_back(facts_of_target(target, report));
  const MeasureSummary sum = summary_of(report);
  return {{"sarsim", "", core::program_version},    {"image", "", image},
          {"source", "", report.origin.source},     {"algorithm", "", report.origin.algorithm},
          {"targets", "", std::move(targets)},      {"false_alarm", "", report.false_alarm},
          {"expected_targets", "", sum.expected},   {"found_targets", "", sum.found},
          {"displaced_targets", "", sum.displaced}, {"weak_targets", "", sum.weak},
          {"strong_targets", "", sum.strong},       {"truth", "", report.truth}};
}

}  // namespace sarsim::workflow
