#include "radar/motion/attitude_law.hpp"

#include <cmath>

#include "core/report/expect.hpp"
#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {

namespace {

// A vector and its first two derivatives in time.
struct AcceleratedVector {
  core::Vec3 value, rate, acceleration;
};

AcceleratedVector cross(const AcceleratedVector& a, const AcceleratedVector& b) {
  return {
      core::cross(a.value, b.value), core::cross(a.rate, b.value) + core::cross(a.value, b.rate),
      core::cross(a.acceleration, b.value) + 2.0 * core::cross(a.rate, b.rate) + core::cross(a.value, b.acceleration)};
}

// The unit vector u of v = L u: v'' = L'' u + 2 L' u' + L u''. For the null vector nothing, without derivatives.
AcceleratedVector unit(const AcceleratedVector& v) {
  const double length = core::norm(v.value);
  if (!(length > 0.0)) return {};
  const double per_length = 1.0 / length;
  const core::Vec3 u = per_length * v.value;
  const double length_rate = core::dot(u, v.rate);
  const core::Vec3 rate = per_length * (v.rate - length_rate * u);
  const double length_acceleration = core::dot(rate, v.rate) + core::dot(u, v.acceleration);
  return {u, rate, per_length * (v.acceleration - length_acceleration * u - 2.0 * length_rate * rate)};
}

OrbitMotion orbit_motion_of(const PathState& s) {
  return {s.position_world_m, s.velocity_world_mps, s.acceleration_world_mps2};
}

OrbitAttitude steered(const AttitudeLaw& law, const PathState& state) {
  const OrbitMotion motion = orbit_motion_of(state);
  switch (law.kind) {
    case AttitudeLaw::Kind::zero_doppler: return zero_doppler_attitude(motion, law.earth, law.flight);
    case AttitudeLaw::Kind::nadir: return nadir_attitude(motion, law.earth, law.flight);
    default: return look_at_attitude(motion, {law.point_world_m, {}, {}});
  }
}

// The direction of flight that a law follows.
AcceleratedVector flight_direction(const AttitudeLaw& law, const PathState& s) {
  const AcceleratedVector v{s.velocity_world_mps, s.acceleration_world_mps2, s.jerk_world_mps3};
  if (law.kind == AttitudeLaw::Kind::look_at || law.flight == FlightDirection::earth_fixed) return v;
  const core::Vec3& w = law.earth.rotation_rad_per_s;
  return {v.value + carried_mps(law.earth, s.position_world_m), v.rate + core::cross(w, v.value),
          v.acceleration + core::cross(w, v.rate)};
}

AcceleratedVector way_to(const core::Vec3& point_m, const PathState& s) {
  return {point_m - s.position_world_m, -s.velocity_world_mps, -s.acceleration_world_mps2};
}

// Columns x, y, z up and to the left, of the second derivative.
core::Mat3 with_columns(const core::Vec3& x, const core::Vec3& y, const core::Vec3& z) {
  return core::transposed(core::Mat3{{x, -y, -z}});
}

}  // namespace

TurningMatrix law_axes(const AttitudeLaw& law, const PathState& state, double time_s) {
  CORE_EXPECT(law.has_axes());
  if (law.kind == AttitudeLaw::Kind::quaternions) return law.table->turning_at(time_s);
  const OrbitAttitude attitude = with_z_up(steered(law, state));
  return {attitude.world_from_platform, attitude.world_from_platform_rate};
}

core::Mat3 law_axes_acceleration(const AttitudeLaw& law, const PathState& state, double time_s) {
  CORE_EXPECT(law.has_axes());
  if (law.kind == AttitudeLaw::Kind::quaternions) return law.table->at(time_s).acceleration;
  const AcceleratedVector ahead = flight_direction(law, state);
  if (law.kind == AttitudeLaw::Kind::zero_doppler) {
    const AcceleratedVector x = unit(ahead);
    const AcceleratedVector y = unit(cross(unit(way_to(law.earth.centre_m, state)), x));
    return with_columns(x.acceleration, y.acceleration, cross(x, y).acceleration);
  }
  const bool looks = law.kind == AttitudeLaw::Kind::look_at;
  const AcceleratedVector z = unit(way_to(looks ? law.point_world_m : law.earth.centre_m, state));
  const AcceleratedVector y = unit(cross(z, ahead));
  return with_columns(cross(y, z).acceleration, y.acceleration, z.acceleration);
}

// q = N/L, N = vy ax - vx ay; L L' = vx ax + vy ay, L L'' = ax^2 + ay^2 + vx jx + vy jy - L'^2.
core::Jet coordinated_roll(const PathState& state, const core::Vec3& snap_mps4) {
  const core::Vec3& v = state.velocity_world_mps;
  const core::Vec3& a = state.acceleration_world_mps2;
  const core::Vec3& j = state.jerk_world_mps3;
  const core::Vec3& s = snap_mps4;
  const double level = std::hypot(v.x, v.y);
  if (level <= 0.0) return {};
  const double level_rate = (v.x * a.x + v.y * a.y) / level;
  const double level_acceleration = (a.x * a.x + a.y * a.y + v.x * j.x + v.y * j.y - level_rate * level_rate) / level;
  const double q = (v.y * a.x - v.x * a.y) / level;
  const double q_rate = (v.y * j.x - v.x * j.y - q * level_rate) / level;
  const double q_acceleration =
      (a.y * j.x - a.x * j.y + v.y * s.x - v.x * s.y - 2.0 * q_rate * level_rate - q * level_acceleration) / level;
  const double u = q / standard_gravity_mps2;
  const double u_rate = q_rate / standard_gravity_mps2;
  const double share = 1.0 / (1.0 + u * u);
  return {-std::atan(u), -u_rate * share,
          -share * (q_acceleration / standard_gravity_mps2 - 2.0 * u * u_rate * u_rate * share)};
}

}  // namespace sarsim::radar
