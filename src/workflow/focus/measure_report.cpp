#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::workflow {

namespace {

double ratio_db(double amplitude_v, double noise_v) {
  return noise_v > 0.0 ? core::amplitude_db(amplitude_v / noise_v) : std::numeric_limits<double>::infinity();
}

// Empty if it is not a number.
void add_cell(std::string& line, double value) {
  line += std::isfinite(value) ? fmt::format(",{:.10g}", value) : std::string(",");
}

void add_figures(std::string& line, const std::optional<signal::ResponseFigures>& figures) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto member :
       {&signal::ResponseFigures::width, &signal::ResponseFigures::pslr_db, &signal::ResponseFigures::islr_db})
    add_cell(line, figures ? (*figures).*member : none);
}

constexpr std::array place_names{"theory_latitude_deg", "theory_longitude_deg", "theory_height_m",
                                 "latitude_deg",        "longitude_deg",        "height_m"};

// Exact, as far as there are any.
void add_place(std::string& line, const std::optional<radar::Geodetic>& place) {
  if (place)
    line += fmt::format(",{},{},{}", core::format_number(core::deg_per_rad * place->latitude_rad),
                        core::format_number(core::deg_per_rad * place->longitude_rad),
                        core::format_number(place->height_m));
  else
    line += ",,,";
}

std::string csv_line(const MeasuredTarget& target, const MeasureReport& report) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const TargetTheory& theory = target.theory;
  const signal::PointResponse* const peak = target.response();
  const bool found = peak != nullptr;
  const bool measured = target.expected() && !target.outside;
  std::string line = fmt::format("{},{}", theory.target + 1, target.found ? 1 : 0);
  const bool placed = target.expected() || target.outside;
  add_cell(line, placed ? theory.place.azimuth_m : none);
  add_cell(line, placed ? theory.place.range_m : none);
  add_cell(line, found ? peak->place.azimuth_m - theory.place.azimuth_m : none);
  add_cell(line, found ? peak->place.range_m - theory.place.range_m : none);
  add_cell(line, theory.amplitude);
  add_cell(line, found ? peak->amplitude : none);
  add_cell(line, found ? target.amplitude_error_db() : none);
  add_cell(line, target.expected() ? theory.phase_rad : none);
  add_cell(line, found ? peak->phase_rad : none);
  add_cell(line, found ? target.phase_error_rad() : none);
  add_cell(line, measured ? target.noise_v : none);
  add_cell(line, target.peak_v > 0.0 ? target.snr_db() : none);
  add_cell(line, measured ? core::power_db(target.threshold) : none);
  add_figures(line, found ? std::optional(peak->azimuth) : std::nullopt);
  add_figures(line, theory.azimuth);
  add_figures(line, found ? std::optional(peak->range) : std::nullopt);
  add_figures(line, theory.range);
  line += fmt::format(",{},", to_string(target.state));
  if (measured) core::append_number(line, target.false_alarm_probability);
  if (report.on_earth({})) {
    add_place(line, target.expected() ? report.on_earth(theory.place) : std::nullopt);
    add_place(line, found ? report.on_earth(peak->place) : std::nullopt);
  }
  return line + "\n";
}

}  // namespace

const char* to_string(TargetState state) {
  switch (state) {
    case TargetState::no_echoes: return "no echoes";
    case TargetState::outside: return "outside";
    case TargetState::not_found: return "not found";
    case TargetState::displaced: return "displaced";
    case TargetState::weak: return "weak";
    case TargetState::strong: return "strong";
    case TargetState::found: return "found";
  }
  return "";
}

const signal::PointResponse* MeasuredTarget::response() const {
  if (found) return &*found;
  return peak ? &*peak : nullptr;
}

double MeasuredTarget::phase_error_rad() const {
  return std::remainder(response()->phase_rad - theory.phase_rad, 2.0 * core::pi);
}

double MeasuredTarget::amplitude_error_db() const {
  return core::amplitude_db(response()->amplitude / theory.amplitude);
}

double MeasuredTarget::snr_db() const { return ratio_db(peak_v, noise_v); }

double MeasuredTarget::expected_snr_db() const { return ratio_db(theory.amplitude, noise_v); }

std::optional<radar::Geodetic> MeasureReport::on_earth(const signal::ImagePlace& place) const {
  if (!origin.earth || frame.plane != signal::ImagePlane::ground_grid) return std::nullopt;
  return origin.earth->geodetic_of(frame.origin_m + place.azimuth_m * frame.along + place.range_m * frame.across);
}

MeasureSummary summary_of(const MeasureReport& report) {
  MeasureSummary summary;
  const auto span = [&](double& lowest, double& highest, double value) {
    lowest = summary.found == 1 ? value : std::min(lowest, value);
    highest = summary.found == 1 ? value : std::max(highest, value);
  };
  for (const MeasuredTarget& target : report.targets) {
    if (target.outside || target.expected()) ++(target.outside ? summary.outside : summary.expected);
    summary.displaced += target.state == TargetState::displaced ? 1 : 0;
    summary.weak += target.state == TargetState::weak ? 1 : 0;
    summary.strong += target.state == TargetState::strong ? 1 : 0;
    if (!target.found) continue;
    ++summary.found;
    const signal::ImagePlace& place = target.found->place;
    summary.farthest_m = std::max(summary.farthest_m, std::hypot(place.azimuth_m - target.theory.place.azimuth_m,
                                                                 place.range_m - target.theory.place.range_m));
    span(summary.lowest_amplitude_db, summary.highest_amplitude_db, target.amplitude_error_db());
    span(summary.lowest_phase_rad, summary.highest_phase_rad, target.phase_error_rad());
    span(summary.lowest_snr_db, summary.highest_snr_db, target.snr_db());
  }
  return summary;
}

std::string csv_of(const std::vector<TargetTheory>& targets) {
  std::string text =
      "target,azimuth_m,range_m,amplitude_v,phase_rad,azimuth_width_m,azimuth_pslr_db,azimuth_islr_db,range_width_m,"
      "range_pslr_db,range_islr_db\n";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const TargetTheory& theory : targets) {
    const bool expected = theory.amplitude > 0.0;
    std::string line = fmt::format("{}", theory.target + 1);
    for (const double value : {expected ? theory.place.azimuth_m : none, expected ? theory.place.range_m : none,
                               theory.amplitude, expected ? theory.phase_rad : none}) {
      line += ',';
      if (std::isfinite(value)) core::append_number(line, value);
    }
    add_figures(line, theory.azimuth);
    add_figures(line, theory.range);
    text += line + "\n";
  }
  return text;
}

std::string csv_of(const MeasureReport& report) {
  std::string text =
      "target,found,theory_azimuth_m,theory_range_m,azimuth_error_m,range_error_m,theory_amplitude_v,amplitude_v,"
      "amplitude_error_db,theory_phase_rad,phase_rad,phase_error_rad,noise_v,snr_db,threshold_db,azimuth_width_m,"
      "azimuth_pslr_db,azimuth_islr_db,theory_azimuth_width_m,theory_azimuth_pslr_db,theory_azimuth_islr_db,"
      "range_width_m,range_pslr_db,range_islr_db,theory_range_width_m,theory_range_pslr_db,theory_range_islr_db,"
      "state,false_alarm_probability";
  if (report.on_earth({}))
    for (const char* name : place_names) text += fmt::format(",{}", name);
  text += "\n";
  for (const MeasuredTarget& target : report.targets) text += csv_line(target, report);
  return text;
}

}  // namespace sarsim::workflow
