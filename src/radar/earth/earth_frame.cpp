#include "radar/earth/earth_frame.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using Axes = std::array<ExtendedVec3, 3>;

// East, north and up at a place.
Axes enu_of(const Geodetic& place) {
  const ExtendedTurn latitude = extended_turn(place.latitude_rad);
  const ExtendedTurn longitude = extended_turn(place.longitude_rad);
  const ExtendedVec3 out{longitude.cosine, longitude.sine, 0.0L};  // of the axis, in the meridian
  const ExtendedVec3 z{0.0L, 0.0L, 1.0L};
  return {ExtendedVec3{-longitude.sine, longitude.cosine, 0.0L}, latitude.cosine * z - latitude.sine * out,
          latitude.cosine * out + latitude.sine * z};
}

Axes headed(const Axes& enu, double heading_rad) {
  const ExtendedTurn heading = extended_turn(heading_rad);
  return {heading.cosine * enu[0] - heading.sine * enu[1], heading.sine * enu[0] + heading.cosine * enu[1], enu[2]};
}

ExtendedVec3 along(const Axes& axes, const ExtendedVec3& v) {
  return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
}

ExtendedVec3 out_of(const Axes& axes, const core::Vec3& v) { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }

[[maybe_unused]] bool is_place(const Geodetic& place) {
  return std::abs(place.latitude_rad) <= 0.5 * core::pi && std::isfinite(place.longitude_rad) &&
         std::isfinite(place.height_m);
}

}  // namespace

EarthFrame::EarthFrame(const Anchor& anchor)
    : anchor_(anchor),
      origin_ecef_m_(extended_ecef_of(anchor.origin)),
      axes_ecef_(headed(enu_of(anchor.origin), anchor.heading_rad)) {
  CORE_EXPECT(is_place(anchor.origin) && std::isfinite(anchor.heading_rad));
  turning_.rotation_rad_per_s = world_axes_from_ecef({0.0, 0.0, earth_rate_rad_per_s});
  turning_.centre_m = world_from_ecef({0.0, 0.0, 0.0});
}

core::Vec3 EarthFrame::world_from_ecef(const core::Vec3& ecef_m) const {
  return rounded(along(axes_ecef_, extended(ecef_m) - origin_ecef_m_));
}

core::Vec3 EarthFrame::ecef_from_world(const core::Vec3& world_m) const {
  return rounded(origin_ecef_m_ + out_of(axes_ecef_, world_m));
}

core::Vec3 EarthFrame::world_axes_from_ecef(const core::Vec3& vector_ecef) const {
  return rounded(along(axes_ecef_, extended(vector_ecef)));
}

core::Vec3 EarthFrame::ecef_axes_from_world(const core::Vec3& vector_world) const {
  return rounded(out_of(axes_ecef_, vector_world));
}

core::Vec3 EarthFrame::world_of(const Geodetic& place) const {
  return rounded(along(axes_ecef_, extended_ecef_of(place) - origin_ecef_m_));
}

Geodetic EarthFrame::geodetic_of(const core::Vec3& world_m) const {
  return radar::geodetic_of(origin_ecef_m_ + out_of(axes_ecef_, world_m));
}

core::Mat3 EarthFrame::world_from_enu(const Geodetic& place) const {
  core::Mat3 world_axes;
  const Axes enu = enu_of(place);
  for (std::size_t i = 0; i < 3; ++i) world_axes.row[i] = rounded(along(axes_ecef_, enu[i]));
  return core::transposed(world_axes);
}

core::Vec3 EarthFrame::inertial_velocity_mps(const core::Vec3& world_m, const core::Vec3& velocity_mps) const {
  return velocity_mps + carried_mps(turning_, world_m);
}

core::Vec3 EarthFrame::fixed_velocity_mps(const core::Vec3& world_m, const core::Vec3& inertial_mps) const {
  return inertial_mps - carried_mps(turning_, world_m);
}

}  // namespace sarsim::radar
