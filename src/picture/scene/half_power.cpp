#include "picture/scene/half_power.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/vector.hpp"

namespace sarsim::picture {

namespace {

double amplitude_at(const radar::AntennaPattern& pattern, radar::PatternRule rule, const radar::BeamOffset& offset) {
  return std::abs(radar::one_way_amplitude(pattern, offset.azimuth_rad, offset.elevation_rad, rule));
}

// Where a cut has its highest gain, nearest to the axis [deg].
double peak_deg(const core::AngleFunction& cut, double limit_deg) {
  constexpr double on_axis_db = 0.5;
  constexpr double step_deg = 0.25;
  if (cut.is_even()) return 0.0;
  double best_deg = 0.0;
  const auto look_at = [&](double deg) {
    if (std::abs(deg) <= limit_deg && cut.value(deg) > cut.value(best_deg)) best_deg = deg;
  };
  for (double deg = step_deg; deg <= limit_deg; deg += step_deg) {
    look_at(deg);
    look_at(-deg);
  }
  for (const core::Knot& knot : cut.function().knots()) look_at(knot.x);
  return cut.value(best_deg) - cut.value(0.0) > on_axis_db ? best_deg : 0.0;
}

// The nearest half-power offset from the middle in one direction of length 1, within a quarter turn; steps grow from a
// thousandth of a degree.
std::optional<radar::BeamOffset> half_power(const radar::AntennaPattern& pattern, radar::PatternRule rule,
                                            const radar::BeamOffset& middle, const radar::BeamOffset& along) {
  const double half = amplitude_at(pattern, rule, middle) / std::sqrt(2.0);
  const auto at = [&](double offset_rad) {
    return radar::BeamOffset{middle.azimuth_rad + offset_rad * along.azimuth_rad,
                             middle.elevation_rad + offset_rad * along.elevation_rad};
  };
  const auto below_half = [&](double offset_rad) { return amplitude_at(pattern, rule, at(offset_rad)) < half; };
  double inside_rad = 0.0;
  double outside_rad = 1e-3 * core::rad_per_deg;
  for (; !below_half(outside_rad); outside_rad *= 1.05) {
    inside_rad = outside_rad;
    if (outside_rad > 0.5 * core::pi) return std::nullopt;
  }
  for (int i = 0; i < 40; ++i) {
    const double middle_rad = 0.5 * (inside_rad + outside_rad);
    (below_half(middle_rad) ? outside_rad : inside_rad) = middle_rad;
  }
  return at(inside_rad);
}

// Half the width of a beam in a plane; a quarter turn where it has none.
double width_rad(const std::optional<radar::BeamOffset>& offset, const radar::BeamOffset& middle) {
  return offset ? std::hypot(offset->azimuth_rad - middle.azimuth_rad, offset->elevation_rad - middle.elevation_rad)
                : 0.5 * core::pi;
}

}  // namespace

radar::BeamOffset beam_middle(const radar::AntennaPattern& pattern) {
  if (pattern.kind != radar::AntennaPattern::Kind::user) return {};
  return {peak_deg(pattern.azimuth_gain_db, 180.0) * core::rad_per_deg,
          peak_deg(pattern.elevation_gain_db, 90.0) * core::rad_per_deg};
}

std::vector<std::optional<radar::BeamOffset>> half_power_outline(const radar::AntennaPattern& pattern,
                                                                 radar::PatternRule rule, std::size_t points) {
  const radar::BeamOffset middle = beam_middle(pattern);
  const double across_rad = width_rad(half_power(pattern, rule, middle, {1.0, 0.0}), middle);
  const double up_rad = width_rad(half_power(pattern, rule, middle, {0.0, 1.0}), middle);
  std::vector<std::optional<radar::BeamOffset>> outline;
  for (std::size_t i = 0; i < points; ++i) {
    const double turn_rad = 2.0 * core::pi * static_cast<double>(i) / static_cast<double>(points - 1);
    const core::Vec3 along{across_rad * std::cos(turn_rad), up_rad * std::sin(turn_rad), 0.0};
    outline.push_back(half_power(pattern, rule, middle, {along.x / core::norm(along), along.y / core::norm(along)}));
  }
  return outline;
}

core::Vec3 beam_direction(const radar::Pointing& pointing, radar::PointingRule rule, const radar::BeamOffset& offset) {
  if (rule == radar::PointingRule::added_angles)
    return core::direction(pointing.axis_azimuth_rad() + offset.azimuth_rad,
                           pointing.axis_elevation_rad() + offset.elevation_rad);
  return core::transposed(pointing.antenna_from_world()) * core::direction(offset.azimuth_rad, offset.elevation_rad);
}

}  // namespace sarsim::picture
