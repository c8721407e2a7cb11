#pragma once

#include <string>

#include "core/text/json.hpp"
#include "scene/model/scene.hpp"
#include "simulate/resolve/resolved.hpp"

namespace sarsim::cli {

/// Writes where and when a scene is: anchor and epoch of its world, the places of its platforms and targets at the
/// start of the recordings, and what was read from files of motion. Nothing as text where none of it is there.
/// @param all   every platform and target, not the first 20
/// @param json  takes the member "world" of its open object: null over a flat world without an epoch
/// @returns lines for people
[[nodiscard]] std::string world_text(const scene::Scene& scene, const simulate::ResolvedScene& resolved, bool all,
                                     core::JsonWriter& json);

/// A moment of a scene: "-1 s", with its date where there is an epoch: "-1 s (2020-07-28T22:59:41Z)".
[[nodiscard]] std::string time_text(const scene::World& world, double time_s);

/// Adds UTC of two times to the open object, where there is an epoch: "first_utc" and "last_utc".
void write_utc(core::JsonWriter& json, const scene::World& world, double first_s, double last_s);

}  // namespace sarsim::cli
