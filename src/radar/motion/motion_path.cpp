#include "radar/motion/motion_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double unknown_bound = std::numeric_limits<double>::infinity();

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

PathState path_state_of(const OrbitMotion& motion) {
  return {motion.position_m, motion.velocity_mps, motion.acceleration_mps2, {}};
}

// The end of a span that is nearest to a time outside all spans.
double nearest_end_s(const std::vector<TimeSpan>& spans, double time_s) {
  double nearest = spans.front().first_s;
  for (const TimeSpan& span : spans)
    for (const double end_s : {span.first_s, span.last_s})
      if (std::abs(end_s - time_s) < std::abs(nearest - time_s)) nearest = end_s;
  return nearest;
}

PathState motion_through(const StateTable& states, double time_s) {
  if (const auto motion = states.at(time_s)) return path_state_of(*motion);
  const double end_s = nearest_end_s(states.spans(), time_s);
  PathState s = path_state_of(states.at(end_s).value());
  const double beyond_s = time_s - end_s;
  s.position_world_m =
      s.position_world_m + beyond_s * s.velocity_world_mps + (0.5 * beyond_s * beyond_s) * s.acceleration_world_mps2;
  s.velocity_world_mps = s.velocity_world_mps + beyond_s * s.acceleration_world_mps2;
  return s;
}

core::Vec3 jerk_through(const StateTable& states, double time_s) {
  constexpr double half_s = 0.05;
  for (const TimeSpan& span : states.spans()) {
    if (!(time_s >= span.first_s && time_s < span.last_s)) continue;
    const double before_s = std::max(time_s - half_s, span.first_s);
    const double after_s = std::min(time_s + half_s, span.last_s);
    const core::Vec3 change =
        states.at(after_s).value().acceleration_mps2 - states.at(before_s).value().acceleration_mps2;
    return (1.0 / (after_s - before_s)) * change;
  }
  return {};
}

PathState state_beside(const RelativePath& path, double time_s) {
  return relative_state([&](double t) { return path.leader->state(t); }, path.offset, time_s);
}

bool goes(const core::Interpolator& function) { return function.knots().size() > 1; }

bool rests(const PathSegment& s) {
  return s.speed_mps == 0.0 && s.acceleration_mps2 == 0.0 && s.climb_mps == 0.0 && s.climb_acceleration_mps2 == 0.0;
}

// One direction within the piece. What slows down to rest or starts from it has none there.
bool keeps_direction(const PathSegment& s) {
  if (s.turn_rate_rad_per_s != 0.0 || s.climb_acceleration_mps2 != 0.0) return false;
  return s.acceleration_mps2 == 0.0 || (s.climb_mps == 0.0 && s.speed_mps > 0.0 && after(s).speed_mps > 0.0);
}

bool goes_on(const PathSegment& a, const PathSegment& b) {
  return a.speed_mps > 0.0 && b.speed_mps > 0.0 && a.heading_rad == b.heading_rad &&
         a.climb_mps * b.speed_mps == b.climb_mps * a.speed_mps;
}

bool is_straight(const std::vector<PathSegment>& pieces) {
  const auto bend = std::ranges::adjacent_find(pieces, std::not_fn(goes_on));
  return bend == pieces.end() && std::ranges::all_of(pieces, keeps_direction);
}

// Of a level turn at constant rate, a straight flight or the place beside one: each derivative of the level velocity is
// the one before it, turned and multiplied by the rate.
core::Vec3 snap_in_turn(const PathState& s) {
  const core::Vec3& v = s.velocity_world_mps;
  const core::Vec3& a = s.acceleration_world_mps2;
  const double level2 = v.x * v.x + v.y * v.y;
  if (level2 <= 0.0) return {};
  const double rate = (v.y * a.x - v.x * a.y) / level2;
  return (-rate * rate) * core::Vec3{a.x, a.y, 0.0};
}

// Low-pass functions know no bound.
double snap_of(const core::Interpolator& function, double time_s) {
  if (std::isfinite(function.curvature_bound())) return 0.0;
  const auto& knots = function.knots();
  const double half_s = 0.01 * (knots.back().x - knots.front().x) / static_cast<double>(knots.size() - 1);
  return (function.third_derivative(time_s + half_s) - function.third_derivative(time_s - half_s)) / (2.0 * half_s);
}

