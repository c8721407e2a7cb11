#include "radar/antenna/pattern.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/opposite.hpp"

namespace sarsim::radar {

double wrapped_angle(double angle_rad) {
  const double reduced = std::abs(angle_rad) < core::pi ? angle_rad : std::remainder(angle_rad, 2.0 * core::pi);
  return reduced <= -core::pi + core::opposite_rad ? core::pi : reduced;
}

double sinx_gain(double offset_rad, double beamwidth_rad) {
  const double offset = wrapped_angle(offset_rad);
  if (std::abs(offset) >= 0.5 * core::pi) return 0.0;
  const double x = 0.88 * core::pi * std::sin(offset) / beamwidth_rad;
  return std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x;
}

double one_way_amplitude(const AntennaPattern& pattern, double azimuth_offset_rad, double elevation_offset_rad,
                         PatternRule rule) {
  switch (pattern.kind) {
    case AntennaPattern::Kind::isotropic: return 1.0;
    case AntennaPattern::Kind::sinx: {
      const double gain = sinx_gain(azimuth_offset_rad, pattern.azimuth_beamwidth_rad) *
                          sinx_gain(elevation_offset_rad, pattern.elevation_beamwidth_rad);
      return rule == PatternRule::amplitude ? gain : std::sqrt(std::abs(gain));
    }
    case AntennaPattern::Kind::user: {
      const auto degrees = [](double rad) { return wrapped_angle(rad) * core::deg_per_rad; };
      const double decibels = pattern.azimuth_gain_db.value(degrees(azimuth_offset_rad)) +
                              pattern.elevation_gain_db.value(degrees(elevation_offset_rad));
      return std::pow(10.0, decibels / 20.0);
    }
  }
  return 1.0;
}

}  // namespace sarsim::radar
