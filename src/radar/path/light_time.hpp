#pragma once

#include <cmath>

#include "core/maths/vector.hpp"
#include "radar/path/path.hpp"

namespace sarsim::radar {

/// How the path of an echo is computed.
enum class LightTime {
  exact,   ///< Points at the time at which the pulse meets them, the radar at reception: `flight_of`.
  thesis,  ///< Everything at the time at which the pulse leaves: `thesis_flight_of`.
};

/// How a point and a radar move while a pulse is under way. World axes; times are measured from the sending of the
/// pulse's middle.
struct FlightMotion {
  core::Vec3 point_mps = {};  ///< Velocity of the point where the pulse meets it.
  double anchor_s = 0.0;      ///< When the point is at the end of the look vector: near the time at which it is met.
  core::Vec3 radar_mps = {};  ///< Mean velocity of the radar from sending to about reception,
  core::Vec3 radar_slope_mps = {};  ///< and the mean of its velocities at both; differs if it jumps or jerks.
  // For `bend_of` and `bend` alone:
  core::Vec3 point_mps2 = {};  ///< Acceleration of the point,
  core::Vec3 radar_mps2 = {};  ///< and of the radar.
  double back_s = 0.0;         ///< About when the echo is back: the end of the time of `radar_mps`.
};

/// A pulse's path to a point and back.
struct Flight {
  core::Vec3 line_of_sight_m;  ///< From the radar as it sends to the point as it is met.
  Path path;                   ///< c (t1 - t0) and c (t2 - t1).
  double delay_s = 0.0;        ///< t2 - t0.
  double doppler = 0.0;  ///< D: what is received at t2 + u was sent at t0 + (1 - D) u. 2 v/(c + v) for a point that
                         ///< recedes at v along the line of sight.
};

/// Solves the two-way light-time equation, |P(t1) - X(t0)| = c (t1 - t0) and |X(t2) - P(t1)| = c (t2 - t1), for a point
/// and a radar that move evenly around these times. In closed form, exact to rounding: with b = V/c, w = W/c and the
/// look r to the point's place at t0,
///
///     d1 = [r.b + sqrt((r.b)^2 + r^2 (1 - b^2))]/(1 - b^2)     r1 = r + d1 b      c tau = 2 (d1 - r1.w)/(1 - w^2)
///     1 - D = (1 - u1.b)(1 - u2.w)/[(1 - u1.w)(1 - u2.b)]      u1 = r1/d1         u2 = (c tau w - r1)/d2
///
/// The delay takes w from `radar_mps`, the stretch takes it from `radar_slope_mps`. Speeds must be below that of light;
/// a look of length 0 gives a path of length 0 and D = 0/0.
/// @param line_of_sight_m  from the radar at sending to the point at its anchor time
[[nodiscard]] inline Flight flight_of(const core::Vec3& line_of_sight_m, const FlightMotion& motion,
                                      double light_speed_mps) {
  const core::Vec3 b = (1.0 / light_speed_mps) * motion.point_mps;
  const core::Vec3 way = (1.0 / light_speed_mps) * motion.radar_mps;
  const core::Vec3 w = (1.0 / light_speed_mps) * motion.radar_slope_mps;
  const core::Vec3 r = line_of_sight_m - motion.anchor_s * motion.point_mps;
  const double rb = core::dot(r, b);
  const double still = 1.0 - core::dot(b, b);
  Flight flight;
  flight.path.out_m = (rb + std::sqrt(rb * rb + core::dot(r, r) * still)) / still;
  flight.line_of_sight_m = r + flight.path.out_m * b;
  const double length_m =
      2.0 * (flight.path.out_m - core::dot(flight.line_of_sight_m, way)) / (1.0 - core::dot(way, way));
  flight.path.back_m = length_m - flight.path.out_m;
  flight.delay_s = length_m / light_speed_mps;
  const double out_w = core::dot(flight.line_of_sight_m, w) / flight.path.out_m;
  const double out_b = core::dot(flight.line_of_sight_m, b) / flight.path.out_m;
  const core::Vec3 home_m = length_m * way - flight.line_of_sight_m;
  const double home_w = core::dot(home_m, w) / flight.path.back_m;
  const double home_b = core::dot(home_m, b) / flight.path.back_m;
  flight.doppler =
      (out_b - home_b + (home_w - out_w) + (out_w * home_b - out_b * home_w)) / ((1.0 - out_w) * (1.0 - home_b));
  return flight;
}

/// `flight_of` to a point that rests, b = 0: the same to rounding, and faster.
[[nodiscard]] inline Flight flight_to_resting(const core::Vec3& line_of_sight_m, const core::Vec3& radar_mps,
                                              const core::Vec3& radar_slope_mps, double light_speed_mps) {
  const double per_light = 1.0 / light_speed_mps;
  const core::Vec3 way = per_light * radar_mps;
  Flight flight;
  flight.line_of_sight_m = line_of_sight_m;
  flight.path.out_m = core::norm(line_of_sight_m);
  const double length_m = 2.0 * (flight.path.out_m - core::dot(line_of_sight_m, way)) / (1.0 - core::dot(way, way));
  flight.path.back_m = length_m - flight.path.out_m;
  flight.delay_s = length_m / light_speed_mps;
  const double out_w = per_light * core::dot(line_of_sight_m, radar_slope_mps) / flight.path.out_m;
  const double home_w = per_light * core::dot(length_m * way - line_of_sight_m, radar_slope_mps) / flight.path.back_m;
  flight.doppler = (home_w - out_w) / (1.0 - out_w);
  return flight;
}

/// The flight of the thesis (6.9), as the programs of 1998 had it: everything counts where it is when the pulse leaves,
/// tau = 2 d/(c - v), D = 2 v/c.
/// @param velocity_mps  of the point relative to the radar
[[nodiscard]] inline Flight thesis_flight_of(const core::Vec3& line_of_sight_m, const core::Vec3& velocity_mps,
                                             double light_speed_mps) {
  const double distance_m = core::norm(line_of_sight_m);
  const double speed_mps = distance_m > 0.0 ? core::dot(line_of_sight_m, velocity_mps) / distance_m : 0.0;
  const Path path = there_and_back(distance_m);
  return {line_of_sight_m, path, moving_delay_of(path, speed_mps, light_speed_mps),
          delay_of(speed_mps, light_speed_mps)};
}

/// Speed at which a point recedes along the line of sight whose echo has the Doppler factor D, m/s: c D/(2 - D).
[[nodiscard]] constexpr double speed_of_doppler_factor(double doppler, double light_speed_mps) {
  return light_speed_mps * doppler / (2.0 - doppler);
}

/// The rate at which the delay's own rate changes, 1/s: 2/c times the second derivative of the distance,
/// (V^2 - v^2)/d + u.a. To the first order in speed over c of itself.
/// @param line_of_sight_m  from the radar to the point
[[nodiscard]] inline double bend_of(const core::Vec3& line_of_sight_m, const FlightMotion& motion,
                                    double light_speed_mps) {
  const core::Vec3 velocity_mps = motion.point_mps - motion.radar_slope_mps;
  const double distance2 = core::dot(line_of_sight_m, line_of_sight_m);
  const double along = core::dot(line_of_sight_m, velocity_mps);
  const double curvature = core::dot(velocity_mps, velocity_mps) - along * along / distance2;
  const double by_motion = core::dot(line_of_sight_m, motion.point_mps2 - motion.radar_mps2);
  return delay_of((curvature + by_motion) / std::sqrt(distance2), light_speed_mps);
}

/// Adds what accelerations contribute to a flight whose times differ from those of its motion: with e = t1 minus the
/// anchor time and g = tau minus `back_s`,
///
///     c tau:  u.a_P e^2 - u.a_R tau g/2        D:  (2 u.a_P e - u.a_R g)/c
///
/// so that a platform of any size may share its anchor; what is left is of third order in e and g.
inline void bend(Flight& flight, const FlightMotion& motion, double light_speed_mps) {
  const core::Vec3 towards = (1.0 / flight.path.out_m) * flight.line_of_sight_m;
  const double early_s = flight.path.out_m / light_speed_mps - motion.anchor_s;
  const double late_s = flight.delay_s - motion.back_s;
  const double of_point = core::dot(towards, motion.point_mps2) * early_s;
  const double of_radar = core::dot(towards, motion.radar_mps2) * late_s;
  flight.delay_s += (of_point * early_s - 0.5 * of_radar * flight.delay_s) / light_speed_mps;
  flight.doppler += (2.0 * of_point - of_radar) / light_speed_mps;
}

}  // namespace sarsim::radar