// How fast the heading of a path turns at most, within its pieces.
double turn_bound_rad_per_s(const MotionPath& path) {
  if (const auto* relative = std::get_if<RelativePath>(&path.way)) return turn_bound_rad_per_s(*relative->leader);
  const auto* pieces = std::get_if<SegmentPath>(&path.way);
  if (pieces == nullptr) return path.may_turn() ? unknown_bound : 0.0;
  double bound = 0.0;
  for (const PathSegment& s : pieces->segments()) bound = std::max(bound, std::abs(s.turn_rate_rad_per_s));
  return bound;
}

double bound_beside(const RelativePath& path) {
  const double arm_m = std::hypot(path.offset.along_m, path.offset.across_m);
  const double leader_mps2 = path.leader->acceleration_bound_mps2();
  if (arm_m == 0.0) return leader_mps2;
  const double turn = turn_bound_rad_per_s(*path.leader);
  return leader_mps2 + turn * turn * arm_m;
}

}  // namespace

MotionPath::MotionPath(StatePath path) : way(std::move(path)) {
  CORE_EXPECT(std::get<StatePath>(way).states != nullptr);
}

MotionPath::MotionPath(RelativePath path) : way(std::move(path)) {
  CORE_EXPECT(std::get<RelativePath>(way).leader != nullptr);
}

PathState MotionPath::state(double time_s) const {
  if (const auto* pieces = std::get_if<SegmentPath>(&way)) return pieces->at(time_s);
  if (const auto* relative = std::get_if<RelativePath>(&way)) return state_beside(*relative, time_s);
  return path_state(jets(time_s), jerk_mps3(time_s));
}

std::array<core::Jet, 3> MotionPath::other_jets(double time_s) const {
  const auto* table = std::get_if<StatePath>(&way);
  const PathState s = table != nullptr ? motion_through(*table->states, time_s) : state(time_s);
  const core::Vec3 &x = s.position_world_m, &v = s.velocity_world_mps, &a = s.acceleration_world_mps2;
  return {core::Jet{x.x, v.x, a.x}, core::Jet{x.y, v.y, a.y}, core::Jet{x.z, v.z, a.z}};
}

core::Vec3 MotionPath::jerk_mps3(double time_s) const {
  if (const auto* functions = std::get_if<FunctionPath>(&way)) {
    const auto& f = functions->position_m;
    return {f[0].third_derivative(time_s), f[1].third_derivative(time_s), f[2].third_derivative(time_s)};
  }
  if (const auto* table = std::get_if<StatePath>(&way)) return jerk_through(*table->states, time_s);
  return state(time_s).jerk_world_mps3;
}

core::Vec3 MotionPath::snap_mps4(double time_s) const {
  if (std::holds_alternative<StatePath>(way)) return {};
  const auto* functions = std::get_if<FunctionPath>(&way);
  if (functions == nullptr) return snap_in_turn(state(time_s));
  const auto& f = functions->position_m;
  return {snap_of(f[0], time_s), snap_of(f[1], time_s), snap_of(f[2], time_s)};
}

double MotionPath::acceleration_bound_mps2() const {
  return std::visit(
      Overloaded{[](const FunctionPath& path) {
                   const auto& f = path.position_m;
                   return core::norm({f[0].curvature_bound(), f[1].curvature_bound(), f[2].curvature_bound()});
                 },
                 [](const StatePath& path) { return path.states->acceleration_bound_mps2(); },
                 [](const SegmentPath& path) { return path.acceleration_bound_mps2(); },
                 [](const RelativePath& path) { return bound_beside(path); }},
      way);
}

bool MotionPath::fixed() const {
  return std::visit(Overloaded{[](const FunctionPath& path) { return std::ranges::none_of(path.position_m, goes); },
                               [](const StatePath&) { return false; },
                               [](const SegmentPath& path) { return std::ranges::all_of(path.segments(), rests); },
                               [](const RelativePath& path) { return path.leader->fixed(); }},
                    way);
}

bool MotionPath::may_turn() const {
  const auto bends = [](const core::Interpolator& f) { return f.knots().size() > 2; };
  return std::visit(Overloaded{[&](const FunctionPath& path) { return std::ranges::any_of(path.position_m, bends); },
                               [](const StatePath&) { return true; },
                               [](const SegmentPath& path) { return !is_straight(path.segments()); },
                               [](const RelativePath& path) { return path.leader->may_turn(); }},
                    way);
}

}  // namespace sarsim::radar
