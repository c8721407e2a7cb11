#include "scene/model/orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "radar/earth/ellipsoid.hpp"

namespace sarsim::scene {
namespace orbit_test {

Platform on_orbit() {
  Platform platform;
  platform.path = Platform::Path::orbit;
  platform.semi_major_axis_m = 7070.5e3;
  platform.eccentricity = 0.00114;
  platform.inclination = core::Angle::from_deg(98.1817);
  platform.node_longitude = core::Angle::from_deg(-120.0);
  platform.perigee = core::Angle::from_deg(90.0);
  platform.anomaly = core::Angle::from_deg(-125.0);
  return platform;
}

Platform switched(Platform before, Platform::Path path) {
  Platform after = before;
  after.path = path;
  continue_orbit(before, after);
  return after;
}

TEST(ContinueOrbit, LeavesASatelliteWhereItIs) {
  const Platform orbit = on_orbit();
  const Platform state = switched(orbit, Platform::Path::state);
  const radar::OrbitMotion motion = radar::SecularOrbit(*elements_of(orbit)).at(0.0);
  const radar::OrbitState inertial = inertial_state_of(state);
  EXPECT_LT(core::norm(inertial.position_m - motion.position_m), 1e-3);
  EXPECT_LT(core::norm(inertial.velocity_mps - motion.velocity_mps), 2e-6);
  // Westward of what stars see, by the turning of the Earth.
  const double level_m = std::hypot(motion.position_m.x, motion.position_m.y);
  EXPECT_NEAR(core::norm(state.state_velocity_mps - motion.velocity_mps), radar::earth_rate_rad_per_s * level_m, 1e-5);
  const Platform back = switched(state, Platform::Path::orbit);
  EXPECT_NEAR(back.semi_major_axis_m, orbit.semi_major_axis_m, 0.02);
  EXPECT_NEAR(back.eccentricity, orbit.eccentricity, 2e-9);
  EXPECT_NEAR(back.inclination.deg(), orbit.inclination.deg(), 2e-8);
  EXPECT_NEAR(std::remainder(back.node_longitude.deg() - orbit.node_longitude.deg(), 360.0), 0.0, 2e-8);
  EXPECT_NEAR(std::remainder(back.perigee.deg() + back.anomaly.deg() + 35.0, 360.0), 0.0, 2e-8);
}

TEST(ContinueOrbit, ChangesNothingWithoutAnOrbit) {
  Platform bad = on_orbit();
  bad.eccentricity = 1.5;
  EXPECT_FALSE(elements_of(bad));
  EXPECT_EQ(switched(bad, Platform::Path::state).state_position_m, Platform().state_position_m);
  bad.eccentricity = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(elements_of(bad));
  Platform fast = on_orbit();
  fast.path = Platform::Path::state;
  fast.state_velocity_mps = {0.0, 12e3, 0.0};
  EXPECT_EQ(switched(fast, Platform::Path::orbit).semi_major_axis_m, fast.semi_major_axis_m);
  EXPECT_EQ(switched(on_orbit(), Platform::Path::legs).state_position_m, Platform().state_position_m);
}

// What a new state begins with: nearly a circle.
TEST(ContinueOrbit, BeginsWithACircle) {
  const auto ellipse = radar::osculating_elements(inertial_state_of(Platform()));
  ASSERT_TRUE(ellipse);
  EXPECT_LT(ellipse->eccentricity, 0.005);
}

TEST(IsOrbit, HoldsForWhatHasStates) {
  EXPECT_TRUE(is_orbit(Platform::Path::ephemeris));
  EXPECT_TRUE(is_orbit(Platform::Path::orbit));
  EXPECT_TRUE(is_orbit(Platform::Path::state));
  EXPECT_FALSE(is_orbit(Platform::Path::trajectory));
}

}  // namespace orbit_test
}  // namespace sarsim::scene
