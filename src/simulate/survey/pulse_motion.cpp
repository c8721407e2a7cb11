#include "simulate/survey/pulse_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::simulate {

namespace {

constexpr std::size_t max_motion_looks = 400'000;  // pulses times targets
constexpr std::int64_t max_motion_pulses = 1025;
constexpr std::int64_t min_motion_pulses = 65;
constexpr std::int64_t upsampled_looks = 16;
// First looks, at platforms alone and then at few targets and pulses; one that finds far less than anybody would note
// is the last.
constexpr std::size_t first_targets = 256;
constexpr double worth_looking_rad = 1e-5 * noted_motion_rad;

// Of a platform at one end of a pulse.
struct Moved {
  radar::Pose pose;
  radar::PoseAcceleration acceleration;
};

// d'' of the distance to a point: (v^2 - (u.v)^2)/d + u.a.
double bend_mps2(const Moved& radar, const Moved& platform, const core::Vec3& point_m) {
  const core::Vec3 way_m = radar::world_position_m(platform.pose, point_m) - radar.pose.position_world_m;
  const core::Vec3 velocity_mps = radar::world_velocity_mps(platform.pose, point_m) - radar.pose.velocity_world_mps;
  const core::Vec3 acceleration_mps2 =
      radar::world_acceleration_mps2(platform.acceleration, point_m) - radar.acceleration.acceleration_world_mps2;
  const double distance_m = core::norm(way_m);
  if (!(distance_m > 0.0)) return 0.0;
  const double radial_mps = core::dot(way_m, velocity_mps) / distance_m;
  return (core::dot(velocity_mps, velocity_mps) - radial_mps * radial_mps + core::dot(way_m, acceleration_mps2)) /
         distance_m;
}

// No vector of unit length is turned into a longer one than this.
double longest_turned(const core::Mat3& m) {
  return core::norm({core::norm(m.row[0]), core::norm(m.row[1]), core::norm(m.row[2])});
}

// A bound for what the second derivative of the distance to points of a platform, within `reach_m` of its origin and
// nowhere nearer than `nearest_m`, changes by within a pulse. The third derivative is (3 v.a + r.j - 3 d' d")/d, at
// most 3 v (2 a + v^2/d)/d and the jerk, whose share is what the accelerations differ by.
double max_change_mps2(const Moved& radar, const Moved& platform, double reach_m, double nearest_m, double pulse_s) {
  if (!(nearest_m > 0.0)) return std::numeric_limits<double>::infinity();
  const double speed_mps = core::norm(platform.pose.velocity_world_mps - radar.pose.velocity_world_mps) +
                           reach_m * longest_turned(platform.pose.world_from_platform_rate);
  const double acceleration_mps2 =
      core::norm(platform.acceleration.acceleration_world_mps2 - radar.acceleration.acceleration_world_mps2) +
      reach_m * longest_turned(platform.acceleration.world_from_platform_acceleration);
  return 3.0 * speed_mps * (2.0 * acceleration_mps2 + speed_mps * speed_mps / nearest_m) / nearest_m * pulse_s;
}

double max_jerk_mps2(const Moved& before, const Moved& after, double reach_m) {
  const auto& a = before.acceleration;
  const auto& b = after.acceleration;
  return core::norm(b.acceleration_world_mps2 - a.acceleration_world_mps2) +
         reach_m * longest_turned(b.world_from_platform_acceleration + -1.0 * a.world_from_platform_acceleration);
}

class MotionLook {
 public:
  MotionLook(const Acquisition& acquisition, std::span<const std::size_t> targets, const core::WorkControl& control)
      : acquisition_(acquisition),
        targets_(targets),
        control_(control),
        slot_of_(acquisition.scene->platforms.size(), none) {
    for (const std::size_t t : targets) add_slot(acquisition.scene->scatterers[t].platform);
    reflecting_ = platforms_.size();
    add_slot(acquisition.link.platform);
  }

