#include "radar/motion/track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

bool moves(const core::Interpolator& function) { return function.knots().size() > 1; }

bool swings(const Sine& sine) { return sine.amplitude != 0.0 && sine.frequency_hz != 0.0; }

bool is_fixed(const Motion& motion) {
  if (!motion.path.fixed() || motion.attitude.axes_turn(motion.path)) return false;
  if (std::ranges::any_of(motion.sines, swings)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (moves(motion.rotation_rad[i]) || motion.rotation_rate_rad_per_s[i] != 0.0 ||
        motion.position_stddev_m[i] != 0.0 || motion.rotation_stddev_rad[i] != 0.0 ||
        moves(motion.position_envelope[i]) || moves(motion.rotation_envelope[i]))
      return false;
  return motion.parent == nullptr || motion.parent->fixed();
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

bool any_active(const std::array<ErrorProcess, 3>& processes) {
  return std::ranges::any_of(processes, &ErrorProcess::active);
}

}  // namespace

Track::Track(Motion motion, std::uint64_t seed, const std::string& name)
    : motion_(std::move(motion)),
      position_noise_(seed, core::RandomKind::platform_position, core::name_key(name)),
      rotation_noise_(seed, core::RandomKind::platform_rotation, core::name_key(name)) {
  CORE_EXPECT(motion_.attitude.kind != AttitudeLaw::Kind::quaternions || motion_.attitude.table != nullptr);
  const core::RandomStream position(seed, core::RandomKind::position_envelope, core::name_key(name));
  const core::RandomStream rotation(seed, core::RandomKind::rotation_envelope, core::name_key(name));
  auto& moving = motion_.errors_follow_path ? along_process_ : position_process_;
  for (std::size_t i = 0; i < 3; ++i) {
    moving[i] = ErrorProcess(motion_.position_envelope[i], position, static_cast<int>(i), motion_.smooth_errors);
    rotation_process_[i] =
        ErrorProcess(motion_.rotation_envelope[i], rotation, static_cast<int>(i), motion_.smooth_errors);
  }
  for (const Sine& sine : motion_.sines)
    (static_cast<int>(sine.axis) < 3 ? position_sines_ : rotation_sines_).push_back(sine);
  errors_along_ = any_active(along_process_);
  adds_travel_ = !position_sines_.empty() || errors_along_;
  adds_rotation_ = !rotation_sines_.empty() || motion_.attitude.kind == AttitudeLaw::Kind::coordinated;
  note_own_turning();
  note_carried();
}

void Track::note_own_turning() {
  const AttitudeLaw& law = motion_.attitude;
  aligned_ = law.kind == AttitudeLaw::Kind::coordinated || (law.kind == AttitudeLaw::Kind::angles && motion_.aligned);
  has_axes_ = law.has_axes();
  own_turns_ = law.axes_turn(motion_.path) || (aligned_ && motion_.path.may_turn()) ||
               std::ranges::any_of(rotation_sines_, swings) || any_active(rotation_process_);
  for (std::size_t i = 0; i < 3; ++i) {
    own_turns_ = own_turns_ || moves(motion_.rotation_rad[i]) || motion_.rotation_rate_rad_per_s[i] != 0.0;
    own_shakes_ = own_shakes_ || motion_.rotation_stddev_rad[i] != 0.0;
  }
  if (!own_turns_ && !own_shakes_) attitude_ = rotated_at_0();
}

void Track::note_carried() {
  const Track* parent = motion_.parent.get();
  acceleration_bound_mps2_ = own_acceleration_bound_mps2();
  fixed_ = is_fixed(motion_);
  turns_ = own_turns_ || (parent != nullptr && parent->turns());
  if (fixed_) {
    ErrorSteps steps;
    attitude_ = parent != nullptr ? carried_at(0.0, 0, steps) : own_at(0.0, 0, steps);
    motion_.parent = nullptr;  // Done with: a chain at rest may be of any length.
    return;
  }
  if (parent == nullptr) return;
  acceleration_bound_mps2_ = parent->turns() ? std::numeric_limits<double>::infinity()
                                             : acceleration_bound_mps2_ + parent->acceleration_bound_mps2();
}

double Track::own_acceleration_bound_mps2() const {
  if (errors_along_ && motion_.path.may_turn()) return std::numeric_limits<double>::infinity();
  return motion_.path.acceleration_bound_mps2() + radar::acceleration_bound_mps2(position_sines_);
}

Pose Track::at(double time_s, std::int64_t pulse) const {
  ErrorSteps steps;
  return at(time_s, pulse, steps);
}

Pose Track::at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  if (fixed_) return attitude_;
  if (motion_.parent != nullptr) return carried_at(time_s, pulse, steps);
  return own_at(time_s, pulse, steps);
}

