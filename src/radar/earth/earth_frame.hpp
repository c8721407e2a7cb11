#pragma once

#include <array>

#include "core/maths/vector.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "radar/earth/extended.hpp"
#include "radar/earth/sagnac.hpp"

namespace sarsim::radar {

/// Where the world frame of a scene lies on the Earth.
struct Anchor {
  Geodetic origin;  ///< The world's origin. At a pole the longitude still says which way is north.
  /// Direction of the world's +y axis, clockwise from north as seen from above. At 0 x is east and y is north; at pi/2
  /// y is east and x is south. A direction of azimuth `core::azimuth_rad` in the world has that plus the heading over
  /// the ground at the anchor.
  double heading_rad = 0.0;

  friend constexpr bool operator==(const Anchor&, const Anchor&) = default;
};

/// The one place where the Earth becomes a Cartesian world: right-handed, Earth-fixed axes with their origin at the
/// anchor, z up along the ellipsoid's normal, x and y in the tangent plane, turned by the heading. The tangent plane is
/// d^2/(2 R) above the ellipsoid: 0.8 m at 3.2 km, 785 m at 100 km.
///
/// Precision: a double has 9.3e-10 m at 7e6 m from the Earth's centre and 1.2e-10 m at 8e5 m from the anchor. The frame
/// computes in extended precision and rounds once, so that `world_of` and `geodetic_of` never pass through rounded ECEF
/// coordinates: what they lose is the rounding of their result. What is given or wanted in ECEF carries the rounding of
/// these numbers themselves, up to 4.7e-10 m for each coordinate (3.2e-10 m rms in a range).
class EarthFrame {
 public:
  /// The world at an anchor; all its numbers must be finite and the latitude within +-pi/2.
  explicit EarthFrame(const Anchor& anchor);

  /// What the frame was made from.
  [[nodiscard]] const Anchor& anchor() const { return anchor_; }

  /// World coordinates of an Earth-fixed point, m: exact to the rounding of the result for the doubles given, which
  /// themselves are good to 4.7e-10 m each.
  [[nodiscard]] core::Vec3 world_from_ecef(const core::Vec3& ecef_m) const;
  /// And back; the result is rounded to the doubles of ECEF, 4.7e-10 m.
  [[nodiscard]] core::Vec3 ecef_from_world(const core::Vec3& world_m) const;

  /// World axes of a vector that has no place: a velocity relative to the turning Earth, an acceleration, a direction.
  /// Unit as given; relative error 4e-16.
  [[nodiscard]] core::Vec3 world_axes_from_ecef(const core::Vec3& vector_ecef) const;
  /// And back.
  [[nodiscard]] core::Vec3 ecef_axes_from_world(const core::Vec3& vector_world) const;

  /// World coordinates of a place, m: the true difference to the anchor for the doubles given, within 1e-11 m and the
  /// rounding of the result up to 1e7 m from the centre.
  [[nodiscard]] core::Vec3 world_of(const Geodetic& place) const;
  /// The place of a point; accuracy as of radar::geodetic_of.
  [[nodiscard]] Geodetic geodetic_of(const core::Vec3& world_m) const;

  /// Axes at a place, east, north and up: the columns are these in world axes. It turns a vector in local axes to the
  /// world; transposed it turns back. Entries within 2e-16.
  [[nodiscard]] core::Mat3 world_from_enu(const Geodetic& place) const;

  /// How the world turns: the Earth's rotation vector and its centre in world coordinates, for `sagnac_m`.
  [[nodiscard]] const TurningAxes& turning() const { return turning_; }
  /// Velocity of a point over axes that do not turn and agree with the world's at this moment: v + w x (P - C), m/s.
  [[nodiscard]] core::Vec3 inertial_velocity_mps(const core::Vec3& world_m, const core::Vec3& velocity_mps) const;
  /// The velocity over the turning Earth of a point with that inertial velocity: v - w x (P - C), m/s.
  [[nodiscard]] core::Vec3 fixed_velocity_mps(const core::Vec3& world_m, const core::Vec3& inertial_mps) const;

 private:
  Anchor anchor_;
  ExtendedVec3 origin_ecef_m_;
  std::array<ExtendedVec3, 3> axes_ecef_;  // the world's x, y and z axis
  TurningAxes turning_;
};

}  // namespace sarsim::radar
