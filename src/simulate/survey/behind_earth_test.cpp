#include "simulate/survey/behind_earth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/earth/earth_frame.hpp"

namespace sarsim::simulate {
namespace behind_earth_test {

const radar::EarthFrame& frame() {
  static const radar::EarthFrame made({{core::rad_per_deg * 40.0, core::rad_per_deg * 10.0, 0.0}, 0.0});
  return made;
}

core::Vec3 place(double latitude_deg, double longitude_deg, double height_m) {
  return frame().world_of({core::rad_per_deg * latitude_deg, core::rad_per_deg * longitude_deg, height_m});
}

// From the height h the horizon is at the angle acos(R/(R + h)) from below: 25.7 deg from 700 km.
TEST(BehindEarth, HidesWhatIsBelowTheHorizon) {
  const BehindEarth earth(frame().turning());
  const core::Vec3 radar = place(40.0, 10.0, 700e3);
  EXPECT_FALSE(earth.hides(radar, place(40.0, 10.0, 0.0)));
  EXPECT_FALSE(earth.hides(radar, place(15.0, 10.0, 0.0)));
  EXPECT_FALSE(earth.hides(place(15.0, 10.0, 0.0), radar));
  EXPECT_TRUE(earth.hides(radar, place(13.5, 10.0, 0.0)));
  EXPECT_TRUE(earth.hides(place(13.5, 10.0, 0.0), radar));
  EXPECT_FALSE(earth.hides(radar, place(13.5, 10.0, 100e3)));
  EXPECT_TRUE(earth.hides(radar, place(-40.0, -170.0, 700e3)));
  EXPECT_TRUE(earth.hides(place(40.0, 10.0, 30.0), place(40.0, 11.0, 30.0)));  // 85 km; both see 20 km far
}

// The ground lies up to 106 m below the ellipsoid, and tangent planes rise above it.
TEST(BehindEarth, TakesNoGroundForTheEarth) {
  const BehindEarth earth(frame().turning());
  EXPECT_FALSE(earth.hides(place(40.0, 10.0, 700e3), place(41.0, 10.0, -430.0)));
  EXPECT_FALSE(earth.hides({0.0, 0.0, 2.0}, {3000.0, 0.0, 0.0}));
  EXPECT_FALSE(earth.hides({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}));
}

TEST(BehindEarth, KnowsNoHorizonOverAFlatWorld) {
  EXPECT_FALSE(BehindEarth({}).hides({0.0, 0.0, 10.0}, {1e7, 0.0, -1e6}));
}

}  // namespace behind_earth_test
}  // namespace sarsim::simulate
