#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/maths/vector.hpp"
#include "picture/scene/camera.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::picture {

class Pen;

/// A line between two points of the world that is measured.
struct Ruler {
  core::Vec3 from_world_m;
  core::Vec3 to_world_m;

  friend bool operator==(const Ruler&, const Ruler&) = default;
};

/// What a ruler tells. Over an Earth heights are over the ellipsoid, angles in the east, north and up of its first
/// point, and the way over the ground is along the ellipsoid.
struct RulerReading {
  double distance_m = 0.0;     ///< Straight.
  double ground_m = 0.0;       ///< Of the points below, or above, on the ground.
  double height_m = 0.0;       ///< From the first point up to the second.
  double azimuth_rad = 0.0;    ///< Of the second point from the first; over an Earth clockwise from north.
  double elevation_rad = 0.0;  ///< The same, above the level.
};

/// The ground distance over an Earth is good to 1e-6 of it up to 1000 km.
[[nodiscard]] RulerReading measured(const Ruler& ruler, const std::optional<radar::EarthFrame>& earth);

/// What stands beside a ruler: "1.25 km", "ground 1.2 km  height 30 m", "azimuth 45.0°  elevation 1.4°".
[[nodiscard]] std::vector<std::string> ruler_words(const RulerReading& reading);

/// Which end of a ruler is within `reach_px` of a point of the picture, 0 the first and 1 the second.
[[nodiscard]] std::optional<int> ruler_end_at(const Ruler& ruler, const Camera& camera, double x_px, double y_px,
                                              double reach_px);

/// Draws a ruler with its ends, the level line below it where it goes up or down, and the words.
void draw_ruler(Pen& pen, const Ruler& ruler, const std::vector<std::string>& words);

}  // namespace sarsim::picture
