#include "scene/model/world_frame.hpp"

namespace sarsim::scene {

radar::Anchor anchor_of(const World& world) {
  return {{world.latitude.rad(), world.longitude.rad(), world.height_m}, world.heading.rad()};
}

std::optional<radar::EarthFrame> earth_of(const World& world) {
  if (world.frame != World::Frame::earth) return std::nullopt;
  return radar::EarthFrame(anchor_of(world));
}

radar::InstantReading epoch_of(const World& world) {
  if (world.epoch.empty()) return {};
  return radar::parse_instant(world.epoch, radar::TimeScale::utc);
}

}  // namespace sarsim::scene
