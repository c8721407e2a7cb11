#include "radar/motion/track.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

// Elementary right-handed rotations about x, y, z and their derivatives with respect to the angle.
std::array<core::Mat3, 3> elementary(const std::array<double, 3>& a) {
  const double s1 = std::sin(a[0]), c1 = std::cos(a[0]);
  const double s2 = std::sin(a[1]), c2 = std::cos(a[1]);
  const double s3 = std::sin(a[2]), c3 = std::cos(a[2]);
  return {core::Mat3{{core::Vec3{1, 0, 0}, core::Vec3{0, c1, -s1}, core::Vec3{0, s1, c1}}},
          core::Mat3{{core::Vec3{c2, 0, s2}, core::Vec3{0, 1, 0}, core::Vec3{-s2, 0, c2}}},
          core::Mat3{{core::Vec3{c3, -s3, 0}, core::Vec3{s3, c3, 0}, core::Vec3{0, 0, 1}}}};
}

std::array<core::Mat3, 3> elementary_slopes(const std::array<double, 3>& a) {
  const double s1 = std::sin(a[0]), c1 = std::cos(a[0]);
  const double s2 = std::sin(a[1]), c2 = std::cos(a[1]);
  const double s3 = std::sin(a[2]), c3 = std::cos(a[2]);
  return {core::Mat3{{core::Vec3{}, core::Vec3{0, -s1, -c1}, core::Vec3{0, c1, -s1}}},
          core::Mat3{{core::Vec3{-s2, 0, c2}, core::Vec3{}, core::Vec3{-c2, 0, -s2}}},
          core::Mat3{{core::Vec3{-s3, -c3, 0}, core::Vec3{c3, -s3, 0}, core::Vec3{}}}};
}

// Second derivatives with respect to the angle: the entries that turn, negated; the axis does not turn.
std::array<core::Mat3, 3> elementary_curvatures(const std::array<double, 3>& a) {
  std::array<core::Mat3, 3> r = elementary(a);
  r[0].row[0].x = r[1].row[1].y = r[2].row[2].z = 0.0;
  for (core::Mat3& m : r) m = -1.0 * m;
  return r;
}

bool moves(const core::Interpolator& function) { return function.knots().size() > 1; }

bool is_fixed(const Motion& motion) {
  for (std::size_t i = 0; i < 3; ++i)
    if (moves(motion.position_m[i]) || moves(motion.rotation_rad[i]) || motion.rotation_rate_rad_per_s[i] != 0.0 ||
        motion.position_stddev_m[i] != 0.0 || motion.rotation_stddev_rad[i] != 0.0 ||
        moves(motion.position_envelope[i]) || moves(motion.rotation_envelope[i]))
      return false;
  return true;
}

// Adds the angles that turn the x axis along the velocity, and their rates (thesis 4.3).
void align(Pose& pose, const core::Vec3& v, const core::Vec3& a) {
  const double level = std::hypot(v.x, v.y);
  const double speed2 = core::dot(v, v);
  pose.rotation_rad[1] += core::elevation_rad(v);
  pose.rotation_rad[2] += core::azimuth_rad(v) - core::pi / 2.0;
  if (level <= 0.0) return;
  const double level_rate = (v.x * a.x + v.y * a.y) / level;
  pose.rotation_rate_rad_per_s[1] += (level * a.z - v.z * level_rate) / speed2;
  pose.rotation_rate_rad_per_s[2] += (v.y * a.x - v.x * a.y) / (level * level);
}

// Rates of change of the rates that align adds, about y and z, for the jerk j. With L = hypot(vx, vy):
//     el' = (L az - vz L')/v^2     az' = (vy ax - vx ay)/L^2
// and the derivatives of numerators and denominators, L L' = vx ax + vy ay, L L'' = ax^2 + ay^2 + vx jx + vy jy - L'^2.
std::array<double, 2> aligned_accelerations(const core::Vec3& v, const core::Vec3& a, const core::Vec3& j) {
  const double level = std::hypot(v.x, v.y);
  if (level <= 0.0) return {};
  const double speed2 = core::dot(v, v);
  const double level_rate = (v.x * a.x + v.y * a.y) / level;
  const double level_acceleration = (a.x * a.x + a.y * a.y + v.x * j.x + v.y * j.y - level_rate * level_rate) / level;
  const double elevation_rate = (level * a.z - v.z * level_rate) / speed2;
  const double azimuth_rate = (v.y * a.x - v.x * a.y) / (level * level);
  return {(level * j.z - v.z * level_acceleration - 2.0 * elevation_rate * core::dot(v, a)) / speed2,
          (v.y * j.x - v.x * j.y - 2.0 * azimuth_rate * level * level_rate) / (level * level)};
}

core::Vec3 third_derivative(const std::array<core::Interpolator, 3>& path, double time_s) {
  return {path[0].third_derivative(time_s), path[1].third_derivative(time_s), path[2].third_derivative(time_s)};
}

}  // namespace

core::Mat3 world_from_platform(const std::array<double, 3>& rotation_rad) {
  const auto r = elementary(rotation_rad);
  return core::transposed(r[0] * r[1] * r[2]);
}

core::Mat3 world_from_platform_rate(const std::array<double, 3>& rotation_rad,
                                    const std::array<double, 3>& rate_rad_per_s) {
  const auto r = elementary(rotation_rad);
  const auto d = elementary_slopes(rotation_rad);
  return core::transposed(rate_rad_per_s[0] * (d[0] * r[1] * r[2]) + rate_rad_per_s[1] * (r[0] * d[1] * r[2]) +
                          rate_rad_per_s[2] * (r[0] * r[1] * d[2]));
}

