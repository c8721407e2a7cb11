#include "picture/scene/footprint.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "picture/scene/ground_point.hpp"

namespace sarsim::picture {

namespace {

constexpr int arc_points = 25;
constexpr double widest_rad = 2.8;  // a beam beyond that looks everywhere

std::optional<core::Vec3> ground_from(const core::Vec3& from_m, const core::Vec3& along,
                                      const std::optional<radar::EarthFrame>& earth) {
  return ground_along({from_m, along, 0.0}, earth);
}

// Away from the ground below a point.
core::Vec3 up_at(const core::Vec3& from_m, const std::optional<radar::EarthFrame>& earth) {
  const core::Vec3 up{0.0, 0.0, 1.0};
  return earth ? earth->world_from_enu(earth->geodetic_of(from_m)) * up : up;
}

core::Vec3 unit_along(const core::Vec3& v) { return (1.0 / core::norm(v)) * v; }

}  // namespace

std::vector<std::optional<core::Vec3>> ground_points(const core::Vec3& from_world_m,
                                                     const std::vector<std::optional<core::Vec3>>& directions_world,
                                                     const std::optional<radar::EarthFrame>& earth) {
  std::vector<std::optional<core::Vec3>> points;
  points.reserve(directions_world.size());
  for (const std::optional<core::Vec3>& along : directions_world)
    points.push_back(along ? ground_from(from_world_m, *along, earth) : std::nullopt);
  return points;
}

std::vector<core::Vec3> range_on_ground(const Snapshot::Radar& radar, double range_m,
                                        const std::optional<radar::EarthFrame>& earth) {
  if (radar.isotropic || radar.azimuth_width_rad > widest_rad || !(range_m > 0.0)) return {};
  const core::Vec3& from = radar.position_world_m;
  const core::Vec3 up = up_at(from, earth);
  const core::Vec3 level = radar.axis_world - core::dot(radar.axis_world, up) * up;
  const auto below = ground_from(from, -1.0 * up, earth);
  if (core::norm(level) < 1e-6 || !below || core::norm(from - *below) > range_m || core::norm(from - *below) < 1.0)
    return {};
  const core::Vec3 ahead = unit_along(level);
  const core::Vec3 aside = core::cross(ahead, up);
  std::vector<core::Vec3> arc;
  for (int i = 0; i < arc_points; ++i) {
    const double turn = radar.beam_middle.azimuth_rad + radar.azimuth_width_rad * (2.0 * i / (arc_points - 1) - 1.0);
    const core::Vec3 out = std::cos(turn) * ahead + std::sin(turn) * aside;
    // The farther from below, the longer the way to the ground.
    double near = 0.0;
    double far = 0.5 * core::pi;
    std::optional<core::Vec3> found;
    for (int halving = 0; halving < 50; ++halving) {
      const double angle = 0.5 * (near + far);
      const auto met = ground_from(from, std::sin(angle) * out - std::cos(angle) * up, earth);
      const bool beyond = !met || core::norm(*met - from) > range_m;
      if (met && std::abs(core::norm(*met - from) - range_m) < 1e-3 + 1e-6 * range_m) found = met;
      (beyond ? far : near) = angle;
    }
    if (!found) return {};
    arc.push_back(*found);
  }
  return arc;
}

}  // namespace sarsim::picture
