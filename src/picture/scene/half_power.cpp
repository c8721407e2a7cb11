#include "picture/scene/half_power.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/vector.hpp"

namespace sarsim::picture {

namespace {

double amplitude_at(const radar::AntennaPattern& pattern, radar::PatternRule rule, const radar::BeamOffset& offset) {
  return std::abs(radar::one_way_amplitude(pattern, offset.azimuth_rad, offset.elevation_rad, rule));
}

// The nearest half-power offset in one direction of length 1, within a quarter turn; steps grow from a thousandth of a
// degree.
std::optional<radar::BeamOffset> half_power(const radar::AntennaPattern& pattern, radar::PatternRule rule,
                                            const radar::BeamOffset& along) {
  const double half = amplitude_at(pattern, rule, {0.0, 0.0}) / std::sqrt(2.0);
  const auto at = [&](double offset_rad) {
    return radar::BeamOffset{offset_rad * along.azimuth_rad, offset_rad * along.elevation_rad};
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
double width_rad(const std::optional<radar::BeamOffset>& offset) {
  return offset ? std::hypot(offset->azimuth_rad, offset->elevation_rad) : 0.5 * core::pi;
}

}  // namespace

std::vector<std::optional<radar::BeamOffset>> half_power_outline(const radar::AntennaPattern& pattern,
                                                                 radar::PatternRule rule, std::size_t points) {
  const double across_rad = width_rad(half_power(pattern, rule, {1.0, 0.0}));
  const double up_rad = width_rad(half_power(pattern, rule, {0.0, 1.0}));
  std::vector<std::optional<radar::BeamOffset>> outline;
  for (std::size_t i = 0; i < points; ++i) {
    const double turn_rad = 2.0 * core::pi * static_cast<double>(i) / static_cast<double>(points - 1);
    const core::Vec3 along{across_rad * std::cos(turn_rad), up_rad * std::sin(turn_rad), 0.0};
    outline.push_back(half_power(pattern, rule, {along.x / core::norm(along), along.y / core::norm(along)}));
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
