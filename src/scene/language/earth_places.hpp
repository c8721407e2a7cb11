#pragma once

#include <optional>
#include <utility>

#include "core/maths/vector.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "radar/earth/geoid_grid.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::scene::language {

/// Where geodetic places of a text come to lie in its world.
class EarthPlaces {
 public:
  /// @param world  of Frame::earth
  /// @param geoid  of its file; nothing: one undulation everywhere
  EarthPlaces(const World& world, std::optional<radar::GeoidGrid> geoid)
      : frame_(anchor_of(world)), undulation_m_(world.undulation_m), geoid_(std::move(geoid)) {}

  /// World position of a place with a height above the ellipsoid.
  [[nodiscard]] core::Vec3 world_of(const radar::Geodetic& place) const { return frame_.world_of(place); }

  /// Height of the mean sea level above the ellipsoid, m; nothing outside the grid.
  [[nodiscard]] std::optional<double> undulation_m(double latitude_rad, double longitude_rad) const {
    if (!geoid_) return undulation_m_;
    return geoid_->undulation_m(latitude_rad, longitude_rad);
  }

 private:
  radar::EarthFrame frame_;
  double undulation_m_;
  std::optional<radar::GeoidGrid> geoid_;
};

}  // namespace sarsim::scene::language
