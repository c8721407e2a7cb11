#pragma once

#include <optional>
#include <string>

#include "core/report/problem.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::workflow {

/// Where and when a scene is, for formats whose places are those of the Earth.
struct EarthPlace {
  radar::EarthFrame earth;
  radar::Instant epoch;    ///< Of time 0.
  core::Problems remarks;  ///< What was assumed.
};

/// What a scene without an epoch is dated.
inline constexpr const char* assumed_epoch = "2000-01-01T00:00:00Z";

/// Reads "LAT,LON,HEIGHT" or "LAT,LON,HEIGHT,HEADING": degrees, metres over the ellipsoid, and the direction of the
/// world's +y axis clockwise from north. Throws core::InvalidRequest for anything else.
/// @param option  what the text was given with, for the message
[[nodiscard]] radar::Anchor anchor_from_text(const std::string& text, const std::string& option);

/// Throws core::InvalidRequest for an Earth-fixed place where nothing of a recording is: inside the Earth
/// (`radar::impossible_depth_m`) or beyond `radar::farthest_place_m`. What reads such files refuses it by the same
/// rule.
/// @param what  names it: "--anchor 10,20,-7e5"
void expect_possible_place(const core::Vec3& ecef_m, const std::string& what);

/// An anchor as `anchor_from_text` reads it back, to the last bit of its degrees.
[[nodiscard]] std::string anchor_text(const radar::Anchor& anchor);

/// The place of a world that is the Earth, or of a flat one that is laid there: its origin at the anchor, its axes in
/// the tangent plane, at rest over the Earth. Throws core::InvalidRequest where a flat world has no anchor, or the
/// Earth has one of its own besides; nothing is assumed there.
/// @param format  that needs the place, for the message
[[nodiscard]] EarthPlace earth_place(const scene::World& world, const std::optional<radar::Anchor>& anchor,
                                     const std::string& format);

}  // namespace sarsim::workflow
