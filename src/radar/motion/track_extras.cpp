#include "radar/motion/track.hpp"

#include <algorithm>
#include <utility>

// What most tracks do without: parents, axes of attitude laws, sines, banks and errors along the path.

namespace sarsim::radar {

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