  PulseMotion worst() {
    const std::int64_t count = acquisition_.timing.pulses.count();
    const PulseMotion bound = max_by_platforms(std::min(count, min_motion_pulses));
    if (bound.phase_rad < worth_looking_rad) return bound;
    const std::vector<std::size_t> all(targets_.begin(), targets_.end());
    const std::vector<std::size_t> few = evenly_of(all);
    targets_ = few;
    look(acquisition_.timing.pulses.first, acquisition_.timing.pulses.last, std::min(count, min_motion_pulses));
    if (worst_.phase_rad < worth_looking_rad) return worst_;
    targets_ = all;
    const auto affordable = static_cast<std::int64_t>(max_motion_looks / targets_.size());
    const std::int64_t looks = std::min(count, std::clamp(affordable, min_motion_pulses, max_motion_pulses));
    const std::int64_t spacing = looks > 1 ? (count - 1) / (looks - 1) + 1 : 1;
    look(acquisition_.timing.pulses.first, acquisition_.timing.pulses.last, looks);
    if (spacing > 1)
      look(std::max(acquisition_.timing.pulses.first, worst_.pulse - spacing),
           std::min(acquisition_.timing.pulses.last, worst_.pulse + spacing), upsampled_looks);
    return worst_;
  }

 private:
  [[nodiscard]] static std::vector<std::size_t> evenly_of(const std::vector<std::size_t>& targets) {
    const std::size_t step = (targets.size() + first_targets - 1) / first_targets;
    std::vector<std::size_t> few;
    for (std::size_t i = 0; i < targets.size(); i += step) few.push_back(targets[i]);
    return few;
  }

  // Number i of an even choice of so many pulses from the first to the last.
  [[nodiscard]] static std::int64_t chosen(std::int64_t first, std::int64_t last, std::int64_t looks, std::size_t i) {
    const double share = looks > 1 ? static_cast<double>(i) / static_cast<double>(looks - 1) : 0.0;
    return first + std::llround(share * static_cast<double>(last - first));
  }