core::Mat3 world_from_platform_acceleration(const std::array<double, 3>& rotation_rad,
                                            const std::array<double, 3>& rate_rad_per_s,
                                            const std::array<double, 3>& acceleration_rad_per_s2) {
  const auto r = elementary(rotation_rad);
  auto first = elementary_slopes(rotation_rad);
  auto second = elementary_curvatures(rotation_rad);
  for (std::size_t i = 0; i < 3; ++i) {
    const double rate = rate_rad_per_s[i];
    second[i] = (rate * rate) * second[i] + acceleration_rad_per_s2[i] * first[i];
    first[i] = rate * first[i];
  }
  const core::Mat3 crossed = first[0] * first[1] * r[2] + first[0] * r[1] * first[2] + r[0] * first[1] * first[2];
  return core::transposed(second[0] * r[1] * r[2] + r[0] * second[1] * r[2] + r[0] * r[1] * second[2] + 2.0 * crossed);
}

Track::Track(Motion motion, std::uint64_t seed, const std::string& name)
    : motion_(std::move(motion)),
      position_noise_(seed, core::RandomKind::platform_position, core::name_key(name)),
      rotation_noise_(seed, core::RandomKind::platform_rotation, core::name_key(name)),
      fixed_(is_fixed(motion_)) {
  const core::RandomStream position(seed, core::RandomKind::position_envelope, core::name_key(name));
  const core::RandomStream rotation(seed, core::RandomKind::rotation_envelope, core::name_key(name));
  for (std::size_t i = 0; i < 3; ++i) {
    position_process_[i] = ErrorProcess(motion_.position_envelope[i], position, static_cast<int>(i));
    rotation_process_[i] = ErrorProcess(motion_.rotation_envelope[i], rotation, static_cast<int>(i));
  }
}

Pose Track::at(double time_s, std::int64_t pulse) const {
  Pose pose;
  add_path(pose, time_s);
  add_errors(pose, time_s, pulse);
  pose.world_from_platform = world_from_platform(pose.rotation_rad);
  pose.world_from_platform_rate = world_from_platform_rate(pose.rotation_rad, pose.rotation_rate_rad_per_s);
  return pose;
}

PoseAcceleration Track::acceleration_at(double time_s, std::int64_t pulse) const {
  return acceleration_at(time_s, at(time_s, pulse));
}

PoseAcceleration Track::acceleration_at(double time_s, const Pose& pose) const {
  const core::Jet x = motion_.position_m[0].jet(time_s);
  const core::Jet y = motion_.position_m[1].jet(time_s);
  const core::Jet z = motion_.position_m[2].jet(time_s);
  PoseAcceleration result;
  result.acceleration_world_mps2 = {x.curvature, y.curvature, z.curvature};
  std::array<double, 3> turning{};
  for (std::size_t i = 0; i < 3; ++i) turning[i] = motion_.rotation_rad[i].jet(time_s).curvature;
  if (motion_.aligned) {
    const auto [pitch, yaw] = aligned_accelerations({x.slope, y.slope, z.slope}, result.acceleration_world_mps2,
                                                    third_derivative(motion_.position_m, time_s));
    turning[1] += pitch;
    turning[2] += yaw;
  }
  result.world_from_platform_acceleration =
      world_from_platform_acceleration(pose.rotation_rad, pose.rotation_rate_rad_per_s, turning);
  return result;
}

void Track::add_path(Pose& pose, double time_s) const {
  const core::Jet x = motion_.position_m[0].jet(time_s);
  const core::Jet y = motion_.position_m[1].jet(time_s);
  const core::Jet z = motion_.position_m[2].jet(time_s);
  pose.position_world_m = {x.value, y.value, z.value};
  pose.velocity_world_mps = {x.slope, y.slope, z.slope};
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Jet angle = motion_.rotation_rad[i].jet(time_s);
    pose.rotation_rad[i] = angle.value + motion_.rotation_rate_rad_per_s[i] * time_s;
    pose.rotation_rate_rad_per_s[i] = angle.slope + motion_.rotation_rate_rad_per_s[i];
  }
  if (motion_.aligned) align(pose, pose.velocity_world_mps, {x.curvature, y.curvature, z.curvature});
}

void Track::add_errors(Pose& pose, double time_s, std::int64_t pulse) const {
  std::array<double, 3> shift{};
  std::array<double, 3> speed{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::int64_t>(i);
    if (motion_.position_stddev_m[i] != 0.0)
      shift[i] += motion_.position_stddev_m[i] * position_noise_.normals(pulse, axis)[0];
    if (motion_.rotation_stddev_rad[i] != 0.0)
      pose.rotation_rad[i] += motion_.rotation_stddev_rad[i] * rotation_noise_.normals(pulse, axis)[0];
    if (position_process_[i].active()) {
      const core::Jet deviation = position_process_[i].at(time_s);
      shift[i] += deviation.value;
      speed[i] += deviation.slope;
    }
    if (rotation_process_[i].active()) {
      const core::Jet deviation = rotation_process_[i].at(time_s);
      pose.rotation_rad[i] += deviation.value;
      pose.rotation_rate_rad_per_s[i] += deviation.slope;
    }
  }
  pose.position_world_m = pose.position_world_m + core::Vec3{shift[0], shift[1], shift[2]};
  pose.velocity_world_mps = pose.velocity_world_mps + core::Vec3{speed[0], speed[1], speed[2]};
}

}  // namespace sarsim::radar
