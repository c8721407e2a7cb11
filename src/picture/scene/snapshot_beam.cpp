#include "picture/scene/snapshot_beam.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "picture/scene/half_power.hpp"

namespace sarsim::picture {

namespace {

constexpr std::size_t lobe_outline_points = 65;
constexpr int lobe_rows = 25;
constexpr int lobe_columns = 49;
constexpr double lobe_widths = 3.0;  // the lobe is drawn so far off the axis, in half-power widths

// How far to one side of the middle [deg] a cut [dB] has fallen by 3 dB; nothing where it never does.
std::optional<double> half_power_deg(const core::AngleFunction& gain_db, double middle_deg, double side) {
  constexpr int steps = 1800;
  const auto at = [&](double off_deg) {
    return gain_db.value(core::deg_per_rad * radar::wrapped_angle((middle_deg + side * off_deg) * core::rad_per_deg));
  };
  const double level = gain_db.value(middle_deg) - 3.0;
  double before = 0.0;
  for (int i = 1; i <= steps; ++i) {
    double after = 180.0 * i / steps;
    if (at(after) > level) {
      before = after;
      continue;
    }
    for (int halving = 0; halving < 30; ++halving) {
      const double between = 0.5 * (before + after);
      (at(between) > level ? before : after) = between;
    }
    return after;
  }
  return std::nullopt;
}

// The width within which a cut is less than 3 dB below its middle; 2 pi where it never falls so far.
double half_power_width_rad(const core::AngleFunction& gain_db, double middle_rad) {
  const double middle_deg = middle_rad * core::deg_per_rad;
  const std::optional<double> right_deg = half_power_deg(gain_db, middle_deg, 1.0);
  const std::optional<double> left_deg = gain_db.is_even() ? right_deg : half_power_deg(gain_db, middle_deg, -1.0);
  if (!right_deg || !left_deg) return 2.0 * core::pi;
  return (*left_deg + *right_deg) / core::deg_per_rad;
}

bool usable(double width_rad) { return std::isfinite(width_rad) && width_rad > 0.0; }

std::vector<std::vector<core::Vec3>> lobe_of(const radar::AntennaPattern& pattern, radar::PatternRule rule,
                                             const BeamShape& shape) {
  const double azimuth_end = std::min(core::pi, lobe_widths * shape.azimuth_width_rad);
  const double elevation_end = std::min(0.5 * core::pi, lobe_widths * shape.elevation_width_rad);
  std::vector<std::vector<core::Vec3>> lobe(lobe_rows, std::vector<core::Vec3>(lobe_columns));
  double largest = 0.0;
  for (int i = 0; i < lobe_rows; ++i)
    for (int k = 0; k < lobe_columns; ++k) {
      const double elevation = shape.middle.elevation_rad + elevation_end * (2.0 * i / (lobe_rows - 1) - 1.0);
      const double azimuth = shape.middle.azimuth_rad + azimuth_end * (2.0 * k / (lobe_columns - 1) - 1.0);
      double amplitude = std::abs(radar::one_way_amplitude(pattern, azimuth, elevation, rule));
      if (!std::isfinite(amplitude)) amplitude = 0.0;
      largest = std::max(largest, amplitude);
      lobe[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = amplitude * core::direction(azimuth, elevation);
    }
  if (largest <= 0.0) return lobe;
  for (std::vector<core::Vec3>& row : lobe)
    for (core::Vec3& point : row) point = (1.0 / largest) * point;
  return lobe;
}

}  // namespace

BeamShape beam_shape(const radar::AntennaPattern& pattern, radar::PatternRule rule) {
  BeamShape shape;
  shape.azimuth_width_rad = 2.0 * core::pi;
  shape.elevation_width_rad = 2.0 * core::pi;
  switch (pattern.kind) {
    case radar::AntennaPattern::Kind::isotropic: return shape;
    case radar::AntennaPattern::Kind::sinx:
      if (!usable(pattern.azimuth_beamwidth_rad) || !usable(pattern.elevation_beamwidth_rad)) return shape;
      shape.azimuth_width_rad = std::min(2.0 * core::pi, pattern.azimuth_beamwidth_rad);
      shape.elevation_width_rad = std::min(2.0 * core::pi, pattern.elevation_beamwidth_rad);
      break;
    case radar::AntennaPattern::Kind::user:
      if (pattern.azimuth_gain_db.function().knots().size() < 2 &&
          pattern.elevation_gain_db.function().knots().size() < 2)
        return shape;
      shape.middle = beam_middle(pattern);
      shape.azimuth_width_rad = half_power_width_rad(pattern.azimuth_gain_db, shape.middle.azimuth_rad);
      shape.elevation_width_rad = half_power_width_rad(pattern.elevation_gain_db, shape.middle.elevation_rad);
      break;
  }
  shape.isotropic = false;
  shape.outline = half_power_outline(pattern, rule, lobe_outline_points);
  shape.lobe_antenna = lobe_of(pattern, rule, shape);
  return shape;
}

}  // namespace sarsim::picture