Travel Track::travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  if (fixed_) return {attitude_.position_world_m, attitude_.velocity_world_mps};
  if (motion_.parent != nullptr) return carried_travel_at(time_s, pulse, steps);
  return travel_along(motion_.path.jets(time_s), time_s, pulse, steps);
}

PoseAcceleration Track::acceleration_at(double time_s, std::int64_t pulse, const Pose& pose, ErrorSteps& steps) const {
  if (fixed_) return {};
  if (motion_.parent != nullptr) return acceleration_at(time_s, pulse);
  return own_acceleration_at(time_s, pulse, pose, &steps);
}

Pose Track::own_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  const PathJets path = motion_.path.jets(time_s);
  const Travel travel = travel_along(path, time_s, pulse, steps);
  Pose pose = attitude_;
  pose.position_world_m = travel.position_world_m;
  pose.velocity_world_mps = travel.velocity_world_mps;
  if (!own_turns_ && !own_shakes_) return pose;
  add_rotation(pose, path, time_s, pulse, steps);
  return pose;
}

Pose Track::rotated_at_0() const {
  Pose pose;
  ErrorSteps steps;
  add_rotation(pose, motion_.path.jets(0.0), 0.0, 0, steps);
  return pose;
}

Travel Track::travel_along(const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const {
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
  Travel travel{{path[0].value + shift[0], path[1].value + shift[1], path[2].value + shift[2]},
                {path[0].slope + speed[0], path[1].slope + speed[1], path[2].slope + speed[2]}};
  if (adds_travel_) add_sines_and_errors(travel, path, time_s, steps);
  return travel;
}

void Track::add_rotation(Pose& pose, const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  add_angles(pose, path, time_s, pulse, steps);
  set_turning_matrix(pose.rotation_rad, pose.rotation_rate_rad_per_s, pose.world_from_platform,
                     pose.world_from_platform_rate);
  if (has_axes_) turn_within_axes(pose, path, time_s);
}

// The angles, which follow the nominal path where the platform is aligned, and their errors.
void Track::add_angles(Pose& pose, const PathJets& path, double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Jet angle = motion_.rotation_rad[i].jet(time_s);
    pose.rotation_rad[i] = angle.value + motion_.rotation_rate_rad_per_s[i] * time_s;
    pose.rotation_rate_rad_per_s[i] = angle.slope + motion_.rotation_rate_rad_per_s[i];
  }
  if (aligned_)
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
  if (adds_rotation_) add_bank_and_sines(pose, time_s);
}

PoseAcceleration Track::own_acceleration_at(double time_s, std::int64_t pulse, const Pose& pose,
                                            ErrorSteps* steps) const {
  const PathJets path = motion_.path.jets(time_s);
  PoseAcceleration result;
  result.acceleration_world_mps2 = {path[0].curvature, path[1].curvature, path[2].curvature};
  std::array<double, 3> turning{};
  for (std::size_t i = 0; i < 3; ++i) turning[i] = motion_.rotation_rad[i].jet(time_s).curvature;
  if (aligned_) {
    const auto [pitch, yaw] = aligned_accelerations({path[0].slope, path[1].slope, path[2].slope},
                                                    result.acceleration_world_mps2, motion_.path.jerk_mps3(time_s));
    turning[1] += pitch;
    turning[2] += yaw;
  }
  if (adds_rotation_) add_bank_and_sines_to(turning, path, time_s);
  if (adds_travel_)
    result.acceleration_world_mps2 = result.acceleration_world_mps2 + added_acceleration_mps2(path, time_s, steps);
  result.world_from_platform_acceleration =
      has_axes_ ? acceleration_within_axes(path, time_s, pulse, turning, steps)
                : world_from_platform_acceleration(pose.rotation_rad, pose.rotation_rate_rad_per_s, turning);
  return result;
}

