#include "radar/antenna/beam.hpp"

#include <cmath>

#include "core/report/expect.hpp"
#include "radar/antenna/pattern.hpp"

namespace sarsim::radar {

namespace {

struct Angles {
  double azimuth_rad;
  double elevation_rad;
};

bool steered(const Beam& beam) { return beam.kind == Beam::Kind::spot || beam.kind == Beam::Kind::user; }

// Script angles, in the platform's frame (fixed, rotating) or in the world's (spot, user).
Angles beam_angles(const Beam& beam, double time_s, const core::Vec3& radar_world_m) {
  switch (beam.kind) {
    case Beam::Kind::fixed: return {beam.azimuth_rad, beam.elevation_rad};
    case Beam::Kind::rotating: return {beam.rate_rad_per_s * time_s, beam.elevation_rad};
    case Beam::Kind::spot:
    case Beam::Kind::user: break;
  }
  core::Vec3 spot = beam.spot_world_m;
  if (beam.kind == Beam::Kind::user)
    spot = {beam.target_world_m[0].value(time_s), beam.target_world_m[1].value(time_s),
            beam.target_world_m[2].value(time_s)};
  const core::Vec3 look = spot - radar_world_m;
  return {core::azimuth_rad(look), core::elevation_rad(look)};
}

// Rows are the antenna's axes for a boresight given by angles, with z up as far as possible.
core::Mat3 antenna_axes(const Angles& a) {
  const core::Vec3 y = core::direction(a.azimuth_rad, a.elevation_rad);
  const core::Vec3 x{std::cos(a.azimuth_rad), -std::sin(a.azimuth_rad), 0.0};
  return {{x, y, core::cross(x, y)}};
}

}  // namespace

Pointing::Pointing(const Beam& beam, PointingRule rule, double time_s, const core::Vec3& radar_world_m,
                   const core::Mat3& world_from_platform, const std::array<double, 3>& rotation_rad)
    : rule_(rule) {
  CORE_EXPECT(std::isfinite(time_s));
  const Angles angles = beam_angles(beam, time_s, radar_world_m);
  if (rule == PointingRule::boresight) {
    const core::Mat3 axes = antenna_axes(angles);
    antenna_from_world_ = steered(beam) ? axes : axes * core::transposed(world_from_platform);
    return;
  }
  azimuth_rad_ = angles.azimuth_rad + (steered(beam) ? 0.0 : rotation_rad[2]);
  elevation_rad_ = angles.elevation_rad + (steered(beam) ? 0.0 : rotation_rad[1]);
}

BeamOffset Pointing::offset(const core::Vec3& look_world) const {
  if (rule_ == PointingRule::boresight) {
    const core::Vec3 look_antenna = antenna_from_world_ * look_world;
    return {core::azimuth_rad(look_antenna), core::elevation_rad(look_antenna)};
  }
  return {wrapped_angle(azimuth_rad_ - core::azimuth_rad(look_world)),
          wrapped_angle(elevation_rad_ - core::elevation_rad(look_world))};
}

core::Vec3 Pointing::axis_world() const {
  return rule_ == PointingRule::boresight ? antenna_from_world_.row[1] : core::direction(azimuth_rad_, elevation_rad_);
}

}  // namespace sarsim::radar
