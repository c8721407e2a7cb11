#include "radar/motion/segment_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

// sin(x)/x.
double chord_share(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

core::Vec3 ahead(double heading_rad) { return {std::sin(heading_rad), std::cos(heading_rad), 0.0}; }
core::Vec3 to_the_right(double heading_rad) { return {std::cos(heading_rad), -std::sin(heading_rad), 0.0}; }
core::Vec3 upwards(double length) { return {0.0, 0.0, length}; }

// The chord of an arc lies along the mean heading; so there is no difference of large numbers where the radius is
// large.
core::Vec3 way_in(const PathSegment& s, double t) {
  const double length = s.speed_mps * t + 0.5 * s.acceleration_mps2 * t * t;
  const double half_turn = 0.5 * s.turn_rate_rad_per_s * t;
  const double rise = s.climb_mps * t + 0.5 * s.climb_acceleration_mps2 * t * t;
  return length * chord_share(half_turn) * ahead(s.heading_rad + half_turn) + upwards(rise);
}

double acceleration_of(const PathSegment& s) {
  return std::hypot(s.acceleration_mps2, s.speed_mps * s.turn_rate_rad_per_s, s.climb_acceleration_mps2);
}

bool sound(const PathSegment& s) {
  return s.duration_s >= 0.0 && (s.acceleration_mps2 == 0.0 || s.turn_rate_rad_per_s == 0.0);
}

}  // namespace

PathState state_in(const PathSegment& s, double t) {
  const double heading = s.heading_rad + s.turn_rate_rad_per_s * t;
  const double speed = s.speed_mps + s.acceleration_mps2 * t;
  const double turn = s.turn_rate_rad_per_s;
  PathState state;
  state.position_world_m = s.position_world_m + way_in(s, t);
  state.velocity_world_mps = speed * ahead(heading) + upwards(s.climb_mps + s.climb_acceleration_mps2 * t);
  state.acceleration_world_mps2 =
      s.acceleration_mps2 * ahead(heading) + speed * turn * to_the_right(heading) + upwards(s.climb_acceleration_mps2);
  state.jerk_world_mps3 = -speed * turn * turn * ahead(heading);
  return state;
}

PathSegment after(const PathSegment& s) {
  PathSegment next;
  next.position_world_m = s.position_world_m + way_in(s, s.duration_s);
  next.heading_rad = s.heading_rad + s.turn_rate_rad_per_s * s.duration_s;
  next.speed_mps = s.speed_mps + s.acceleration_mps2 * s.duration_s;
  next.climb_mps = s.climb_mps + s.climb_acceleration_mps2 * s.duration_s;
  return next;
}

SegmentPath::SegmentPath(double start_s, std::vector<PathSegment> segments)
    : start_s_(start_s), segments_(std::move(segments)) {
  CORE_EXPECT(std::ranges::all_of(segments_, sound));
  begins_.reserve(segments_.size());
  for (const PathSegment& segment : segments_) {
    begins_.push_back(duration_s_);
    duration_s_ += segment.duration_s;
  }
}

PathState SegmentPath::at(double time_s) const {
  if (segments_.empty()) return {};
  const double elapsed = time_s - start_s_;
  if (elapsed < 0.0) {
    PathSegment before = segments_.front();
    before.acceleration_mps2 = before.turn_rate_rad_per_s = before.climb_acceleration_mps2 = 0.0;
    return state_in(before, elapsed);
  }
  if (elapsed >= duration_s_) return state_in(after(segments_.back()), elapsed - duration_s_);
  const auto next = std::ranges::upper_bound(begins_, elapsed);
  const auto k = static_cast<std::size_t>(next - begins_.begin()) - 1;
  return state_in(segments_[k], elapsed - begins_[k]);
}

double SegmentPath::acceleration_bound_mps2() const {
  double bound = 0.0;
  for (const PathSegment& segment : segments_) bound = std::max(bound, acceleration_of(segment));
  return bound;
}

double SegmentPath::largest_step_mps() const {
  double step = 0.0;
  for (std::size_t k = 1; k < segments_.size(); ++k) {
    const core::Vec3 before = state_in(after(segments_[k - 1]), 0.0).velocity_world_mps;
    step = std::max(step, core::norm(state_in(segments_[k], 0.0).velocity_world_mps - before));
  }
  return step;
}

}  // namespace sarsim::radar
