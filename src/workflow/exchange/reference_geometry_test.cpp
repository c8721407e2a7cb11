#include "workflow/exchange/reference_geometry.hpp"

#include <gtest/gtest.h>

namespace sarsim::workflow::reference_geometry_test {

// A transmitter in orbit and a receiver on an aircraft over a point at 47 N, 8 E; the angles are those of sarkit 1.8.1.
raster::PhaseVector two_platforms() {
  raster::PhaseVector v;
  v.tx_time_s = 1.0;
  v.tx_m = {4800000.0, 900000.0, 5000000.0};
  v.tx_mps = {-4000.0, 5000.0, 3000.0};
  v.rcv_time_s = 1.004;
  v.rcv_m = {4321000.0, 612000.0, 4652000.0};
  v.rcv_mps = {100.0, 150.0, -80.0};
  v.srp_m = {4315590.0, 606520.0, 4641906.0};
  return v;
}

TEST(ReferenceGeometry, OfTwoPlatformsIsThatOfSarkit) {
  const raster::ReferenceGeometry g = reference_geometry(two_platforms(), true);
  EXPECT_NEAR(g.time_s, 1.0039256221547994, 1e-12);
  EXPECT_NEAR(g.azimuth_deg, 91.14006469355422, 1e-8);
  EXPECT_NEAR(g.azimuth_rate_deg_per_s, 0.3778846497053586, 1e-9);
  EXPECT_NEAR(g.bistatic_deg, 22.784537893634155, 1e-8);
  EXPECT_NEAR(g.bistatic_rate_deg_per_s, -1.0830167947799234, 1e-9);
  EXPECT_NEAR(g.graze_deg, 69.03900346345858, 1e-8);
  EXPECT_NEAR(g.twist_deg, 74.77040986895405, 1e-8);
  EXPECT_NEAR(g.slope_deg, 84.60785516375883, 1e-8);
  EXPECT_NEAR(g.layover_deg, 15.404311343645935, 1e-8);
  EXPECT_EQ(g.platform.side, 'L');
  EXPECT_NEAR(g.platform.slant_range_m, 670085.7193941682, 1e-6);
  EXPECT_NEAR(g.platform.ground_range_m, 237406.10049307573, 1e-5);
  EXPECT_NEAR(g.platform.doppler_cone_deg, 97.3241600836633, 1e-8);
  EXPECT_NEAR(g.platform.graze_deg, 67.01900496291766, 1e-8);
  EXPECT_NEAR(g.platform.azimuth_deg, 121.4412749248143, 1e-8);
  EXPECT_EQ(g.receiver.side, 'R');
  EXPECT_NEAR(g.receiver.ground_range_m, 5266.08326786213, 1e-5);
  EXPECT_NEAR(g.receiver.incidence_deg, 24.464614561014358, 1e-8);
  EXPECT_NEAR(g.receiver.azimuth_deg, 62.73740737281572, 1e-8);
}

TEST(ReferenceGeometry, OfOnePlatformIsThatOfSarkit) {
  const raster::ReferenceGeometry g = reference_geometry(two_platforms(), false);
  EXPECT_EQ(g.platform.side, 'L');
  EXPECT_NEAR(g.platform.slant_range_m, 340904.35511445143, 1e-6);
  EXPECT_NEAR(g.platform.doppler_cone_deg, 98.38023884987044, 1e-8);
  EXPECT_NEAR(g.platform.graze_deg, 67.18389780735549, 1e-8);
  EXPECT_NEAR(g.platform.azimuth_deg, 120.46760012407864, 1e-8);
  EXPECT_NEAR(g.twist_deg, -20.71452404852108, 1e-8);
  EXPECT_NEAR(g.slope_deg, 68.7334815461675, 1e-8);
  EXPECT_NEAR(g.layover_deg, 142.7739463732299, 1e-8);
}

// The corner cases that the standard fixes.
TEST(ReferenceGeometry, IsDefinedForAPlatformAtRestAndStraightAbove) {
  const core::Vec3 srp_m{6378137.0, 0.0, 0.0};
  const raster::PlatformGeometry rests = platform_geometry(0.0, {6379137.0, 0.0, 500.0}, {}, srp_m);
  EXPECT_EQ(rests.side, 'L');
  EXPECT_EQ(rests.doppler_cone_deg, 90.0);
  const raster::PlatformGeometry above = platform_geometry(0.0, {6379137.0, 0.0, 0.0}, {0.0, 100.0, 0.0}, srp_m);
  EXPECT_EQ(above.ground_range_m, 0.0);
  EXPECT_EQ(above.graze_deg, 90.0);
  EXPECT_EQ(above.incidence_deg, 0.0);
  EXPECT_EQ(above.azimuth_deg, 0.0);
}

}  // namespace sarsim::workflow::reference_geometry_test
