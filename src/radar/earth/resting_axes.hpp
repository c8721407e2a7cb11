#pragma once

#include "core/maths/vector.hpp"
#include "radar/earth/sagnac.hpp"

namespace sarsim::radar {

/// Turning axes as seen from axes that rest and agree with them at one moment: where light goes straight on. Points of
/// the turning axes are given as they are a short time later, and their motion in both is exchanged here.
///
/// With the rotation vector w, the centre C and the angle x = w t, the turning to the third order,
///
///     P' = P + d(P)    d(P) = t w x (P - C) + t^2/2 w x (w x (P - C)) + t^3/6 w x (w x (w x (P - C)))
///
/// leaves out x^4/24 of the distance to the centre: 1e-20 m for the 6 ms to a satellite in low orbit, 1e-14 m for the
/// 0.12 s to a geostationary one. The sum of small terms keeps the precision of coordinates near the world's origin.
class RestingAxes {
 public:
  /// @param elapsed_s  after the moment at which the axes agree
  RestingAxes(const TurningAxes& axes, double elapsed_s)
      : w_(axes.rotation_rad_per_s), centre_m_(axes.centre_m), t_(elapsed_s) {}

  /// A vector without a place, turned.
  [[nodiscard]] core::Vec3 turned(const core::Vec3& v) const { return v + by_turning(v); }
  /// The place of a point.
  [[nodiscard]] core::Vec3 position_m(const core::Vec3& point_m) const {
    return point_m + by_turning(point_m - centre_m_);
  }
  /// Its velocity: that in the turning axes and that of the turning.
  [[nodiscard]] core::Vec3 velocity_mps(const core::Vec3& point_m, const core::Vec3& velocity_mps) const {
    return turned(velocity_mps + core::cross(w_, point_m - centre_m_));
  }
  /// Its acceleration, Coriolis' and the centrifugal one undone: a + 2 w x v + w x (w x (P - C)).
  [[nodiscard]] core::Vec3 acceleration_mps2(const core::Vec3& point_m, const core::Vec3& velocity_mps,
                                             const core::Vec3& acceleration_mps2) const {
    return turned(acceleration_mps2 + 2.0 * core::cross(w_, velocity_mps) +
                  core::cross(w_, core::cross(w_, point_m - centre_m_)));
  }

  /// Platform axes and their derivatives: the same for the columns of a matrix, which are vectors without a place.
  /// @{
  [[nodiscard]] core::Mat3 axes(const core::Mat3& m) const {
    return columns(m, [&](const core::Vec3& v) { return turned(v); });
  }
  [[nodiscard]] core::Mat3 axes_rate(const core::Mat3& m, const core::Mat3& rate) const {
    return axes(rate + columns(m, [&](const core::Vec3& v) { return core::cross(w_, v); }));
  }
  [[nodiscard]] core::Mat3 axes_acceleration(const core::Mat3& m, const core::Mat3& rate,
                                             const core::Mat3& acceleration) const {
    return axes(acceleration + columns(rate, [&](const core::Vec3& v) { return 2.0 * core::cross(w_, v); }) +
                columns(m, [&](const core::Vec3& v) { return core::cross(w_, core::cross(w_, v)); }));
  }
  /// @}

 private:
  // What the turning adds to a vector from the centre.
  [[nodiscard]] core::Vec3 by_turning(const core::Vec3& r) const {
    const core::Vec3 first = t_ * core::cross(w_, r);
    const core::Vec3 second = 0.5 * t_ * core::cross(w_, first);
    const core::Vec3 third = (1.0 / 3.0) * t_ * core::cross(w_, second);
    return first + (second + third);
  }
  template <class Change>
  static core::Mat3 columns(const core::Mat3& m, const Change& change) {
    core::Mat3 t = core::transposed(m);
    for (core::Vec3& column : t.row) column = change(column);
    return core::transposed(t);
  }

  core::Vec3 w_;
  core::Vec3 centre_m_;
  double t_;
};

}  // namespace sarsim::radar