// --- What most tracks do without: parents, axes of attitude laws, sines, banks and errors along the path.

namespace {

Track::ErrorSteps& steps_of_parent(Track::ErrorSteps& steps) {
  if (steps.of_parent.empty()) steps.of_parent.emplace_back();
  return steps.of_parent.front();
}

// What motion errors do along the level axes of a path.
std::array<core::Jet, 3> deviations(const std::array<ErrorProcess, 3>& processes, double time_s,
                                    std::array<ErrorProcess::Step, 3>& steps) {
  return {processes[0].at(time_s, steps[0]), processes[1].at(time_s, steps[1]), processes[2].at(time_s, steps[2])};
}

void set_turning(Pose& pose, const TurningMatrix& m) {
  pose.world_from_platform = m.matrix;
  pose.world_from_platform_rate = m.rate;
  pose.rotation_rad = rotation_angles_rad(m.matrix);
  pose.rotation_rate_rad_per_s = rotation_rates_rad_per_s(m, pose.rotation_rad);
}

TurningMatrix turning_of_pose(const Pose& pose) { return {pose.world_from_platform, pose.world_from_platform_rate}; }

core::Mat3 product_acceleration(const TurningMatrix& outer, const core::Mat3& outer_acceleration,
                                const TurningMatrix& inner, const core::Mat3& inner_acceleration) {
  return outer_acceleration * inner.matrix + 2.0 * (outer.rate * inner.rate) + outer.matrix * inner_acceleration;
}

Travel carried(const Pose& parent, const Travel& own) {
  return {world_position_m(parent, own.position_world_m),
          world_velocity_mps(parent, own.position_world_m) + parent.world_from_platform * own.velocity_world_mps};
}

Pose carried(const Pose& parent, const Pose& own) {
  const Travel travel = carried(parent, Travel{own.position_world_m, own.velocity_world_mps});
  Pose pose;
  pose.position_world_m = travel.position_world_m;
  pose.velocity_world_mps = travel.velocity_world_mps;
  set_turning(pose, turning_of_pose(parent) * turning_of_pose(own));
  return pose;
}

PoseAcceleration carried_acceleration(const Pose& parent, const PoseAcceleration& of_parent, const Pose& own,
                                      const PoseAcceleration& of_own) {
  return {world_acceleration_mps2(of_parent, own.position_world_m) +
              2.0 * (parent.world_from_platform_rate * own.velocity_world_mps) +
              parent.world_from_platform * of_own.acceleration_world_mps2,
          product_acceleration(turning_of_pose(parent), of_parent.world_from_platform_acceleration,
                               turning_of_pose(own), of_own.world_from_platform_acceleration)};
}

}  // namespace

Pose Track::carried_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  return carried(motion_.parent->at(time_s, pulse, steps_of_parent(steps)), own_at(time_s, pulse, steps));
}

Travel Track::carried_travel_at(double time_s, std::int64_t pulse, ErrorSteps& steps) const {
  return carried(motion_.parent->at(time_s, pulse, steps_of_parent(steps)),
                 travel_along(motion_.path.jets(time_s), time_s, pulse, steps));
}

// Down the chain of parents once, with the pose of each.
PoseAcceleration Track::acceleration_at(double time_s, std::int64_t pulse) const {
  const auto moved = [&](const auto& of, const Track& track) -> std::pair<Pose, PoseAcceleration> {
    if (track.fixed_) return {track.attitude_, {}};
    ErrorSteps steps;
    const Pose own = track.own_at(time_s, pulse, steps);
    const PoseAcceleration acceleration = track.own_acceleration_at(time_s, pulse, own, &steps);
    if (track.motion_.parent == nullptr) return {own, acceleration};
    const auto [parent, of_parent] = of(of, *track.motion_.parent);
    return {carried(parent, own), carried_acceleration(parent, of_parent, own, acceleration)};
  };
  return moved(moved, *this).second;
}

