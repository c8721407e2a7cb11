#include "radar/orbit/steering.hpp"

#include <cmath>

namespace sarsim::radar {

namespace {

using core::Mat3;
using core::Vec3;

// A vector and its derivative in time.
struct MovingVector {
  Vec3 value;
  Vec3 rate;
};

MovingVector cross(const MovingVector& a, const MovingVector& b) {
  return {core::cross(a.value, b.value), core::cross(a.rate, b.value) + core::cross(a.value, b.rate)};
}

// The unit vector; for the null vector the fallback.
MovingVector unit(const MovingVector& v, const Vec3& fallback) {
  const double length = core::norm(v.value);
  if (!(length > 0.0)) return {fallback, {}};
  const Vec3 direction = (1.0 / length) * v.value;
  const Vec3 rate = (1.0 / length) * v.rate;
  return {direction, rate - core::dot(direction, rate) * direction};
}

// Some unit vector at a right angle to another one.
Vec3 beside(const Vec3& v) {
  const Vec3 axis = std::abs(v.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 normal = core::cross(v, axis);
  return (1.0 / core::norm(normal)) * normal;
}

OrbitAttitude attitude_of(const MovingVector& x, const MovingVector& y, const MovingVector& z) {
  return {core::transposed(Mat3{{x.value, y.value, z.value}}), core::transposed(Mat3{{x.rate, y.rate, z.rate}})};
}

OrbitAttitude with_exact_x(const MovingVector& ahead, const MovingVector& down) {
  const MovingVector x = unit(ahead, {1.0, 0.0, 0.0});
  const MovingVector y = unit(cross(down, x), beside(x.value));
  return attitude_of(x, y, cross(x, y));
}

OrbitAttitude with_exact_z(const MovingVector& ahead, const MovingVector& down) {
  const MovingVector z = unit(down, {0.0, 0.0, -1.0});
  const MovingVector y = unit(cross(z, ahead), beside(z.value));
  return attitude_of(cross(y, z), y, z);
}

MovingVector velocity_of(const OrbitMotion& motion, const TurningAxes& earth, FlightDirection flight) {
  if (flight == FlightDirection::earth_fixed) return {motion.velocity_mps, motion.acceleration_mps2};
  return {inertial_velocity_mps(motion, earth),
          motion.acceleration_mps2 + core::cross(earth.rotation_rad_per_s, motion.velocity_mps)};
}

MovingVector down_from(const OrbitMotion& motion, const TurningAxes& earth) {
  return unit({earth.centre_m - motion.position_m, -motion.velocity_mps}, {0.0, 0.0, -1.0});
}

// The attitude after a turn in the platform: rotation and its derivative by the angle.
OrbitAttitude turned(const OrbitAttitude& attitude, const Mat3& turn, const Mat3& turn_by_angle,
                     double rate_rad_per_s) {
  return {attitude.world_from_platform * turn,
          attitude.world_from_platform_rate * turn + rate_rad_per_s * (attitude.world_from_platform * turn_by_angle)};
}

}  // namespace

core::Vec3 inertial_velocity_mps(const OrbitMotion& motion, const TurningAxes& earth) {
  return motion.velocity_mps + carried_mps(earth, motion.position_m);
}

OrbitAttitude zero_doppler_attitude(const OrbitMotion& motion, const TurningAxes& earth, FlightDirection flight) {
  return with_exact_x(velocity_of(motion, earth, flight), down_from(motion, earth));
}

OrbitAttitude nadir_attitude(const OrbitMotion& motion, const TurningAxes& earth, FlightDirection flight) {
  return with_exact_z(velocity_of(motion, earth, flight), down_from(motion, earth));
}

OrbitAttitude look_at_attitude(const OrbitMotion& motion, const OrbitMotion& target) {
  const MovingVector sight{target.position_m - motion.position_m, target.velocity_mps - motion.velocity_mps};
  return with_exact_z({motion.velocity_mps, motion.acceleration_mps2}, sight);
}

OrbitAttitude rolled(const OrbitAttitude& attitude, const TurningAngle& roll) {
  const double s = std::sin(roll.angle_rad), c = std::cos(roll.angle_rad);
  return turned(attitude, {{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, c, -s}, Vec3{0.0, s, c}}},
                {{Vec3{}, Vec3{0.0, -s, -c}, Vec3{0.0, c, -s}}}, roll.rate_rad_per_s);
}

OrbitAttitude pitched(const OrbitAttitude& attitude, const TurningAngle& pitch) {
  const double s = std::sin(pitch.angle_rad), c = std::cos(pitch.angle_rad);
  return turned(attitude, {{Vec3{c, 0.0, s}, Vec3{0.0, 1.0, 0.0}, Vec3{-s, 0.0, c}}},
                {{Vec3{-s, 0.0, c}, Vec3{}, Vec3{-c, 0.0, -s}}}, pitch.rate_rad_per_s);
}

OrbitAttitude yawed(const OrbitAttitude& attitude, const TurningAngle& yaw) {
  const double s = std::sin(yaw.angle_rad), c = std::cos(yaw.angle_rad);
  return turned(attitude, {{Vec3{c, -s, 0.0}, Vec3{s, c, 0.0}, Vec3{0.0, 0.0, 1.0}}},
                {{Vec3{-s, -c, 0.0}, Vec3{c, -s, 0.0}, Vec3{}}}, yaw.rate_rad_per_s);
}

OrbitAttitude with_z_up(const OrbitAttitude& attitude) {
  constexpr Mat3 half_roll{{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, -1.0, 0.0}, Vec3{0.0, 0.0, -1.0}}};
  return {attitude.world_from_platform * half_roll, attitude.world_from_platform_rate * half_roll};
}

double yaw_steering_rad(double inclination_rad, double latitude_argument_rad, double motion_by_rotation) {
  return -std::atan2(std::sin(inclination_rad) * std::cos(latitude_argument_rad),
                     motion_by_rotation - std::cos(inclination_rad));
}

}  // namespace sarsim::radar
