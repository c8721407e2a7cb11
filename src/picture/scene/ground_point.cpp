#include "picture/scene/ground_point.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/earth/ellipsoid.hpp"

namespace sarsim::picture {

namespace {

constexpr double min_elevation_rad = 5.0 * core::rad_per_deg;
constexpr double seen_edge_on = 1e-9;  // sine of the angle below which a line runs along a plane

std::optional<core::Vec3> plane_under(const SightLine& line, double z_m) {
  if (std::abs(line.along.z) < seen_edge_on) return std::nullopt;
  const double way_m = (z_m - line.from_m.z) / line.along.z;
  if (!(way_m >= line.first_m)) return std::nullopt;
  core::Vec3 point = line.from_m + way_m * line.along;
  point.z = z_m;
  return point;
}

// Stretched along the axis the ellipsoid is a sphere.
std::optional<core::Vec3> ellipsoid_under(const SightLine& line, const radar::EarthFrame& earth) {
  const double stretch = 1.0 / (1.0 - radar::wgs84_flattening);
  const auto stretched = [&](core::Vec3 v) {
    v.z *= stretch;
    return v;
  };
  const core::Vec3 from = stretched(earth.ecef_from_world(line.from_m));
  const core::Vec3 along = stretched(earth.ecef_axes_from_world(line.along));
  const double a = core::dot(along, along);
  const double half_b = core::dot(from, along);
  const core::Vec3 foot = from - (half_b / a) * along;
  const double under_root = radar::wgs84_semi_major_m * radar::wgs84_semi_major_m - core::dot(foot, foot);
  if (!(under_root >= 0.0)) return std::nullopt;
  const double half_chord_m = std::sqrt(under_root / a);
  for (const double way_m : {-half_b / a - half_chord_m, -half_b / a + half_chord_m})
    if (way_m >= line.first_m) return line.from_m + way_m * line.along;
  return std::nullopt;
}

}  // namespace

SightLine sight_line(const Camera& camera, double x_px, double y_px) {
  const core::Vec3 at = camera.unproject(x_px, y_px);
  const core::Vec3 towards = core::direction(camera.azimuth_rad, camera.elevation_rad);
  if (!camera.perspective) return {at, -towards, -HUGE_VAL};
  const core::Vec3 eye = camera.focus_world_m + camera.viewer_distance_m() * towards;
  return {eye, (1.0 / core::norm(at - eye)) * (at - eye), 0.0};
}

std::optional<core::Vec3> ground_under(const Camera& camera, double x_px, double y_px,
                                       const std::optional<radar::EarthFrame>& earth) {
  return ground_along(sight_line(camera, x_px, y_px), earth);
}

std::optional<core::Vec3> ground_along(const SightLine& line, const std::optional<radar::EarthFrame>& earth) {
  return earth ? ellipsoid_under(line, *earth) : plane_under(line, 0.0);
}

std::optional<core::Vec3> level_under(const Camera& camera, double x_px, double y_px, const core::Vec3& world_m) {
  if (std::abs(camera.elevation_rad) < min_elevation_rad) return std::nullopt;
  return plane_under(sight_line(camera, x_px, y_px), world_m.z);
}

}  // namespace sarsim::picture
