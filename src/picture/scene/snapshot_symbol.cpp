#include "picture/scene/snapshot_symbol.hpp"

#include <cmath>

namespace sarsim::picture {

namespace {

constexpr double lowest_flight_m = 20.0;
constexpr double steepest_way = 0.99;  // part of the way along up: beyond it there is no level left

core::Vec3 unit_vector(const core::Vec3& v) { return (1.0 / core::norm(v)) * v; }

core::Vec3 up_at(const core::Vec3& world_m, const std::optional<radar::EarthFrame>& earth) {
  if (!earth) return {0.0, 0.0, 1.0};
  return core::transposed(earth->world_from_enu(earth->geodetic_of(world_m))).row[2];
}

}  // namespace

core::Vec3 ground_below(const core::Vec3& world_m, const std::optional<radar::EarthFrame>& earth) {
  if (!earth) return {world_m.x, world_m.y, 0.0};
  radar::Geodetic place = earth->geodetic_of(world_m);
  place.height_m = 0.0;
  return earth->world_of(place);
}

std::optional<PlatformSymbol> symbol_of(const radar::Pose& pose, const core::Vec3& way_world, bool orbits,
                                        const std::optional<radar::EarthFrame>& earth) {
  const double length = core::norm(way_world);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  const core::Vec3 nose = (1.0 / length) * way_world;
  const core::Vec3 up = up_at(pose.position_world_m, earth);
  // A platform whose z axis is more or less upright leans by it; others have their axes elsewhere.
  const core::Vec3 own_up = core::transposed(pose.world_from_platform).row[2];
  core::Vec3 above = core::dot(own_up, up) > 0.5 ? own_up : up;
  if (std::abs(core::dot(above, nose)) > steepest_way) above = {nose.z, nose.x, nose.y};
  const core::Vec3 left = unit_vector(core::cross(above, nose));
  const core::Vec3 top = core::cross(nose, left);
  const double height_m = core::dot(pose.position_world_m - ground_below(pose.position_world_m, earth), up);
  const Symbol symbol = orbits ? Symbol::satellite : height_m > lowest_flight_m ? Symbol::aircraft : Symbol::vehicle;
  return PlatformSymbol{symbol, core::transposed({{nose, left, top}})};
}

}  // namespace sarsim::picture
