#include "radar/orbit/j2_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using core::Vec3;

constexpr double longest_step_s = 1.0;

// Gradient of the potential -mu/r (1 - J2 (R/r)^2 (3 z^2/r^2 - 1)/2), with its sign turned.
Vec3 acceleration_at(const Vec3& r, const EarthGravity& gravity) {
  const double r2 = core::dot(r, r);
  const double point = -gravity.mu_m3_per_s2 / (r2 * std::sqrt(r2));
  const double k = 1.5 * gravity.j2 * gravity.radius_m * gravity.radius_m / r2;
  const double z2 = 5.0 * r.z * r.z / r2;
  const double level = point * (1.0 + k * (1.0 - z2));
  return {level * r.x, level * r.y, point * (1.0 + k * (3.0 - z2)) * r.z};
}

OrbitState step(const OrbitState& from, double h, const EarthGravity& gravity) {
  const Vec3& r = from.position_m;
  const Vec3& v = from.velocity_mps;
  const Vec3 a1 = acceleration_at(r, gravity);
  const Vec3 v2 = v + 0.5 * h * a1;
  const Vec3 a2 = acceleration_at(r + 0.5 * h * v, gravity);
  const Vec3 v3 = v + 0.5 * h * a2;
  const Vec3 a3 = acceleration_at(r + 0.5 * h * v2, gravity);
  const Vec3 v4 = v + h * a3;
  const Vec3 a4 = acceleration_at(r + h * v3, gravity);
  return {r + h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4), v + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)};
}

OrbitState later(OrbitState state, double duration_s, const EarthGravity& gravity) {
  const auto steps = static_cast<std::size_t>(std::ceil(std::abs(duration_s) / longest_step_s));
  for (std::size_t i = 0; i < steps; ++i) state = step(state, duration_s / static_cast<double>(steps), gravity);
  return state;
}

}  // namespace

std::vector<OrbitState> states_under_j2(const OrbitState& start, std::span<const double> times_s,
                                        const EarthGravity& gravity) {
  CORE_EXPECT(std::ranges::is_sorted(times_s));
  CORE_EXPECT(core::norm(start.position_m) > 0.0);
  std::vector<OrbitState> states(times_s.size());
  const auto behind = static_cast<std::size_t>(std::ranges::lower_bound(times_s, 0.0) - times_s.begin());
  OrbitState state = start;
  double time_s = 0.0;
  const auto go_to = [&](std::size_t i) {
    state = later(state, times_s[i] - time_s, gravity);
    time_s = times_s[i];
    states[i] = state;
  };
  for (std::size_t i = behind; i < times_s.size(); ++i) go_to(i);
  state = start;
  time_s = 0.0;
  for (std::size_t i = behind; i-- > 0;) go_to(i);
  return states;
}

}  // namespace sarsim::radar
