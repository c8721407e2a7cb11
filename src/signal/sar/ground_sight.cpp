#include "signal/sar/ground_sight.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

GroundSight::GroundSight(const ReferenceTrack& reference, const core::Vec3& scene_m, double squint_rad)
    : squint_sine_(std::sin(squint_rad)),
      squint_cosine_(std::cos(squint_rad)),
      ground_m_(scene_m.z),
      reference_(reference) {
  const double speed = core::norm(reference.velocity_mps);
  core::expect(speed > 0.0, "motion compensation: the reference track is at rest");
  core::expect(std::abs(squint_rad) < 0.5 * core::pi, "motion compensation: the squint is a right angle or more");
  ahead_ = (1.0 / speed) * reference.velocity_mps;
  const core::Vec3 to_scene = from_line(scene_m);
  const double distance_m = core::norm(to_scene);
  core::expect(distance_m > 0.0, "motion compensation: the scene lies on the reference track");
  range_m_ = distance_m / squint_cosine_;
  side_ = core::cross(ahead_, {0.0, 0.0, 1.0});
  // A vertical track has no level side: its plane is that of the scene.
  if (core::norm(side_) < 1e-9) side_ = to_scene;
  side_ = (1.0 / core::norm(side_)) * side_;
  if (core::dot(side_, to_scene) < 0.0) side_ = -side_;
  down_ = core::Vec3{0.0, 0.0, -1.0} - core::dot(core::Vec3{0.0, 0.0, -1.0}, ahead_) * ahead_;
  if (core::norm(down_) > 1e-9) down_ = (1.0 / core::norm(down_)) * down_;
}

core::Vec3 GroundSight::point_at(const core::Vec3& from_m, double range_m) const {
  const double along_m = range_m * squint_sine_;
  const double across_m = range_m * squint_cosine_;
  double sine = 0.0;
  if (down_.z < 0.0) {
    const double drop_m = from_m.z + along_m * ahead_.z - ground_m_;
    sine = std::clamp(drop_m / (-down_.z * across_m), -1.0, 1.0);
  }
  return from_m + along_m * ahead_ + across_m * (std::sqrt(1.0 - sine * sine) * side_ + sine * down_);
}

GroundSight::Tangents GroundSight::tangents_at(const core::Vec3& from_m, double range_m, double reach_m) const {
  const double per_m = 0.5 / reach_m;
  const core::Vec3 step = reach_m * ahead_;
  return {per_m * (point_at(from_m + step, range_m) - point_at(from_m - step, range_m)),
          per_m * (point_at(from_m, range_m + reach_m) - point_at(from_m, range_m - reach_m))};
}

core::Vec3 GroundSight::from_line(const core::Vec3& point_m) const {
  const core::Vec3 r = point_m - reference_.position_m;
  return r - core::dot(r, ahead_) * ahead_;
}

}  // namespace sarsim::signal
