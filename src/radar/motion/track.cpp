#include "radar/motion/track.hpp"

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {

namespace {

// [w]x m: what each column of m gains per second as it turns with the angular velocity w.
core::Mat3 turned(const core::Vec3& w, const core::Mat3& m) {
  return {{w.y * m.row[2] - w.z * m.row[1], w.z * m.row[0] - w.x * m.row[2], w.x * m.row[1] - w.y * m.row[0]}};
}

// A rotation and the axes about which roll, pitch and yaw turn, world axes, as seen along them: Rz(-c) Ry(-b) x,
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

// Sum of speeds about the axes; angles turn clockwise.
core::Vec3 about(const std::array<core::Vec3, 3>& axes, const std::array<double, 3>& speed) {
  return -(speed[0] * axes[0] + speed[1] * axes[1] + speed[2] * axes[2]);
}

bool still(const std::array<double, 3>& rate) { return rate[0] == 0.0 && rate[1] == 0.0 && rate[2] == 0.0; }

constexpr core::Mat3 nothing{{core::Vec3{}, core::Vec3{}, core::Vec3{}}};

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

std::array<core::Jet, 3> jets(const std::array<core::Interpolator, 3>& path, double time_s) {
  return {path[0].jet(time_s), path[1].jet(time_s), path[2].jet(time_s)};
}

core::Vec3 third_derivative(const std::array<core::Interpolator, 3>& path, double time_s) {
  return {path[0].third_derivative(time_s), path[1].third_derivative(time_s), path[2].third_derivative(time_s)};
}

core::Mat3 rate_of(const Attitude& attitude, const std::array<double, 3>& rate_rad_per_s) {
  if (still(rate_rad_per_s)) return nothing;
  return turned(about(attitude.axes, rate_rad_per_s), attitude.world_from_platform);
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
    turns_ = turns_ || moves(motion_.rotation_rad[i]) || motion_.rotation_rate_rad_per_s[i] != 0.0 ||
             rotation_process_[i].active();
  }
  const auto& path = motion_.position_m;
  acceleration_bound_mps2_ =
      core::norm({path[0].curvature_bound(), path[1].curvature_bound(), path[2].curvature_bound()});
  for (const core::Interpolator& way : path) turns_ = turns_ || (motion_.aligned && way.knots().size() > 2);
  for (const double stddev_rad : motion_.rotation_stddev_rad) shakes_ = shakes_ || stddev_rad != 0.0;
  if (!turns_ && !shakes_) attitude_ = rotated_at_0();
}

Pose Track::at(double time_s, std::int64_t pulse) const {
  ErrorSteps steps;
  return at(time_s, pulse, steps);
}

Pose Track::at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  const std::array<core::Jet, 3> path = jets(motion_.position_m, time_s);
  const Travel travel = travel_along(path, time_s, pulse, steps);
  Pose pose = attitude_;
  pose.position_world_m = travel.position_world_m;
  pose.velocity_world_mps = travel.velocity_world_mps;
  if (!turns_ && !shakes_) return pose;
  add_rotation(pose, path, time_s, pulse, steps);
  return pose;
}

Pose Track::rotated_at_0() const {
  Pose pose;
  ErrorSteps steps;
  add_rotation(pose, jets(motion_.position_m, 0.0), 0.0, 0, steps);
  return pose;
}

Travel Track::travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  return travel_along(jets(motion_.position_m, time_s), time_s, pulse, steps);
}

PoseAcceleration Track::acceleration_at(double time_s, std::int64_t pulse) const {
  return acceleration_at(time_s, at(time_s, pulse));
}

PoseAcceleration Track::acceleration_at(double time_s, const Pose& pose) const {
  const auto [x, y, z] = jets(motion_.position_m, time_s);
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

// The angles, which follow the nominal path where the platform is aligned, and their errors.
void Track::add_rotation(Pose& pose, const std::array<core::Jet, 3>& path, double time_s, std::int64_t pulse,
                         ErrorSteps& steps) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Jet angle = motion_.rotation_rad[i].jet(time_s);
    pose.rotation_rad[i] = angle.value + motion_.rotation_rate_rad_per_s[i] * time_s;
    pose.rotation_rate_rad_per_s[i] = angle.slope + motion_.rotation_rate_rad_per_s[i];
  }
  if (motion_.aligned)
    align(pose, {path[0].slope, path[1].slope, path[2].slope},
          {path[0].curvature, path[1].curvature, path[2].curvature});
  for (std::size_t i = 0; i < 3; ++i) {
    if (motion_.rotation_stddev_rad[i] != 0.0)
      pose.rotation_rad[i] +=
          motion_.rotation_stddev_rad[i] * rotation_noise_.normals(pulse, static_cast<std::int64_t>(i))[0];
    if (!rotation_process_[i].active()) continue;
    const core::Jet deviation = rotation_process_[i].at(time_s, steps.rotation[i]);
    pose.rotation_rad[i] += deviation.value;
    pose.rotation_rate_rad_per_s[i] += deviation.slope;
  }
  const Attitude attitude = attitude_of(pose.rotation_rad);
  pose.world_from_platform = attitude.world_from_platform;
  pose.world_from_platform_rate = rate_of(attitude, pose.rotation_rate_rad_per_s);
}

Travel Track::travel_along(const std::array<core::Jet, 3>& path, double time_s, std::int64_t pulse,
                           ErrorSteps& steps) const {
  std::array<double, 3> shift{};
  std::array<double, 3> speed{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (motion_.position_stddev_m[i] != 0.0)
      shift[i] += motion_.position_stddev_m[i] * position_noise_.normals(pulse, static_cast<std::int64_t>(i))[0];
    if (!position_process_[i].active()) continue;
    const core::Jet deviation = position_process_[i].at(time_s, steps.position[i]);
    shift[i] += deviation.value;
    speed[i] += deviation.slope;
  }
  return {{path[0].value + shift[0], path[1].value + shift[1], path[2].value + shift[2]},
          {path[0].slope + speed[0], path[1].slope + speed[1], path[2].slope + speed[2]}};
}

}  // namespace sarsim::radar
