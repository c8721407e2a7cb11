#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/maths/constants.hpp"
#include "core/maths/decibels.hpp"
#include "core/text/number_text.hpp"
#include "workflow/focus/focus.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::workflow {

namespace {

using core::Facts;
using core::only;

double ratio_db(double amplitude_v, double noise_v) {
  return noise_v > 0.0 ? core::amplitude_db(amplitude_v / noise_v) : std::numeric_limits<double>::infinity();
}

constexpr int table_digits = 10;

// All digits of a number of such a table.
core::FactValue exact(bool known, double value) {
  return only(known && std::isfinite(value), core::format_number(value));
}

// @param begin  of the keys: "theory_azimuth_"
// @param end    of the labels: "az."; empty: for programs only
Facts columns_of_figures(const std::string& begin, const std::string& end,
                         const std::optional<signal::ResponseFigures>& figures) {
  const bool known = figures.has_value();
  const signal::ResponseFigures f = figures.value_or(signal::ResponseFigures{});
  const auto label = [&end](const char* what) { return end.empty() ? std::string() : what + end; };
  return {{begin + "width_m", label("Width "), only(known, f.width), "m", core::fixed(3)},
          {begin + "pslr_db", label("PSLR "), only(known, f.pslr_db), "dB", core::fixed(2)},
          {begin + "islr_db", label("ISLR "), only(known, f.islr_db), "dB", core::fixed(2)}};
}

Facts columns_of_place(const std::string& begin, const std::optional<radar::Geodetic>& place) {
  const bool known = place.has_value();
  const radar::Geodetic at = place.value_or(radar::Geodetic{});
  return {{begin + "latitude_deg", "", exact(known, core::deg_per_rad * at.latitude_rad)},
          {begin + "longitude_deg", "", exact(known, core::deg_per_rad * at.longitude_rad)},
          {begin + "height_m", "", exact(known, at.height_m)}};
}

Facts columns_of(const TargetTheory& theory) {
  const bool expected = theory.amplitude > 0.0;
  Facts facts{{"target", "", theory.target + 1},
              {"azimuth_m", "", exact(expected, theory.place.azimuth_m)},
              {"range_m", "", exact(expected, theory.place.range_m)},
              {"amplitude_v", "", exact(true, theory.amplitude)},
              {"phase_rad", "", exact(expected, theory.phase_rad)}};
  append(facts, columns_of_figures("azimuth_", "", theory.azimuth));
  append(facts, columns_of_figures("range_", "", theory.range));
  return facts;
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

core::Facts columns_of(const MeasuredTarget& target, const MeasureReport& report) {
  const TargetTheory& theory = target.theory;
  const signal::PointResponse* const peak = target.response();
  const bool found = peak != nullptr;
  const signal::PointResponse at = found ? *peak : signal::PointResponse{};
  const bool measured = target.expected() && !target.outside;
  const bool placed = target.expected() || target.outside;
  Facts facts{
      {"target", "", theory.target + 1},
      {"found", "", target.found.has_value()},
      {"theory_azimuth_m", "", only(placed, theory.place.azimuth_m)},
      {"theory_range_m", "", only(placed, theory.place.range_m)},
      {"", "Azimuth", theory.place.azimuth_m, "m", core::fixed(3)},
      {"", "Range", theory.place.range_m, "m", core::fixed(3)},
      {"azimuth_error_m", "Offset az.", only(found, at.place.azimuth_m - theory.place.azimuth_m), "m",
       core::with_sign(4)},
      {"range_error_m", "Offset rg.", only(found, at.place.range_m - theory.place.range_m), "m", core::with_sign(4)},
      {"theory_amplitude_v", "", theory.amplitude},
      {"amplitude_v", "", only(found, at.amplitude)},
      {"amplitude_error_db", "", found ? core::FactValue(target.amplitude_error_db()) : core::FactValue()},
      {"theory_phase_rad", "", only(target.expected(), theory.phase_rad)},
      {"phase_rad", "", only(found, at.phase_rad)},
      {"phase_error_rad", "", found ? core::FactValue(target.phase_error_rad()) : core::FactValue()},
      {"noise_v", "", only(measured, target.noise_v)},
      {"snr_db", "SNR", only(target.peak_v > 0.0, target.snr_db()), "dB", core::fixed(1)},
      {"threshold_db", "", only(measured, core::power_db(target.threshold))}};
  append(facts, columns_of_figures("azimuth_", "az.", found ? std::optional(at.azimuth) : std::nullopt));
  append(facts, columns_of_figures("theory_azimuth_", "", theory.azimuth));
  append(facts, columns_of_figures("range_", "rg.", found ? std::optional(at.range) : std::nullopt));
  append(facts, columns_of_figures("theory_range_", "", theory.range));
  append(facts, {{"state", "", to_string(target.state)},
                 {"false_alarm_probability", "", exact(measured, target.false_alarm_probability)}});
  if (!report.on_earth({})) return facts;
  append(facts, columns_of_place("theory_", target.expected() ? report.on_earth(theory.place) : std::nullopt));
  append(facts, columns_of_place("", found ? report.on_earth(at.place) : std::nullopt));
  return facts;
}

std::string csv_of(const std::vector<TargetTheory>& targets) {
  std::string text = core::csv_names(columns_of(TargetTheory{}));
  for (const TargetTheory& theory : targets) text += core::csv_line(columns_of(theory), table_digits);
  return text;
}

std::string csv_of(const MeasureReport& report) {
  std::string text = core::csv_names(columns_of({}, report));
  for (const MeasuredTarget& target : report.targets) text += core::csv_line(columns_of(target, report), table_digits);
  return text;
}

}  // namespace sarsim::workflow
