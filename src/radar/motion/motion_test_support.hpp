#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/maths/interpolator.hpp"
#include "radar/motion/track.hpp"
#include "radar/orbit/orbit_test_support.hpp"
#include "radar/orbit/state_table.hpp"

// Paths and checks of derivatives for the tests of tracks.

namespace sarsim::radar::motion_test {

inline core::Interpolator constant(double value) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, value}}});
}

inline core::Interpolator line(double at_0, double slope) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::linear, {{0.0, at_0}, {1.0, at_0 + slope}}});
}

inline core::Interpolator spline(std::vector<core::Knot> knots) {
  return core::Interpolator(core::SampledFunction{core::Interpolation::cubic, std::move(knots)});
}

/// A winding path, knots 1 s apart: speeds below 100 m/s, third derivatives below 500 m/s^3.
inline FunctionPath winding_path() {
  return {{spline({{0, 0}, {1, 30}, {2, 70}, {3, 90}}), spline({{0, 5}, {1, 0}, {2, 20}, {3, 60}}),
           spline({{0, 100}, {1, 110}, {2, 105}, {3, 130}})}};
}

inline FunctionPath straight_path(const core::Vec3& start_m, const core::Vec3& velocity_mps) {
  return {{line(start_m.x, velocity_mps.x), line(start_m.y, velocity_mps.y), line(start_m.z, velocity_mps.z)}};
}

inline std::shared_ptr<const Track> shared_track(Motion motion, const char* name = "Parent") {
  return std::make_shared<const Track>(std::move(motion), 1, name);
}

inline core::Vec3 column(const core::Mat3& m, std::size_t i) { return core::transposed(m).row[i]; }

inline double difference(const core::Mat3& a, const core::Mat3& b) {
  const core::Mat3 d = a + -1.0 * b;
  return std::max({core::norm(d.row[0]), core::norm(d.row[1]), core::norm(d.row[2])});
}

/// Bounds of `expect_derivatives_of`, and the step of its differences.
struct DerivativeBounds {
  double step_s = 1e-4;
  double velocity_mps = 1e-6;
  double acceleration_mps2 = 1e-5;
  double rate_per_s = 1e-7;
  double acceleration_per_s2 = 1e-5;
};

/// Compares velocity and rate, accelerations, and the angles and their rates, with central differences for one pulse.
inline void expect_derivatives_of(const Track& track, double time_s, const DerivativeBounds& bounds,
                                  std::int64_t pulse = 7) {
  const double per_s = 0.5 / bounds.step_s;
  const Pose before = track.at(time_s - bounds.step_s, pulse), after = track.at(time_s + bounds.step_s, pulse);
  const Pose pose = track.at(time_s, pulse);
  const PoseAcceleration found = track.acceleration_at(time_s, pulse);
  const auto slope = [&](const core::Vec3& a, const core::Vec3& b) { return per_s * (b - a); };
  const auto slope_of = [&](const core::Mat3& a, const core::Mat3& b) { return per_s * (b + -1.0 * a); };
  EXPECT_LT(core::norm(slope(before.position_world_m, after.position_world_m) - pose.velocity_world_mps),
            bounds.velocity_mps)
      << time_s;
  EXPECT_LT(core::norm(slope(before.velocity_world_mps, after.velocity_world_mps) - found.acceleration_world_mps2),
            bounds.acceleration_mps2)
      << time_s;
  EXPECT_LT(difference(slope_of(before.world_from_platform, after.world_from_platform), pose.world_from_platform_rate),
            bounds.rate_per_s)
      << time_s;
  EXPECT_LT(difference(slope_of(before.world_from_platform_rate, after.world_from_platform_rate),
                       found.world_from_platform_acceleration),
            bounds.acceleration_per_s2)
      << time_s;
  EXPECT_LT(difference(world_from_platform(pose.rotation_rad), pose.world_from_platform), 1e-14) << time_s;
  EXPECT_LT(difference(world_from_platform_rate(pose.rotation_rad, pose.rotation_rate_rad_per_s),
                       pose.world_from_platform_rate),
            1e-12)
      << time_s;
  Track::ErrorSteps steps;
  const PoseAcceleration again = track.acceleration_at(time_s, pulse, pose, steps);
  EXPECT_EQ(again.acceleration_world_mps2, found.acceleration_world_mps2);
  EXPECT_EQ(again.world_from_platform_acceleration, found.world_from_platform_acceleration);
  const Travel travel = track.travel_at(time_s, pulse, steps);
  EXPECT_EQ(travel.position_world_m, pose.position_world_m);
  EXPECT_EQ(travel.velocity_world_mps, pose.velocity_world_mps);
}

/// An orbit under J2 in Earth-fixed axes from a state of Sentinel-1A, by Runge and Kutta's method of fourth order with
/// steps of 0.1 s: its own error is 1e-10 m in 300 s.
inline const std::vector<OrbitState>& j2_orbit() {
  static const std::vector<OrbitState> states = [] {
    std::vector<OrbitState> s{orbit_test::published_orbit_states[0].earth_fixed};
    constexpr double h = 0.1;
    for (int i = 0; i < 3000; ++i) {
      const core::Vec3 r = s.back().position_m, v = s.back().velocity_mps;
      const core::Vec3 a1 = orbit_test::j2_acceleration(r, v), v2 = v + (0.5 * h) * a1;
      const core::Vec3 a2 = orbit_test::j2_acceleration(r + (0.5 * h) * v, v2), v3 = v + (0.5 * h) * a2;
      const core::Vec3 a3 = orbit_test::j2_acceleration(r + (0.5 * h) * v2, v3), v4 = v + h * a3;
      const core::Vec3 a4 = orbit_test::j2_acceleration(r + h * v3, v4);
      s.push_back({r + (h / 6.0) * (v + 2.0 * v2 + 2.0 * v3 + v4), v + (h / 6.0) * (a1 + 2.0 * a2 + 2.0 * a3 + a4)});
    }
    return s;
  }();
  return states;
}

inline constexpr TurningAxes turning_earth{{0.0, 0.0, orbit_test::earth_rotation_rad_per_s}, {}};

/// The orbit as an ephemeris of a state every 10 s, from 0 to 300 s; states from `gap_from` to before `gap_to` left
/// out.
inline StatePath ephemeris(std::size_t gap_from = 0, std::size_t gap_to = 0) {
  StateSamples samples;
  for (std::size_t k = 0; k <= 30; ++k) {
    if (k >= gap_from && k < gap_to) continue;
    samples.time_s.push_back(10.0 * static_cast<double>(k));
    samples.position_m.push_back(j2_orbit()[100 * k].position_m);
    samples.velocity_mps.push_back(j2_orbit()[100 * k].velocity_mps);
  }
  return {std::make_shared<const StateTable>(std::get<StateTable>(StateTable::from(samples, hermite_degree_7, 15.0)))};
}

}  // namespace sarsim::radar::motion_test
