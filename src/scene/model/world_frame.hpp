#pragma once

#include <optional>

#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// Where the world of World::Frame::earth lies.
[[nodiscard]] radar::Anchor anchor_of(const World& world);

/// The Earth under the world; nothing over a flat one.
[[nodiscard]] std::optional<radar::EarthFrame> earth_of(const World& world);

/// The moment of time 0, or why it is not known; without a moment and a failure where the world has no epoch.
[[nodiscard]] radar::InstantReading epoch_of(const World& world);

}  // namespace sarsim::scene
