#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/maths/vector.hpp"
#include "picture/figure/figure.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "scene/model/scene.hpp"

namespace sarsim::picture {

/// A point of the world on a map: longitude and latitude in degrees and the height over the ellipsoid, or x, y and z of
/// a flat world, m.
struct MapPlace {
  double x = 0.0;
  double y = 0.0;
  double height_m = 0.0;
};

/// The ground of a scene as seen from above: a level plane, or the ellipsoid of WGS 84 raised by a height.
class SceneMap {
 public:
  /// @param points_m  world; their mean height is that of the ground; 0 without any
  SceneMap(const scene::World& world, const std::vector<core::Vec3>& points_m);

  /// Where a point is; longitudes go on beyond 180 deg, at most half a turn from the anchor's.
  [[nodiscard]] MapPlace place_of(const core::Vec3& point_m) const;
  [[nodiscard]] double ground_height_m() const { return ground_height_m_; }
  /// The first point of the ground along a ray, world, within 1 mm; nothing where it misses or begins below.
  [[nodiscard]] std::optional<core::Vec3> met_by(const core::Vec3& from_m, const core::Vec3& direction) const;

  /// Axes of a map, still without limits.
  void name_axes(FigurePanel& panel) const;
  /// The axis of times: seconds, or the time of day of UTC where the world has an epoch; from `first_s` to `last_s`.
  [[nodiscard]] FigureAxis time_axis(double first_s, double last_s) const;
  /// "the ellipsoid at 40 m" or "the plane z = 40 m".
  [[nodiscard]] std::string ground_words() const;
  /// A moment: "-1 s", or the time of day.
  [[nodiscard]] std::string time_words(double time_s) const;

 private:
  [[nodiscard]] std::optional<double> way_to_plane(const core::Vec3& from_m, const core::Vec3& direction) const;
  [[nodiscard]] std::optional<double> way_to_ellipsoid(const core::Vec3& from_m, const core::Vec3& direction) const;

  std::optional<radar::EarthFrame> earth_;
  std::optional<radar::Instant> epoch_;
  double ground_height_m_ = 0.0;
};

}  // namespace sarsim::picture
