#include "signal/sar/projection_point.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/echo_records.hpp"

namespace sarsim::signal {

core::Vec3 heading_of(const ProjectionPulse& pulse, const ProjectionAperture& aperture) {
  if (core::dot(aperture.heading, aperture.heading) > 0.0) return aperture.heading;
  const double speed_mps = core::norm(pulse.velocity_mps);
  return speed_mps > 0.0 ? (1.0 / speed_mps) * pulse.velocity_mps : core::Vec3{};
}

double slowness_of(const ProjectionPulse& pulse, const ProjectionConstants& constants) {
  const double c = constants.light_speed_mps;
  const double v2 = constants.moving ? core::dot(pulse.velocity_mps, pulse.velocity_mps) : 0.0;
  return 2.0 / c / (1.0 - v2 / (c * c));
}

void project_point(const ProjectionPulse& pulse, const ProjectionConstants& constants,
                   const ProjectionAperture& aperture, const core::Vec3& point_m, float& re, float& im, float& weight) {
  const core::Vec3 r = point_m - pulse.position_m;
  const double d = pulse.bistatic ? 0.5 * (core::norm(r) + core::norm(point_m - pulse.receiver_m)) : core::norm(r);
  const double speed_mps = core::norm(pulse.velocity_mps);
  const double v = constants.moving && d > 0.0 ? -core::dot(r, pulse.velocity_mps) / d : 0.0;
  double w = 1.0;
  if (aperture.kind != ProjectionAperture::Kind::all) {
    const double ahead = core::dot(r, heading_of(pulse, aperture));
    const double aside = std::sqrt(std::max(d * d - ahead * ahead, 0.0));
    const double place = aperture.kind == ProjectionAperture::Kind::angle
                             ? (std::atan2(ahead, aside) - aperture.squint_rad) / aperture.extent
                             : (ahead - std::tan(aperture.squint_rad) * aside) / (speed_mps * aperture.extent);
    if (!(std::abs(place) <= 0.5)) return;
    if (!aperture.uniform) {
      const double x = (place + 0.5) * static_cast<double>(ProjectionAperture::pieces);
      const auto piece = static_cast<std::size_t>(x);
      const double begin = static_cast<double>(aperture.weights[piece]);
      const double end = static_cast<double>(aperture.weights[piece + 1]);
      w = begin + (x - std::floor(x)) * (end - begin);
    }
    weight += static_cast<float>(w);
  }
  const double ahead_m = constants.moving ? core::dot(r, pulse.velocity_mps) / constants.light_speed_mps : 0.0;
  const double delay_s = slowness_of(pulse, constants) * (d - ahead_m);
  const double fd = radar::doppler_of(v, pulse.carrier_of(constants), constants.light_speed_mps);
  const double early_s = fd * constants.doppler_delay_s2;
  const double record = (delay_s - early_s - constants.first_delay_s - pulse.later_s) * constants.records_per_s;
  if (!(record >= 0.0 && record < static_cast<double>(constants.record_count) - 1.0)) return;
  const auto whole = static_cast<std::size_t>(record);
  const double fraction = record - static_cast<double>(whole);
  const float* at = pulse.records + EchoRecords::floats * whole;
  const double x = (1.0 - fraction) * static_cast<double>(at[0]) + fraction * static_cast<double>(at[2]);
  const double y = (1.0 - fraction) * static_cast<double>(at[1]) + fraction * static_cast<double>(at[3]);
  const double turns = pulse.carrier_of(constants) * delay_s + 0.5 * fd * early_s;
  const double angle = 2.0 * core::pi * (turns - std::round(turns));
  re += static_cast<float>(w * (x * std::cos(angle) - y * std::sin(angle)));
  im += static_cast<float>(w * (x * std::sin(angle) + y * std::cos(angle)));
}

}  // namespace sarsim::signal
