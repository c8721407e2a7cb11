#include "radar/motion/rotation.hpp"

#include <cmath>

namespace sarsim::radar {

namespace {

// [w]x m: what each column of m gains per second as it turns with the angular velocity w.
core::Mat3 turned(const core::Vec3& w, const core::Mat3& m) {
  return {{w.y * m.row[2] - w.z * m.row[1], w.z * m.row[0] - w.x * m.row[2], w.x * m.row[1] - w.y * m.row[0]}};
}

// A rotation and the axes about which roll, pitch and yaw turn, world axes: Rz(-c) Ry(-b) x,
// Rz(-c) y, z.
struct Attitude {
  core::Mat3 world_from_platform;
  std::array<core::Vec3, 3> axes;
};

Attitude attitude_of(const std::array<double, 3>& angle) {
  const double sa = std::sin(angle[0]), ca = std::cos(angle[0]);
  const double sb = std::sin(angle[1]), cb = std::cos(angle[1]);
  const double sc = std::sin(angle[2]), cc = std::cos(angle[2]);
  const core::Vec3 x{cb, sb * sa, -sb * ca};  // rows of Ry(-b) Rx(-a)
  const core::Vec3 y{0.0, ca, sa};
  return {{{cc * x + sc * y, cc * y - sc * x, core::Vec3{sb, -cb * sa, cb * ca}}},
          {core::Vec3{cc * cb, -sc * cb, sb}, core::Vec3{sc, cc, 0.0}, core::Vec3{0.0, 0.0, 1.0}}};
}

// Sum of speeds about the axes; angles turn clockwise, seen from the tips of these.
core::Vec3 about(const std::array<core::Vec3, 3>& axes, const std::array<double, 3>& speed) {
  return -(speed[0] * axes[0] + speed[1] * axes[1] + speed[2] * axes[2]);
}

bool still(const std::array<double, 3>& rate) { return rate[0] == 0.0 && rate[1] == 0.0 && rate[2] == 0.0; }

constexpr core::Mat3 nothing{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};

core::Mat3 rate_of(const Attitude& attitude, const std::array<double, 3>& rate_rad_per_s) {
  if (still(rate_rad_per_s)) return nothing;
  return turned(about(attitude.axes, rate_rad_per_s), attitude.world_from_platform);
}

// w of the rate [w]x m of a rotation m.
core::Vec3 angular_velocity(const TurningMatrix& m) {
  const auto& turn = m.rate.row;
  const auto& row = m.matrix.row;
  return {core::dot(turn[2], row[1]), core::dot(turn[0], row[2]), core::dot(turn[1], row[0])};
}

}  // namespace

core::Mat3 world_from_platform(const std::array<double, 3>& rotation_rad) {
  return attitude_of(rotation_rad).world_from_platform;
}

core::Mat3 world_from_platform_rate(const std::array<double, 3>& rotation_rad,
                                    const std::array<double, 3>& rate_rad_per_s) {
  return rate_of(attitude_of(rotation_rad), rate_rad_per_s);
}

core::Mat3 world_from_platform_acceleration(const std::array<double, 3>& rotation_rad,
                                            const std::array<double, 3>& rate_rad_per_s,
                                            const std::array<double, 3>& acceleration_rad_per_s2) {
  if (still(rate_rad_per_s) && still(acceleration_rad_per_s2)) return nothing;
  const Attitude attitude = attitude_of(rotation_rad);
  const auto& axes = attitude.axes;
  const core::Vec3 w = about(axes, rate_rad_per_s);
  // Yaw turns the pitch axis, yaw and pitch the roll axis.
  const core::Vec3 yaw = -rate_rad_per_s[2] * axes[2];
  const core::Vec3 yaw_and_pitch = yaw - rate_rad_per_s[1] * axes[1];
  const core::Vec3 w_rate = about(axes, acceleration_rad_per_s2) - rate_rad_per_s[1] * core::cross(yaw, axes[1]) -
                            rate_rad_per_s[0] * core::cross(yaw_and_pitch, axes[0]);
  const core::Mat3& m = attitude.world_from_platform;
  return turned(w_rate, m) + turned(w, turned(w, m));
}

TurningMatrix turning_matrix(const std::array<double, 3>& rotation_rad, const std::array<double, 3>& rate_rad_per_s) {
  const Attitude attitude = attitude_of(rotation_rad);
  return {attitude.world_from_platform, rate_of(attitude, rate_rad_per_s)};
}

void set_turning_matrix(const std::array<double, 3>& rotation_rad, const std::array<double, 3>& rate_rad_per_s,
                        core::Mat3& matrix, core::Mat3& rate) {
  const Attitude attitude = attitude_of(rotation_rad);
  matrix = attitude.world_from_platform;
  rate = rate_of(attitude, rate_rad_per_s);
}

TurningMatrix operator*(const TurningMatrix& outer, const TurningMatrix& inner) {
  return {outer.matrix * inner.matrix, outer.rate * inner.matrix + outer.matrix * inner.rate};
}

// With the roll undone the y axis is level: (sin c, cos c, 0). So the yaw belongs to whatever roll was found.
std::array<double, 3> rotation_angles_rad(const core::Mat3& m) {
  const auto& [x, y, z] = m.row;
  const double level = std::hypot(z.y, z.z);
  const double roll = level > 0.0 ? std::atan2(-z.y, z.z) : 0.0;
  const double s = std::sin(roll), c = std::cos(roll);
  return {roll, std::atan2(z.x, level), std::atan2(c * x.y + s * x.z, c * y.y + s * y.z)};
}

// -w = a' Rz(-c) Ry(-b) x + b' Rz(-c) y + c' z.
std::array<double, 3> rotation_rates_rad_per_s(const TurningMatrix& world_from_platform,
                                               const std::array<double, 3>& rotation_rad) {
  const core::Vec3 u = -angular_velocity(world_from_platform);
  const double sb = std::sin(rotation_rad[1]), cb = std::cos(rotation_rad[1]);
  const double sc = std::sin(rotation_rad[2]), cc = std::cos(rotation_rad[2]);
  const double roll = cb > 1e-9 ? (cc * u.x - sc * u.y) / cb : 0.0;
  return {roll, sc * u.x + cc * u.y, u.z - sb * roll};
}

}  // namespace sarsim::radar
