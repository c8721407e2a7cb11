#pragma once

#include <cmath>

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// How Cartesian axes turn: evenly, about an axis that need not pass through their origin. Zeros: axes that rest.
struct TurningAxes {
  core::Vec3 rotation_rad_per_s;  ///< Vector w along the axis, right-handed, in these axes.
  core::Vec3 centre_m;            ///< C, any point of the axis, in these axes: the centre of the Earth.
};

/// Velocity at which turning axes carry a point that is fixed in them, as seen from axes that rest: w x (P - C).
[[nodiscard]] constexpr core::Vec3 carried_mps(const TurningAxes& axes, const core::Vec3& point_m) {
  return core::cross(axes.rotation_rad_per_s, point_m - axes.centre_m);
}

/// By how much light has farther to go from A to B than |B - A|, m, because the axes in which both are given turn while
/// it is under way (Sagnac); negative where B comes to meet it. A is taken as the light leaves, B as it arrives, each
/// in the axes of its own time.
///
/// In axes that rest and agree with the turning ones as the light leaves, with a = A - C and b = B - C, B is at
/// R(w tau) b as it arrives, and (c tau)^2 = |R(w tau) b - a|^2 = |b - a|^2 + 2 tau w.(a x b) + ... To the first order
/// in w, because a x a = 0,
///
///     c tau - |B - A| = w.(a x b)/c = (w x a).(B - A)/c
///
/// which has no cancellation: its rounding is 1e-15 of itself. With g for the result, d for |B - A| and va, vb for the
/// carried velocities, the second order that is left out is [g^2/d + d va.vb/c^2]/2. It is below d v^2/c^2, v the
/// larger speed: 1.3e-6 m of the 0.67 m to a satellite in low orbit, and nearly the same for all points of a scene.
/// `turning_way_m` has it.
/// @param carried_from_mps  `carried_mps` of A; that of B, or of any point of the line through A and B, gives the same
/// @param line_of_sight_m            B - A
[[nodiscard]] constexpr double sagnac_m(const core::Vec3& carried_from_mps, const core::Vec3& line_of_sight_m,
                                        double light_speed_mps) {
  return core::dot(carried_from_mps, line_of_sight_m) / light_speed_mps;
}

/// The same from the two points.
[[nodiscard]] constexpr double sagnac_m(const TurningAxes& axes, const core::Vec3& from_m, const core::Vec3& to_m,
                                        double light_speed_mps) {
  return sagnac_m(carried_mps(axes, from_m), to_m - from_m, light_speed_mps);
}

/// How far light goes from A to B in turning axes, c tau, m: `sagnac_m` with the second order. It solves
///
///     (c tau)^2 = d^2 + 2 g c tau + k (c tau)^2     g = sagnac_m     k = va.vb/c^2
///
/// for the price of the square root that the distance needs anyway. What is left out is g (w tau)^2/6: 5e-15 m to a
/// satellite in low orbit, 2e-10 m to a geostationary one. Rounding: 3e-16 of the way.
/// @param carried_from_mps  `carried_mps` of A
/// @param carried_to_mps    `carried_mps` of B
/// @param line_of_sight_m            B - A
[[nodiscard]] inline double turning_way_m(const core::Vec3& carried_from_mps, const core::Vec3& carried_to_mps,
                                          const core::Vec3& line_of_sight_m, double light_speed_mps) {
  const double g = sagnac_m(carried_from_mps, line_of_sight_m, light_speed_mps);
  const double still = 1.0 - core::dot(carried_from_mps, carried_to_mps) / (light_speed_mps * light_speed_mps);
  return (g + std::sqrt(g * g + core::dot(line_of_sight_m, line_of_sight_m) * still)) / still;
}

/// The same from the two points.
[[nodiscard]] inline double turning_way_m(const TurningAxes& axes, const core::Vec3& from_m, const core::Vec3& to_m,
                                          double light_speed_mps) {
  return turning_way_m(carried_mps(axes, from_m), carried_mps(axes, to_m), to_m - from_m, light_speed_mps);
}

}  // namespace sarsim::radar
