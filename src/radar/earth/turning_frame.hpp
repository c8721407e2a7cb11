#pragma once

#include "core/maths/vector.hpp"
#include "radar/earth/instant.hpp"

namespace sarsim::radar {

/// How the Earth lies in its own turning, as IERS publishes it (Bulletin A, finals2000A). Zeros move a whole orbit over
/// the ground: 0.1 s of dUT1 is 52 m and 0.4" of the pole 14 m at 7071 km; the motion stays the same.
struct EarthOrientation {
  double dut1_s = 0.0;       ///< UT1 - UTC.
  double polar_x_rad = 0.0;  ///< Of the pole, along the meridian of Greenwich.
  double polar_y_rad = 0.0;  ///< Along 90 deg west.
};

/// Place and velocity of a point, in the axes that the variable's name says.
struct StateVector {
  core::Vec3 position_m;
  core::Vec3 velocity_mps;
};

/// The rotation from one set of axes to another at one moment, and how it changes.
struct TurningFrame {
  core::Mat3 rotation;
  core::Mat3 rate_per_s{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};

  /// To the other axes: r' = R r, v' = R v + (dR/dt) r. For axes fixed to the Earth the second term is -w x r'.
  [[nodiscard]] StateVector to(const StateVector& state) const;
  /// And back.
  [[nodiscard]] StateVector back(const StateVector& state) const;
};

/// One after the other: a is applied behind b.
[[nodiscard]] TurningFrame operator*(const TurningFrame& a, const TurningFrame& b);

/// Angle by which the Earth has turned since J2000, against the origin on the celestial equator that does not turn, rad
/// in [0, 2 pi): ERA = 2 pi (0.7790572732640 + 1.00273781191135448 Tu), Tu the UT1 days since 2000-01-01 12 h (IERS
/// Conventions 2010, 5.15). Within 9e-16 rad for the UT1 given.
[[nodiscard]] double earth_rotation_angle_rad(const Instant& instant, double dut1_s = 0.0);

/// Its rate, rad/s of UT1.
inline constexpr double earth_rotation_angle_rate_rad_per_s = 7.292115146706979e-5;

/// Greenwich mean sidereal time of the IAU in 1982, rad in [0, 2 pi): the UT1 of the day and 24110.54841 s +
/// 8640184.812866 s T + 0.093104 s T^2 - 6.2e-6 s T^3, T the UT1 centuries since J2000 (Aoki et al. 1982). Within 9e-16
/// rad for the UT1 given.
[[nodiscard]] double gmst82_rad(const Instant& instant, double dut1_s = 0.0);

/// Its rate, rad/s of UT1: that of the Earth and that of the mean equinox.
[[nodiscard]] double gmst82_rate_rad_per_s(const Instant& instant, double dut1_s = 0.0);

/// From TEME, the axes of SGP4 (true equator, mean equinox), to axes fixed to the Earth (ECEF, ITRF):
/// W R3(GMST82), W the motion of the pole. Rounding below 5e-9 m at 7e6 m.
///
/// The rate is that of the angle, so that velocities are the derivatives of positions; the rate of the Earth, which
/// Vallado uses, is 7.1e-12 rad/s less, 5e-5 m/s in low orbit. The drift of TEME itself is not taken out: SGP4 does not
/// know of it.
[[nodiscard]] TurningFrame ecef_from_teme(const Instant& instant, const EarthOrientation& orientation = {});

/// Rotation about the z axis of the axes, by which a vector's angle becomes less: R3.
[[nodiscard]] core::Mat3 turned_about_z(double angle_rad);

/// R3(angle) while the angle grows at the given rate.
[[nodiscard]] TurningFrame turning_about_z(double angle_rad, double rate_rad_per_s);

/// Motion of the pole, W = R1(-y) R2(-x), from the axes of the pole of rotation to those of the Earth's crust.
[[nodiscard]] core::Mat3 polar_motion(const EarthOrientation& orientation);

}  // namespace sarsim::radar
