#include "picture/figure/antenna_figure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "picture/figure/figure_axes.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t points = 1441;  // an eighth of a degree from -90 to 90

// One way through an antenna: voltage factor against the offset in one plane.
struct Cut {
  std::string name;
  std::function<double(double)> amplitude;  // of an offset in degrees
};

std::vector<Cut> cuts_of(const radar::AntennaPattern& pattern, radar::PatternRule rule, const std::string& antenna) {
  const auto azimuth = [&pattern, rule](double deg) {
    return radar::one_way_amplitude(pattern, deg * core::rad_per_deg, 0.0, rule);
  };
  const auto elevation = [&pattern, rule](double deg) {
    return radar::one_way_amplitude(pattern, 0.0, deg * core::rad_per_deg, rule);
  };
  return {{antenna + "azimuth", azimuth}, {antenna + "elevation", elevation}};
}

std::vector<double> values_of(const Cut& cut, const std::vector<double>& offset_deg) {
  std::vector<double> values;
  values.reserve(offset_deg.size());
  for (const double deg : offset_deg) values.push_back(cut.amplitude(deg));
  return values;
}

// The offset nearest to the axis, on one side of it, at which the power has fallen to half that on the axis.
std::optional<double> half_power_deg(const Cut& cut, double side) {
  const double half = std::abs(cut.amplitude(0.0)) / std::sqrt(2.0);
  const auto below_half = [&](double off_deg) { return std::abs(cut.amplitude(side * off_deg)) < half; };
  constexpr double step = 0.01;
  for (double low = 0.0; low < 90.0; low += step) {
    if (!below_half(low + step)) continue;
    double inside = low;
    double outside = low + step;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (inside + outside);
      (below_half(middle) ? outside : inside) = middle;
    }
    return side * inside;
  }
  return std::nullopt;
}

double shown(DisplayQuantity quantity, double amplitude) {
  return quantity == DisplayQuantity::real ? amplitude : std::abs(amplitude);
}

FigureAxis axis_for(DisplayQuantity quantity) {
  switch (quantity) {
    case DisplayQuantity::real:
    case DisplayQuantity::magnitude: return {"Amplitude, one way", "", 0.0, 1.0, {}};
    case DisplayQuantity::decibels: return {"Gain, one way", "dB", 0.0, 1.0, {}};
    default: throw std::invalid_argument("an antenna pattern is shown as real part, magnitude or decibels");
  }
}

std::string words_of(const radar::AntennaPattern& pattern) {
  switch (pattern.kind) {
    case radar::AntennaPattern::Kind::isotropic: return "isotropic";
    case radar::AntennaPattern::Kind::user: return "user-defined";
    case radar::AntennaPattern::Kind::sinx: break;
  }
  return fmt::format("sin(x)/x, {:.6g} deg in azimuth, {:.6g} deg in elevation",
                     pattern.azimuth_beamwidth_rad / core::rad_per_deg,
                     pattern.elevation_beamwidth_rad / core::rad_per_deg);
}

// Curves of all cuts; those that coincide share one.
std::vector<FigureCurve> curves_of(const std::vector<Cut>& cuts, const std::vector<double>& offset_deg,
                                   const AntennaLook& look) {
  static constexpr Role roles[] = {Role::curve, Role::curve_2, Role::curve_3, Role::beam};
  std::vector<FigureCurve> curves;
  for (const Cut& cut : cuts) {
    std::vector<double> values = values_of(cut, offset_deg);
    std::ranges::transform(values, values.begin(), [&](double a) { return shown(look.quantity, a); });
    if (look.quantity == DisplayQuantity::decibels) values = decibels_of(std::move(values), 20.0, look.span_db);
    const auto same = std::ranges::find(curves, values, &FigureCurve::y);
    if (same != curves.end())
      same->name += " and " + cut.name;
    else
      curves.push_back({cut.name, roles[curves.size()], false, offset_deg, std::move(values)});
  }
  return curves;
}

// One of the curves, which may stand for several cuts.
void mark_half_power(FigurePanel& panel, const Cut& cut, const std::string& name, const AntennaLook& look) {
  const auto right = half_power_deg(cut, 1.0);
  const auto left = half_power_deg(cut, -1.0);
  const bool both_say_it = left && right && *left == -*right;  // The right one does, for both.
  const auto mark = [&](double half, bool says) {
    const double amplitude = cut.amplitude(half);
    const double y = look.quantity == DisplayQuantity::decibels ? 20.0 * std::log10(std::abs(amplitude))
                                                                : shown(look.quantity, amplitude);
    if (half >= look.first_deg && half <= look.last_deg)
      panel.marks.push_back({half, y, says ? fmt::format("{}half the power at {:.4g} deg", name, half) : ""});
  };
  if (left) mark(*left, !both_say_it);
  if (right) mark(*right, true);
}

void mark_half_powers(FigurePanel& panel, const std::vector<Cut>& cuts, const AntennaLook& look) {
  for (const FigureCurve& curve : panel.curves) {
    const auto cut = std::ranges::find_if(
        cuts, [&](const Cut& c) { return curve.name == c.name || curve.name.starts_with(c.name + " and "); });
    if (cut != cuts.end()) mark_half_power(panel, *cut, panel.curves.size() > 1 ? curve.name + ": " : "", look);
  }
}

}  // namespace

Figure antenna_figure(const simulate::Link& radar, radar::PatternRule rule, const AntennaLook& look) {
  std::vector<double> offset_deg;
  for (std::size_t i = 0; i < points; ++i)
    offset_deg.push_back(look.first_deg +
                         (look.last_deg - look.first_deg) * static_cast<double>(i) / static_cast<double>(points - 1));
  std::vector<Cut> cuts = cuts_of(radar.transmit, rule, "");
  const std::vector<Cut> receive = cuts_of(radar.receive, rule, "receive, ");
  const bool same = std::ranges::equal(
      cuts, receive, [&](const Cut& a, const Cut& b) { return values_of(a, offset_deg) == values_of(b, offset_deg); });
  if (!same) {
    for (Cut& cut : cuts) cut.name = "transmit, " + cut.name;
    cuts.insert(cuts.end(), receive.begin(), receive.end());
  }
  Figure figure;
  figure.title = "Antenna of " + radar.name;
  figure.note = words_of(radar.transmit) + (same ? "" : "; receive: " + words_of(radar.receive));
  FigurePanel& panel = figure.panels.emplace_back();
  panel.x = {"Offset from the beam's middle", "deg", look.first_deg, look.last_deg, {}};
  panel.y = axis_for(look.quantity);
  panel.curves = curves_of(cuts, offset_deg, look);
  std::vector<double> all;
  for (const FigureCurve& curve : panel.curves) all.insert(all.end(), curve.y.begin(), curve.y.end());
  fit(panel.y, all);
  mark_half_powers(panel, cuts, look);
  return figure;
}

}  // namespace sarsim::picture
