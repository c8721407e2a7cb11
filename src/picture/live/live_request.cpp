#include "picture/live/live_request.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/maths/angle.hpp"
#include "scene/model/object.hpp"

namespace sarsim::picture {

namespace {

bool turns_by_itself(const scene::Platform& platform) {
  const auto& rate = platform.rotation_rate;
  return platform.rotation_kind == scene::Platform::Rotation::user || platform.waves != scene::Platform::Waves::none ||
         std::ranges::any_of(rate, [](const core::Angle& angle) { return angle.rad() != 0.0; });
}

bool carries_targets(const scene::Scene& scene, const scene::Platform& platform) {
  const auto stands_here = [&](const auto& object) {
    const std::size_t found = scene::find_platform(scene, *scene::carrier_in(object));
    return found != scene::not_found && &scene.platforms[found] == &platform;
  };
  return std::ranges::any_of(scene.targets, stands_here) || std::ranges::any_of(scene.clouds, stands_here) ||
         std::ranges::any_of(scene.surfaces, stands_here);
}

bool moves(const scene::Scene& scene, const std::string& name) {
  const std::size_t found = scene::find_platform(scene, name);
  if (found == scene::not_found) return false;
  const scene::Platform& platform = scene.platforms[found];
  return platform.path != scene::Platform::Path::stationary ||
         (!platform.parent.empty() && moves(scene, platform.parent));
}

}  // namespace

std::string_view title_of(LiveProduct product) {
  switch (product) {
    case LiveProduct::automatic: return "Automatic";
    case LiveProduct::focused: return "Focused image";
    case LiveProduct::profiles: return "Range profiles";
    case LiveProduct::isar: return "Turning target (ISAR)";
    case LiveProduct::doppler: return "Range-Doppler map";
    case LiveProduct::ppi: return "PPI (search radar)";
  }
  return "";
}

LiveProduct suitable_product(const scene::Scene& scene, std::size_t simulation) {
  const std::size_t number = scene::find_radar(scene, scene.simulations.at(simulation).radar);
  if (number == scene::not_found) return LiveProduct::doppler;
  const scene::Radar& radar = scene.radars[number];
  if (radar.carrier != scene::Radar::Carrier::single) {
    const bool turning = std::ranges::any_of(scene.platforms, [&](const scene::Platform& platform) {
      return turns_by_itself(platform) && carries_targets(scene, platform);
    });
    return turning ? LiveProduct::isar : LiveProduct::profiles;
  }
  if (radar.beam == scene::Radar::Beam::rotating) return LiveProduct::ppi;
  return moves(scene, radar.platform) ? LiveProduct::focused : LiveProduct::doppler;
}

std::string_view command_of(LiveProduct product) {
  switch (product) {
    case LiveProduct::profiles: return "profiles";
    case LiveProduct::isar: return "isar";
    case LiveProduct::doppler: return "doppler";
    case LiveProduct::ppi: return "search";
    case LiveProduct::automatic:
    case LiveProduct::focused: break;
  }
  return "focus";
}

}  // namespace sarsim::picture
