#pragma once

#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

/// Level ground as an antenna on a straight line sees it, to one side.
class GroundSight {
 public:
  /// @param scene_m     world; a point that says on which side, how far away, and how high the ground is
  /// @param squint_rad  of the line of sight, ahead of the plane perpendicular to the line; less than a right angle
  /// @throw  std::invalid_argument where the reference rests, or the scene lies on its line
  GroundSight(const ReferenceTrack& reference, const core::Vec3& scene_m, double squint_rad);

  /// Direction of flight, length 1.
  [[nodiscard]] const core::Vec3& ahead() const { return ahead_; }
  /// Distance of the scene under the squint angle.
  [[nodiscard]] double range_m() const { return range_m_; }
  /// The point of the line that is nearest to a point.
  [[nodiscard]] core::Vec3 foot_of(const core::Vec3& point_m) const { return point_m - from_line(point_m); }
  /// The point of the ground at a distance from a point of the line; straight below where the ground is farther away
  /// than that.
  [[nodiscard]] core::Vec3 point_at(const core::Vec3& from_m, double range_m) const;
  /// Derivatives of a ground point with respect to the position along the line and to the distance, m/m, world.
  struct Tangents {
    core::Vec3 along;
    core::Vec3 across;
  };
  /// Those of `point_at`, as means over some metres to either side, less than the distance.
  [[nodiscard]] Tangents tangents_at(const core::Vec3& from_m, double range_m, double reach_m) const;

 private:
  [[nodiscard]] core::Vec3 from_line(const core::Vec3& point_m) const;

  double squint_sine_;
  double squint_cosine_;
  double ground_m_;  // height
  ReferenceTrack reference_;
  core::Vec3 ahead_, side_, down_;
  double range_m_ = 0.0;
};

}  // namespace sarsim::signal