  void look(std::int64_t first, std::int64_t last, std::int64_t looks) {
    std::vector<PulseMotion> found(static_cast<std::size_t>(looks));
    core::parallel_ranges(found.size(), 1, control_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) found[i] = worst_at(chosen(first, last, looks, i));
    });
    for (const PulseMotion& at : found)
      if (at.phase_rad > worst_.phase_rad) worst_ = at;
  }

  // The largest bound, or the first that is worth looking into.
  [[nodiscard]] PulseMotion max_by_platforms(std::int64_t looks) const {
    PulseMotion most{0.0, targets_.front(), acquisition_.timing.pulses.first};
    for (std::size_t i = 0; i < static_cast<std::size_t>(looks) && most.phase_rad < worth_looking_rad; ++i) {
      const std::int64_t pulse = chosen(acquisition_.timing.pulses.first, acquisition_.timing.pulses.last, looks, i);
      const double phase_rad = max_at(pulse);
      if (!(phase_rad <= most.phase_rad)) most = {phase_rad, most.target, pulse};
    }
    return most;
  }

  [[nodiscard]] double max_at(std::int64_t pulse) const {
    const double width_s = acquisition_.link.pulse.width_s;
    const double time_s = acquisition_.link.repetition.send_time_s(pulse);
    std::vector<radar::Track::ErrorSteps> steps(platforms_.size());
    const std::vector<Moved> before = platforms_at(time_s - 0.5 * width_s, pulse, steps);
    const std::vector<Moved> after = platforms_at(time_s + 0.5 * width_s, pulse, steps);
    const std::size_t own = slot_of_[acquisition_.link.platform];
    double max_mps2 = 0.0;
    for (std::size_t p = 0; p < reflecting_; ++p) {
      const ResolvedPlatform& platform = acquisition_.scene->platforms[platforms_[p]];
      const double reach_m = core::norm(platform.middle_m) + platform.radius_m;
      double change_mps2 = 0.0;
      for (const std::vector<Moved>* at : {&before, &after}) {
        const core::Vec3 middle_m = radar::world_position_m((*at)[p].pose, platform.middle_m);
        const double nearest_m = core::norm(middle_m - (*at)[own].pose.position_world_m) - platform.radius_m;
        change_mps2 = std::max(change_mps2, max_change_mps2((*at)[own], (*at)[p], reach_m, nearest_m, width_s));
      }
      change_mps2 += max_jerk_mps2(before[p], after[p], reach_m) + max_jerk_mps2(before[own], after[own], 0.0);
      max_mps2 = std::max(max_mps2, change_mps2);
    }
    return phase_of(max_mps2, pulse);
  }

  // At the ends of a pulse within which the second derivative of the distance changes by so much.
  [[nodiscard]] double phase_of(double change_mps2, std::int64_t pulse) const {
    const double width_s = acquisition_.link.pulse.width_s;
    return core::pi / 24.0 * acquisition_.link.carrier.carrier_hz(pulse) * width_s * width_s *
           radar::delay_of(std::abs(change_mps2), acquisition_.light_speed_mps());
  }

  void add_slot(std::uint32_t platform) {
    if (slot_of_[platform] != none) return;
    slot_of_[platform] = static_cast<std::uint32_t>(platforms_.size());
    platforms_.push_back(platform);
  }

  // By slot.
  [[nodiscard]] std::vector<Moved> platforms_at(double time_s, std::int64_t pulse,
                                                std::vector<radar::Track::ErrorSteps>& steps) const {
    std::vector<Moved> moved(platforms_.size());
    for (std::size_t p = 0; p < platforms_.size(); ++p) {
      const radar::Track& track = acquisition_.scene->platforms[platforms_[p]].track;
      moved[p].pose = track.at(time_s, pulse, steps[p]);
      moved[p].acceleration = track.acceleration_at(time_s, pulse, moved[p].pose, steps[p]);
    }
    return moved;
  }

  [[nodiscard]] PulseMotion worst_at(std::int64_t pulse) const {
    const double width_s = acquisition_.link.pulse.width_s;
    const double time_s = acquisition_.link.repetition.send_time_s(pulse);
    std::vector<radar::Track::ErrorSteps> steps(platforms_.size());
    const std::vector<Moved> before = platforms_at(time_s - 0.5 * width_s, pulse, steps);
    const std::vector<Moved> after = platforms_at(time_s + 0.5 * width_s, pulse, steps);
    const std::size_t own = slot_of_[acquisition_.link.platform];
    PulseMotion worst{0.0, 0, pulse};
    for (const std::size_t t : targets_) {
      const Scatterer& s = acquisition_.scene->scatterers[t];
      const std::size_t p = slot_of_[s.platform];
      const double change_mps2 =
          bend_mps2(after[own], after[p], s.position_m) - bend_mps2(before[own], before[p], s.position_m);
      const double phase_rad = phase_of(change_mps2, pulse);
      if (phase_rad > worst.phase_rad) worst = {phase_rad, t, pulse};
    }
    return worst;
  }

  const Acquisition& acquisition_;
  std::span<const std::size_t> targets_;
  const core::WorkControl& control_;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> platforms_;  // of the targets, then that of the radar
  std::vector<std::uint32_t> slot_of_;    // place in that list of each platform of the scene
  std::size_t reflecting_ = 0;            // how many are of targets
  PulseMotion worst_;
};

}  // namespace

PulseMotion motion_left_in_pulse(const Acquisition& acquisition, std::span<const std::size_t> targets,
                                 const core::WorkControl& control) {
  CORE_EXPECT(acquisition.scene != nullptr);
  for (const std::size_t t : targets) CORE_EXPECT(t < acquisition.scene->scatterers.size());
  if (targets.empty() || acquisition.scene->conventions.light_time == radar::LightTime::thesis) return {};
  return MotionLook(acquisition, targets, control).worst();
}

}  // namespace sarsim::simulate
