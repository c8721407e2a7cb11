#include "radar/antenna/beam.hpp"

#include "radar/antenna/pattern.hpp"

namespace sarsim {

namespace {

struct Angles {
  double azimuth_rad;
  double elevation_rad;
};

bool steered(const Beam& beam) { return beam.kind == Beam::Kind::spot || beam.kind == Beam::Kind::user; }

// Script angles, in the platform's frame (fixed, rotating) or in the world's (spot, user).
Angles beam_angles(const Beam& beam, double time_s, const Vec3& radar_world_m) {
  switch (beam.kind) {
    case Beam::Kind::fixed: return {beam.azimuth_rad, beam.elevation_rad};
    case Beam::Kind::rotating: return {beam.rate_rad_per_s * time_s, beam.elevation_rad};
    case Beam::Kind::spot:
    case Beam::Kind::user: break;
  }
  Vec3 spot = beam.spot_world_m;
  if (beam.kind == Beam::Kind::user)
    spot = {beam.target_world_m[0].value(time_s), beam.target_world_m[1].value(time_s),
            beam.target_world_m[2].value(time_s)};
  const Vec3 look = spot - radar_world_m;
  return {azimuth_rad(look), elevation_rad(look)};
}

// Rows are the antenna's axes for a boresight given by angles, with z up as far as possible.
Mat3 antenna_axes(const Angles& a) {
  const Vec3 y = direction(a.azimuth_rad, a.elevation_rad);
  const Vec3 x{std::cos(a.azimuth_rad), -std::sin(a.azimuth_rad), 0.0};
  return {{x, y, cross(x, y)}};
}

}  // namespace

Pointing::Pointing(const Beam& beam, PointingRule rule, double time_s, const Vec3& radar_world_m,
                   const Mat3& world_from_platform, const std::array<double, 3>& rotation_rad)
    : rule_(rule) {
  const Angles angles = beam_angles(beam, time_s, radar_world_m);
  if (rule == PointingRule::boresight) {
    const Mat3 axes = antenna_axes(angles);
    antenna_from_world_ = steered(beam) ? axes : axes * transposed(world_from_platform);
    return;
  }
  azimuth_rad_ = angles.azimuth_rad + (steered(beam) ? 0.0 : rotation_rad[2]);
  elevation_rad_ = angles.elevation_rad + (steered(beam) ? 0.0 : rotation_rad[1]);
}

BeamOffset Pointing::offset(const Vec3& look_world) const {
  if (rule_ == PointingRule::boresight) {
    const Vec3 look_antenna = antenna_from_world_ * look_world;
    return {azimuth_rad(look_antenna), elevation_rad(look_antenna)};
  }
  return {wrapped_angle(azimuth_rad_ - azimuth_rad(look_world)),
          wrapped_angle(elevation_rad_ - elevation_rad(look_world))};
}

Vec3 Pointing::axis_world() const {
  return rule_ == PointingRule::boresight ? antenna_from_world_.row[1] : direction(azimuth_rad_, elevation_rad_);
}

}  // namespace sarsim
