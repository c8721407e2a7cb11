#pragma once

#include "core/maths/vector.hpp"
#include "radar/earth/sagnac.hpp"

namespace sarsim::simulate {

/// Whether the Earth stands between two points of a world: the straight line between them passes through the
/// ellipsoid. Points below its surface, as those of the ground at low geoids, see what a lower ellipsoid through the
/// lower of them, less a metre, lets them see. Light is not bent here.
class BehindEarth {
 public:
  /// @param turning  of the world: axis and centre of its Earth; at rest over a flat world, where nothing is hidden
  explicit BehindEarth(const radar::TurningAxes& turning);

  /// Whether there is an Earth.
  [[nodiscard]] bool is_round() const { return axis_ != core::Vec3{}; }
  /// Whether it stands between two points.
  [[nodiscard]] bool hides(const core::Vec3& a_world_m, const core::Vec3& b_world_m) const;

 private:
  // From the centre, in units in which the ellipsoid is a sphere of radius 1.
  [[nodiscard]] core::Vec3 on_unit_sphere(const core::Vec3& point_world_m) const;

  core::Vec3 centre_m_;
  core::Vec3 axis_;
};

}  // namespace sarsim::simulate
