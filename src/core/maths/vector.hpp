#pragma once

#include <array>
#include <cmath>

namespace sarsim::core {

/// Three Cartesian coordinates; the variable's name says the frame and the unit.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// A 3 x 3 matrix by rows; as a rotation named to_from_from: `world_from_platform`.
struct Mat3 {
  std::array<Vec3, 3> row{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};

  friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

constexpr Vec3 operator*(const Mat3& m, const Vec3& v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
constexpr Mat3 transposed(const Mat3& m) {
  return {{Vec3{m.row[0].x, m.row[1].x, m.row[2].x}, Vec3{m.row[0].y, m.row[1].y, m.row[2].y},
           Vec3{m.row[0].z, m.row[1].z, m.row[2].z}}};
}
/// The product of two matrices: b is applied first.
constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 columns = transposed(b);
  Mat3 product;
  for (std::size_t i = 0; i < 3; ++i) product.row[i] = columns * a.row[i];
  return product;
}
constexpr Mat3 operator+(const Mat3& a, const Mat3& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
constexpr Mat3 operator*(double s, const Mat3& a) { return {{s * a.row[0], s * a.row[1], s * a.row[2]}}; }

/// Azimuth of a direction, rad: from +y clockwise towards +x, in (-pi, pi]; 0 for a vertical vector (thesis 4.1.1).
inline double azimuth_rad(const Vec3& v) { return (v.x == 0.0 && v.y == 0.0) ? 0.0 : std::atan2(v.x, v.y); }

/// Elevation of a direction above the x-y plane, rad, in [-pi/2, pi/2]; 0 for the null vector.
inline double elevation_rad(const Vec3& v) { return std::atan2(v.z, std::hypot(v.x, v.y)); }

/// Unit vector with the given azimuth and elevation.
inline Vec3 direction(double azimuth_rad, double elevation_rad) {
  return {std::sin(azimuth_rad) * std::cos(elevation_rad), std::cos(azimuth_rad) * std::cos(elevation_rad),
          std::sin(elevation_rad)};
}

}  // namespace sarsim::core
