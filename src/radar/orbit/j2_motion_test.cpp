#include "radar/orbit/j2_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/maths/constants.hpp"
#include "radar/orbit/orbit_test_support.hpp"

namespace sarsim::radar {
namespace j2_motion_test {

using core::Vec3;

// That of Sentinel-1B over the Earth, seen from axes that do not turn.
OrbitState sentinel_1b() {
  OrbitState state = orbit_test::published_orbit_states[1].earth_fixed;
  state.velocity_mps =
      state.velocity_mps + core::cross(Vec3{0.0, 0.0, orbit_test::earth_rotation_rad_per_s}, state.position_m);
  return state;
}

double apart(const Vec3& a, const Vec3& b) { return core::norm(a - b); }

// SciPy's DOP853 with a relative tolerance of 2.3e-14, from the same state and field.
TEST(StatesUnderJ2, AreThoseOfAnotherIntegrator) {
  const std::vector<double> times_s{-100.0, 100.0, 6000.0};
  const std::vector<OrbitState> states = states_under_j2(sentinel_1b(), times_s);
  const std::vector<OrbitState> expected{
      {{2087655.1296422, -6187264.4783278, -2735512.0054620}, {-182.3352094198, -3078.5099120828, 6838.9640967902}},
      {{2004699.8594875, -6659774.2177427, -1316543.0148056}, {-644.2078072039, -1628.5453472098, 7297.4644139749}},
      {{2027703.9246842, -6614937.2620845, -1495952.4700346}, {-586.2600750986, -1813.3562366784, 7258.3932127852}}};
  ASSERT_EQ(states.size(), expected.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double allowed_m = std::abs(times_s[i]) > 1000.0 ? 5e-6 : 2e-7;
    EXPECT_LT(apart(states[i].position_m, expected[i].position_m), allowed_m) << times_s[i];
    EXPECT_LT(apart(states[i].velocity_mps, expected[i].velocity_mps), 1e-3 * allowed_m + 1e-9) << times_s[i];
  }
}

TEST(StatesUnderJ2, KeepToKeplersEllipseWithoutJ2) {
  EarthGravity round;
  round.j2 = 0.0;
  for (const double eccentricity : {0.0, 0.1, 0.7}) {
    const KeplerElements elements{6.6e6 / (1.0 - eccentricity), eccentricity, 1.1, 0.4, 2.0, 5.8};
    const SecularOrbit ellipse(elements, round);
    const OrbitMotion start = ellipse.at(0.0);
    std::vector<double> times_s;
    for (int i = -20; i <= 20; ++i) times_s.push_back(250.0 * i);
    const auto states = states_under_j2({start.position_m, start.velocity_mps}, times_s, round);
    for (std::size_t i = 0; i < times_s.size(); ++i)
      EXPECT_LT(apart(states[i].position_m, ellipse.at(times_s[i]).position_m), 2e-5) << eccentricity << ' ' << i;
  }
}

// Energy and the angular momentum about the axis stay; the one about other axes does not under J2.
TEST(StatesUnderJ2, KeepTheirEnergyForADay) {
  const auto energy = [](const OrbitState& state) {
    const EarthGravity g;
    const double r = core::norm(state.position_m);
    const double sine = state.position_m.z / r;
    const double flat = g.j2 * std::pow(g.radius_m / r, 2) * (1.5 * sine * sine - 0.5);
    return 0.5 * core::dot(state.velocity_mps, state.velocity_mps) - g.mu_m3_per_s2 / r * (1.0 - flat);
  };
  const OrbitState start = sentinel_1b();
  const std::vector<double> times_s{-86400.0, -43200.0, 0.0, 43200.0, 86400.0};
  const auto states = states_under_j2(start, times_s);
  EXPECT_EQ(states[2].position_m, start.position_m);
  EXPECT_EQ(states[2].velocity_mps, start.velocity_mps);
  const Vec3 momentum = core::cross(start.position_m, start.velocity_mps);
  for (const OrbitState& state : states) {
    EXPECT_NEAR(energy(state) / energy(start), 1.0, 1e-11);
    EXPECT_NEAR(core::cross(state.position_m, state.velocity_mps).z / momentum.z, 1.0, 1e-11);
  }
}

TEST(StatesUnderJ2, AreNoneForNoTimes) { EXPECT_TRUE(states_under_j2(sentinel_1b(), {}).empty()); }

TEST(SecularElements, GoThroughTheStateWithItsVelocity) {
  for (const auto& published : orbit_test::published_orbit_states) {
    OrbitState state = published.earth_fixed;
    state.velocity_mps =
        state.velocity_mps + core::cross(Vec3{0.0, 0.0, orbit_test::earth_rotation_rad_per_s}, state.position_m);
    const auto elements = secular_elements(state);
    ASSERT_TRUE(elements);
    const OrbitMotion back = SecularOrbit(*elements).at(0.0);
    EXPECT_LT(apart(back.position_m, state.position_m), 1e-7) << published.name;
    EXPECT_LT(apart(back.velocity_mps, state.velocity_mps), 1e-9) << published.name;
  }
}

TEST(SecularElements, ReturnTheElementsThatMadeTheState) {
  const KeplerElements given{9.0e6, 0.1, 0.5, 1.0, 2.0, 3.0};
  const OrbitMotion motion = SecularOrbit(given).at(0.0);
  const auto k = secular_elements({motion.position_m, motion.velocity_mps});
  ASSERT_TRUE(k);
  EXPECT_NEAR(k->semi_major_axis_m, given.semi_major_axis_m, 1e-5);
  EXPECT_NEAR(k->eccentricity, given.eccentricity, 1e-12);
  EXPECT_NEAR(k->inclination_rad, given.inclination_rad, 1e-12);
  EXPECT_NEAR(k->ascending_node_rad, given.ascending_node_rad, 1e-12);
  EXPECT_NEAR(k->perigee_rad, given.perigee_rad, 1e-11);
  EXPECT_NEAR(k->mean_anomaly_rad, given.mean_anomaly_rad, 1e-11);
}

TEST(SecularElements, AreNothingForAnOpenPath) {
  EXPECT_FALSE(secular_elements({{7.0e6, 0.0, 0.0}, {0.0, 11.0e3, 0.0}}));
}

}  // namespace j2_motion_test
}  // namespace sarsim::radar
