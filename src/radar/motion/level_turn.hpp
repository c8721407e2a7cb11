#pragma once

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

/// Standard acceleration of gravity, exact by definition (CGPM 1901), m/s^2.
inline constexpr double standard_gravity_mps2 = 9.80665;

/// Radius of a level, coordinated turn: v^2/(g tan bank), m; the bank between 0 and 90 degrees.
inline double turn_radius_m(double speed_mps, double bank_rad) {
  return speed_mps * speed_mps / (standard_gravity_mps2 * std::tan(bank_rad));
}

/// The bank of a level, coordinated turn of that radius, rad.
inline double turn_bank_rad(double speed_mps, double radius_m) {
  return std::atan2(speed_mps * speed_mps, standard_gravity_mps2 * radius_m);
}

/// Lift over weight in such a turn: 1/cos bank.
inline double load_factor(double bank_rad) { return 1.0 / std::cos(bank_rad); }

/// An angle brought between -pi and pi by whole turns; half a turn is +pi.
inline double half_turn_angle_rad(double angle_rad) {
  const double rest = std::remainder(angle_rad, 2.0 * core::pi);
  return rest <= -core::pi ? core::pi : rest;
}

}  // namespace sarsim::radar
