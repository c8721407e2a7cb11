#pragma once

#include <array>
#include <cmath>

#include "core/maths/vector.hpp"

namespace sarsim::radar {

/// Three Cartesian coordinates in extended precision; the variable's name says the frame and the unit. A long double
/// has 64 bits of mantissa on x86-64 and 113 on AArch64 under Linux: 5e-13 m or less at the radius of the Earth, where
/// a double has 9e-10 m.
struct ExtendedVec3 {
  long double x = 0.0L;
  long double y = 0.0L;
  long double z = 0.0L;
};

/// A vector in extended precision, without rounding.
[[nodiscard]] inline ExtendedVec3 extended(const core::Vec3& v) { return {v.x, v.y, v.z}; }

/// A vector rounded to doubles, once for each coordinate.
[[nodiscard]] inline core::Vec3 rounded(const ExtendedVec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline ExtendedVec3 operator+(const ExtendedVec3& a, const ExtendedVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline ExtendedVec3 operator-(const ExtendedVec3& a, const ExtendedVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline ExtendedVec3 operator*(long double s, const ExtendedVec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline long double dot(const ExtendedVec3& a, const ExtendedVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The sine and the cosine of an angle in extended precision.
struct ExtendedTurn {
  long double sine = 0.0L;
  long double cosine = 1.0L;
};

/// Both of an angle that is given as a double.
[[nodiscard]] inline ExtendedTurn extended_turn(double angle_rad) {
  return {std::sin(static_cast<long double>(angle_rad)), std::cos(static_cast<long double>(angle_rad))};
}

}  // namespace sarsim::radar