void Track::add_sines_and_errors(Travel& travel, const PathJets& path, double time_s, ErrorSteps& steps) const {
  const PathState sines = path_state(sines_at(position_sines_, time_s).position_m);
  const auto [along, left, up] = deviations(along_process_, time_s, steps.position);
  const relative_path::LevelAxes axes = relative_path::level_axes(path_state(path));
  travel.position_world_m = travel.position_world_m + sines.position_world_m + along.value * axes.ahead[0] +
                            left.value * axes.left[0] + core::Vec3{0.0, 0.0, up.value};
  travel.velocity_world_mps = travel.velocity_world_mps + sines.velocity_world_mps + along.slope * axes.ahead[0] +
                              left.slope * axes.left[0] + core::Vec3{0.0, 0.0, up.slope} + along.value * axes.ahead[1] +
                              left.value * axes.left[1];
}

void Track::turn_within_axes(Pose& pose, const PathJets& path, double time_s) const {
  set_turning(pose, law_axes(motion_.attitude, path_state(path), time_s) * turning_of_pose(pose));
}

void Track::add_bank_and_sines(Pose& pose, double time_s) const {
  const std::array<core::Jet, 3> angles = sines_at(rotation_sines_, time_s).rotation_rad;
  for (std::size_t i = 0; i < 3; ++i) {
    pose.rotation_rad[i] += angles[i].value;
    pose.rotation_rate_rad_per_s[i] += angles[i].slope;
  }
  if (motion_.attitude.kind != AttitudeLaw::Kind::coordinated) return;
  const core::Jet roll = coordinated_roll(motion_.path.state(time_s), {});
  pose.rotation_rad[0] += roll.value;
  pose.rotation_rate_rad_per_s[0] += roll.slope;
  pose.rotation_rad[1] += motion_.attitude.attack_rad;
}

// Of sines and of errors that turn with the path.
core::Vec3 Track::added_acceleration_mps2(const PathJets& path, double time_s, ErrorSteps* steps) const {
  const core::Vec3 of_sines = path_state(sines_at(position_sines_, time_s).position_m).acceleration_world_mps2;
  if (!errors_along_) return of_sines;
  ErrorSteps none;
  ErrorSteps& known = steps != nullptr ? *steps : none;
  const auto [along, left, up] = deviations(along_process_, time_s, known.position);
  const relative_path::LevelAxes axes = relative_path::level_axes(path_state(path, motion_.path.jerk_mps3(time_s)));
  return of_sines + 2.0 * (along.slope * axes.ahead[1] + left.slope * axes.left[1]) + along.value * axes.ahead[2] +
         left.value * axes.left[2];
}

void Track::add_bank_and_sines_to(std::array<double, 3>& angle_accelerations, const PathJets& path,
                                  double time_s) const {
  const std::array<core::Jet, 3> angles = sines_at(rotation_sines_, time_s).rotation_rad;
  for (std::size_t i = 0; i < 3; ++i) angle_accelerations[i] += angles[i].curvature;
  if (motion_.attitude.kind != AttitudeLaw::Kind::coordinated) return;
  const PathState state = path_state(path, motion_.path.jerk_mps3(time_s));
  angle_accelerations[0] += coordinated_roll(state, motion_.path.snap_mps4(time_s)).curvature;
}

core::Mat3 Track::acceleration_within_axes(const PathJets& path, double time_s, std::int64_t pulse,
                                           const std::array<double, 3>& angle_accelerations, ErrorSteps* steps) const {
  Pose own;
  ErrorSteps none;
  add_angles(own, path, time_s, pulse, steps != nullptr ? *steps : none);
  const PathState state = path_state(path, motion_.path.jerk_mps3(time_s));
  return product_acceleration(
      law_axes(motion_.attitude, state, time_s), law_axes_acceleration(motion_.attitude, state, time_s),
      turning_matrix(own.rotation_rad, own.rotation_rate_rad_per_s),
      world_from_platform_acceleration(own.rotation_rad, own.rotation_rate_rad_per_s, angle_accelerations));
}

}  // namespace sarsim::radar
