#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "raster/sicd/sicd.hpp"

namespace sarsim::raster {
namespace sicd_view_test {

// Where the equator meets the meridian of Greenwich x is up, y is east and z is north.
constexpr core::Vec3 point_m{radar::wgs84_semi_major_m, 0.0, 0.0};

// To the north, 3 km to the west and 1 km high: the point is on the right, straight beside.
TEST(SicdView, OfAFlightPastAPointIsThatOfItsTriangle) {
  const SicdView view =
      sicd_view(2.0, {point_m + core::Vec3{1000.0, -3000.0, 0.0}, core::Vec3{0.0, 0.0, 100.0}, core::Vec3{}}, point_m);
  const double grazing_deg = core::deg_per_rad * std::atan2(1000.0, 3000.0);
  EXPECT_FALSE(view.left);
  EXPECT_NEAR(view.slant_range_m, std::sqrt(1e7), 1e-6);
  EXPECT_NEAR(view.ground_range_m, point_m.x * std::atan2(3000.0, point_m.x + 1000.0), 1e-3);
  EXPECT_NEAR(view.cone_deg, 90.0, 1e-9);
  EXPECT_NEAR(view.grazing_deg, grazing_deg, 1e-9);
  EXPECT_NEAR(view.slope_deg, grazing_deg, 1e-9);
  EXPECT_NEAR(view.twist_deg, 0.0, 1e-9);
  EXPECT_NEAR(view.azimuth_deg, 270.0, 1e-9);
  EXPECT_NEAR(view.layover_deg, 270.0, 1e-9);
}

// To the south the same point is on the left; 2 km before it the radar looks ahead.
TEST(SicdView, KnowsTheSideAndTheSquint) {
  const SicdView view = sicd_view(
      0.0, {point_m + core::Vec3{1000.0, -3000.0, 2000.0}, core::Vec3{0.0, 0.0, -100.0}, core::Vec3{}}, point_m);
  EXPECT_TRUE(view.left);
  EXPECT_NEAR(view.cone_deg, core::deg_per_rad * std::acos(2000.0 / std::sqrt(14e6)), 1e-9);
  EXPECT_NEAR(view.azimuth_deg, 360.0 - core::deg_per_rad * std::atan2(3000.0, 2000.0), 1e-9);
  EXPECT_NEAR(view.grazing_deg, core::deg_per_rad * std::asin(1000.0 / std::sqrt(14e6)), 1e-9);
  // The slant plane holds the flight, which is level: it leans by the triangle across it.
  EXPECT_NEAR(view.slope_deg, core::deg_per_rad * std::atan2(1000.0, 3000.0), 1e-9);
  EXPECT_NEAR(view.layover_deg, 270.0, 1e-9);
}

}  // namespace sicd_view_test
}  // namespace sarsim::raster
