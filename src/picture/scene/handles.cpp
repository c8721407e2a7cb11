#include "picture/scene/handles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/maths/rounding.hpp"
#include "core/text/number_text.hpp"
#include "radar/motion/rotation.hpp"

namespace sarsim::picture {

namespace {

// How the axes of a platform lie in the world; as the world's where there is no such platform.
core::Mat3 world_from(const scene::Scene& scene, const Snapshot& snapshot, const std::string& platform) {
  const std::size_t index = scene::find_platform(scene, platform);
  for (const Snapshot::Platform& p : snapshot.platforms)
    if (p.id.index == index) return p.pose.world_from_platform;
  return {};
}

// The angles of an object that rings turn, and about which axes of its carrier they grow right-handedly.
struct Turning {
  std::string name;
  core::Angle* angle;
  core::Vec3 axis;
  Role role;
};

std::vector<Turning> turning_of(scene::Platform& platform, double time_s) {
  const bool aligned = platform.path == scene::Platform::Path::trajectory && platform.aligned;
  if (platform.rotation_kind != scene::Platform::Rotation::constant || aligned) return {};
  std::array<double, 3> now{};
  for (std::size_t i = 0; i < 3; ++i) now[i] = platform.rotation[i].rad() + platform.rotation_rate[i].rad() * time_s;
  // Roll comes first, then pitch, then yaw: each turns about an axis that those after it have turned.
  const core::Mat3 by_yaw = radar::world_from_platform({0.0, 0.0, now[2]});
  const core::Mat3 by_yaw_and_pitch = radar::world_from_platform({0.0, now[1], now[2]});
  return {{"roll", &platform.rotation[0], by_yaw_and_pitch * core::Vec3{-1.0, 0.0, 0.0}, Role::x_axis},
          {"pitch", &platform.rotation[1], by_yaw * core::Vec3{0.0, -1.0, 0.0}, Role::y_axis},
          {"yaw", &platform.rotation[2], {0.0, 0.0, -1.0}, Role::z_axis}};
}

std::vector<Turning> turning_of(core::Angle& azimuth, core::Angle& elevation) {
  const double rad = azimuth.rad();
  return {{"azimuth", &azimuth, {0.0, 0.0, -1.0}, Role::z_axis},
          {"elevation", &elevation, {std::cos(rad), -std::sin(rad), 0.0}, Role::x_axis}};
}

std::vector<Turning> turning_of(scene::AnyObject& object, double time_s) {
  if (auto* platform = std::get_if<scene::Platform>(&object)) return turning_of(*platform, time_s);
  if (auto* target = std::get_if<scene::Target>(&object);
      target != nullptr && target->traits->reflectivity == scene::Target::Reflectivity::directional) {
    scene::TargetTraits& traits = target->traits.edit();
    return turning_of(traits.azimuth, traits.elevation);
  }
  if (auto* radar = std::get_if<scene::Radar>(&object);
      radar != nullptr && radar->beam == scene::Radar::Beam::fixed &&
      radar->transmit_antenna.pattern != scene::Antenna::Pattern::isotropic)
    return turning_of(radar->beam_azimuth, radar->beam_elevation);
  return {};
}

}  // namespace

std::optional<Handles> handles_of(const scene::Scene& scene, const Snapshot& snapshot, scene::ObjectId id,
                                  bool own_axes) {
  const auto place = place_of(snapshot, id);
  if (!place || !scene::has_object(scene, id)) return std::nullopt;
  scene::AnyObject object = scene::object_of(scene, id);
  const auto* platform = std::get_if<scene::Platform>(&object);
  if (platform != nullptr && core::equal_ignoring_case(platform->name, "Earth")) return std::nullopt;
  const std::string carrier = platform != nullptr ? platform->parent : scene::carrier_of(scene, id);
  const core::Mat3 world_from_carrier = carrier.empty() ? core::Mat3{} : world_from(scene, snapshot, carrier);
  Handles handles;
  handles.gizmo.place_world_m = *place;
  handles.gizmo.moves = position_of(object) != nullptr;
  if (own_axes)
    handles.gizmo.axes_world =
        core::transposed(platform != nullptr ? world_from(scene, snapshot, platform->name) : world_from_carrier).row;
  for (const Turning& turning : turning_of(object, snapshot.time_s)) {
    handles.gizmo.rings.push_back({world_from_carrier * turning.axis, turning.role});
    handles.angles.push_back({turning.name, turning.angle->rad()});
  }
  if (!handles.gizmo.moves && handles.gizmo.rings.empty()) return std::nullopt;
  return handles;
}

std::optional<Handles> handles_of(const Snapshot& snapshot, const PathPointId& point) {
  const auto platform = std::ranges::find(snapshot.platforms, point.platform, &Snapshot::Platform::id);
  if (platform == snapshot.platforms.end() || point.index >= platform->path_points_world_m.size()) return std::nullopt;
  Handles handles;
  handles.gizmo.place_world_m = platform->path_points_world_m[point.index];
  return handles;
}

scene::AnyObject turned(scene::AnyObject object, std::size_t ring, double by_rad) {
  const std::vector<Turning> turning = turning_of(object, 0.0);
  if (ring < turning.size())
    *turning[ring].angle = core::Angle::from_deg(core::tidy(turning[ring].angle->deg() + by_rad * core::deg_per_rad));
  return object;
}

core::Vec3* position_of(scene::AnyObject& object) {
  if (auto* target = std::get_if<scene::Target>(&object)) return &target->position_m;
  if (auto* platform = std::get_if<scene::Platform>(&object);
      platform && platform->path == scene::Platform::Path::stationary)
    return &platform->position_m;
  return nullptr;
}

}  // namespace sarsim::picture
