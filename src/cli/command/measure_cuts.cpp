#include "cli/command/measure_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace sarsim::cli {

namespace {

constexpr double lowest_db = -60.0;

picture::FigureCurve measured_curve(const signal::ResponseCut& cut, double reach_m) {
  picture::FigureCurve curve{.name = "image", .role = picture::Role::curve, .x = {}, .y = {}};
  const auto middle = static_cast<double>(cut.values.size() / 2);
  const double peak = std::abs(cut.values[cut.values.size() / 2]);
  for (std::size_t i = 0; i < cut.values.size(); ++i) {
    const double place_m = (static_cast<double>(i) - middle) * cut.step_m;
    if (std::abs(place_m) > reach_m) continue;
    curve.x.push_back(place_m);
    curve.y.push_back(std::max(20.0 * std::log10(std::max(std::abs(cut.values[i]) / peak, 1e-30)), lowest_db - 20.0));
  }
  return curve;
}

picture::FigureCurve level(std::string name, picture::Role role, double db, double half_m) {
  return {.name = std::move(name), .role = role, .x = {-half_m, half_m}, .y = {db, db}};
}

picture::FigurePanel panel_of(const char* name, const signal::ResponseCut& cut, const signal::ResponseFigures& found,
                              const std::optional<signal::ResponseFigures>& theory) {
  constexpr double half_power_db = -3.0103;
  const double reach_m =
      std::min((1.0 + signal::islr_null_widths) * found.null, cut.step_m * static_cast<double>(cut.values.size() / 2));
  picture::FigurePanel panel;
  panel.title = fmt::format("{}: width {:.3f} m, PSLR {:.2f} dB, ISLR {:.2f} dB", name, found.width, found.pslr_db,
                            found.islr_db);
  panel.x = {
      .label = fmt::format("{} from the peak", name), .unit = "m", .first = -reach_m, .last = reach_m, .twin = {}};
  panel.y = {.label = "Power", .unit = "dB", .first = lowest_db, .last = 3.0, .twin = {}};
  panel.curves.push_back(measured_curve(cut, reach_m));
  if (theory) {
    panel.curves.push_back(level(fmt::format("expected width, {:.3f} m", theory->width), picture::Role::curve_2,
                                 half_power_db, 0.5 * theory->width));
    panel.curves.push_back(level(fmt::format("expected PSLR, {:.2f} dB", theory->pslr_db), picture::Role::curve_3,
                                 theory->pslr_db, reach_m));
  }
  return panel;
}

}  // namespace

picture::Figure figure_of_cuts(const signal::PointCuts& cuts, const signal::PointResponse& found,
                               const std::optional<signal::ResponseFigures>& azimuth,
                               const std::optional<signal::ResponseFigures>& range) {
  picture::Figure figure;
  figure.note = fmt::format("azimuth {:.3f} m, range {:.3f} m, {:.4g} V", found.place.azimuth_m, found.place.range_m,
                            found.amplitude);
  figure.panels = {panel_of("Azimuth", cuts.azimuth, found.azimuth, azimuth),
                   panel_of("Range", cuts.range, found.range, range)};
  return figure;
}

}  // namespace sarsim::cli
