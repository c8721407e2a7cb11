#include "workflow/focus/image_forecast.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "workflow/focus/sar_test_scene.hpp"

namespace sarsim::workflow {
namespace image_forecast_test {

// Without a beam the aperture is the flight: 200 m/s for a second. The width is that of sin(x)/x, 0.886 lambda R/(2 L),
// but for 0.5 % of the curvature of the path; the range width 0.886 c/(2 B) times what 80 in B Tp leaves of it.
TEST(ImageForecast, IsThatOfTheFlight) {
  const auto image = forecast_image(sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.5), 0, 0);
  ASSERT_TRUE(image);
  const double wavelength_m = 299792458.0 / 5.3e9;
  const double range_m = std::hypot(10000.0, 2000.0);
  EXPECT_NEAR(image->range_m, range_m, 0.01);
  EXPECT_NEAR(image->aperture_m, 200.0, 2.0);
  EXPECT_NEAR(image->azimuth_width_m, 0.886 * wavelength_m * range_m / (2.0 * 200.0), 0.013);
  ASSERT_TRUE(image->range_width_m);
  EXPECT_NEAR(*image->range_width_m, 0.886 * 299792458.0 / 2e8, 0.02);
  // Twice the flight, half the width.
  const auto longer = forecast_image(sar_scene(620.0, {{0.0, 0.0, 0.0}}, 1.0), 0, 0);
  ASSERT_TRUE(longer);
  EXPECT_NEAR(longer->azimuth_width_m / image->azimuth_width_m, 0.5, 0.01);
}

TEST(ImageForecast, IsNoneOfARadarThatRests) {
  scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.5);
  scene.platforms[1] = simulate::resting("Plane", {-10000.0, 0.0, 2000.0});
  EXPECT_FALSE(forecast_image(scene, 0, 0));
}

TEST(ImageForecast, IsWithoutRangeOrNoneWhereTheWaveformIsBeyondAllBounds) {
  scene::Scene scene = sar_scene(620.0, {{0.0, 0.0, 0.0}}, 0.05);
  scene.radars[0].bandwidth_hz = 1e18;
  const auto image = forecast_image(scene, 0, 0);
  EXPECT_FALSE(image && image->range_width_m);
  scene.radars[0].bandwidth_hz = 100e6;
  scene.radars[0].pulse_width_s = 1e18;
  EXPECT_FALSE(forecast_image(scene, 0, 0));
}

// Out of the recorded ranges.
TEST(ImageForecast, IsNoneOfATargetThatIsNotSeen) {
  EXPECT_FALSE(forecast_image(sar_scene(620.0, {{5000.0, 0.0, 0.0}}, 0.5), 0, 0));
}

}  // namespace image_forecast_test
}  // namespace sarsim::workflow
