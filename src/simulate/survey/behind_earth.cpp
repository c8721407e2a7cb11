#include "simulate/survey/behind_earth.hpp"

#include <algorithm>

#include "radar/earth/ellipsoid.hpp"

namespace sarsim::simulate {

namespace {

core::Vec3 earth_axis(const radar::TurningAxes& turning) {
  const double rate = core::norm(turning.rotation_rad_per_s);
  return rate > 0.0 ? (1.0 / rate) * turning.rotation_rad_per_s : core::Vec3{};
}

}  // namespace

BehindEarth::BehindEarth(const radar::TurningAxes& turning) : centre_m_(turning.centre_m), axis_(earth_axis(turning)) {}

core::Vec3 BehindEarth::on_unit_sphere(const core::Vec3& point_world_m) const {
  constexpr double stretch = 1.0 / (1.0 - radar::wgs84_flattening);
  const core::Vec3 p = point_world_m - centre_m_;
  return (1.0 / radar::wgs84_semi_major_m) * (p + (stretch - 1.0) * core::dot(p, axis_) * axis_);
}

// The nearest point to the centre of the line between both, against the sphere.
bool BehindEarth::hides(const core::Vec3& a_world_m, const core::Vec3& b_world_m) const {
  if (!is_round()) return false;
  constexpr double spare = 1.0 / radar::wgs84_semi_major_m;
  const core::Vec3 a = on_unit_sphere(a_world_m);
  const core::Vec3 way = on_unit_sphere(b_world_m) - a;
  const double length_2 = core::dot(way, way);
  if (!(length_2 > 0.0)) return false;
  const double nearest = -core::dot(a, way) / length_2;
  if (nearest <= 0.0 || nearest >= 1.0) return false;
  const double radius = std::min({1.0, core::norm(a), core::norm(a + way)}) - spare;
  const core::Vec3 at = a + nearest * way;
  return core::dot(at, at) < radius * radius;
}

}  // namespace sarsim::simulate
