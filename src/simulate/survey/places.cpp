#include "simulate/survey/places.hpp"

#include <algorithm>
#include <optional>

namespace sarsim::simulate {

std::vector<core::Vec3> platform_places_m(const ResolvedScene& scene, double time_s, std::size_t most) {
  std::vector<core::Vec3> places_m;
  for (std::size_t i = 0; i < std::min(most, scene.platforms.size()); ++i)
    places_m.push_back(scene.platforms[i].track.at(time_s, 0).position_world_m);
  return places_m;
}

std::vector<core::Vec3> target_places_m(const ResolvedScene& scene, double time_s, std::size_t most) {
  std::vector<std::optional<radar::Pose>> poses(scene.platforms.size());
  std::vector<core::Vec3> places_m;
  for (std::size_t i = 0; i < std::min(most, scene.scatterers.targets()); ++i) {
    const Scatterer target = scene.scatterers[i];
    auto& pose = poses[target.platform];
    if (!pose) pose = scene.platforms[target.platform].track.at(time_s, 0);
    places_m.push_back(radar::world_position_m(*pose, target.position_m));
  }
  return places_m;
}

}  // namespace sarsim::simulate
