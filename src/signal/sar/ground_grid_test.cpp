#include "signal/sar/ground_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "signal/sar/ground_sight.hpp"

namespace sarsim::signal {
namespace ground_grid_test {

constexpr double height_m = 3000.0;

// Axes of a flight 3000 m above the ground and 8000 m beside the scene, that climbs by `slope`.
FocusedImage slant_image(double slope) {
  FocusedImage image;
  image.frame.origin_m = {0.0, -8000.0, height_m};
  image.frame.along = (1.0 / std::hypot(1.0, slope)) * core::Vec3{1.0, 0.0, slope};
  image.frame.speed_mps = 150.0;
  image.azimuth = {-300.0, 0.3, 2001};
  image.range = {8400.0, 1.0, 301};
  image.carrier_hz = 9.6e9;
  image.light_speed_mps = 3e8;
  return image;
}

double last_of(const ImageAxis& axis) { return axis.at(static_cast<double>(axis.count) - 1.0); }

TEST(GroundGrid, HoldsWhatTheSlantImageOfAClimbingOrDescendingFlightHolds) {
  for (const double slope : {0.0, 0.2, -0.2, 0.5}) {
    const FocusedImage slant = slant_image(slope);
    const FocusedImage grid = on_ground(slant, {0.0, 0.0, 0.0});
    for (const double azimuth_m : {slant.azimuth.first_m, last_of(slant.azimuth)})
      for (const double range_m : {slant.range.first_m, last_of(slant.range)}) {
        const ImagePlace place = place_on_ground(grid.frame, slant.frame, {azimuth_m, range_m});
        EXPECT_GT(place.azimuth_m, grid.azimuth.first_m - 1e-6) << slope;
        EXPECT_LT(place.azimuth_m, last_of(grid.azimuth) + 1e-6) << slope;
        EXPECT_GT(place.range_m, grid.range.first_m - 1e-6) << slope;
        EXPECT_LT(place.range_m, last_of(grid.range) + 1e-6) << slope;
      }
  }
}

TEST(GroundGrid, BeginsWhereTheFirstPulseSeesTheGroundAcrossItsFlight) {
  for (const double slope : {0.0, 0.2, -0.2}) {
    const FocusedImage slant = slant_image(slope);
    const FocusedImage grid = on_ground(slant, {0.0, 0.0, 0.0});
    // The plane across an inclined line meets the ground by height times slope ahead of the antenna.
    const double cosine = 1.0 / std::hypot(1.0, slope);
    const auto place_m = [&](double azimuth_m) {
      return azimuth_m * cosine + (height_m + azimuth_m * slope * cosine) * slope;
    };
    EXPECT_NEAR(grid.azimuth.first_m, place_m(-300.0), 1e-6);
    EXPECT_NEAR(last_of(grid.azimuth), place_m(300.0), grid.azimuth.step_m);
  }
}

TEST(GroundGrid, KeepsTheSpectrumAboutTheMiddleOfASquintedBeam) {
  for (const double slope : {0.0, 0.2}) {
    FocusedImage slant = slant_image(slope);
    // 20 degrees ahead: 2 f/c sin, and 2 f/c (cos - 1).
    slant.azimuth.spectrum_centre_per_m = 64.0 * std::sin(0.349);
    slant.range.spectrum_centre_per_m = 64.0 * (std::cos(0.349) - 1.0);
    const FocusedImage grid = on_ground(slant, {0.0, 0.0, 0.0});
    // The phase that the two centres mean, in turns, of a point of the ground, and its change along the grid's axes.
    const auto turns = [&](const core::Vec3& point_m) {
      const ImagePlace place = place_of(slant.frame, point_m);
      return slant.azimuth.spectrum_centre_per_m * place.azimuth_m + slant.range.spectrum_centre_per_m * place.range_m;
    };
    const ImagePlace middle = place_on_ground(grid.frame, slant.frame, {0.0, 8550.0});
    const core::Vec3 point_m =
        grid.frame.origin_m + middle.azimuth_m * grid.frame.along + middle.range_m * grid.frame.across;
    const auto change = [&](const core::Vec3& axis) {
      return 0.5 * (turns(point_m + axis) - turns(point_m - axis));  // curved by 1e-8 over a metre
    };
    EXPECT_NEAR(grid.azimuth.spectrum_centre_per_m, change(grid.frame.along), 1e-5) << slope;
    EXPECT_NEAR(grid.range.spectrum_centre_per_m, change(grid.frame.across), 1e-5) << slope;
  }
  // Level: the change of the slant range across the ground is the cosine of the grazing angle.
  FocusedImage slant = slant_image(0.0);
  slant.range.spectrum_centre_per_m = -3.85;
  EXPECT_NEAR(on_ground(slant, {0.0, 0.0, 0.0}).range.spectrum_centre_per_m,
              -3.85 * std::sqrt(8550.0 * 8550.0 - height_m * height_m) / 8550.0, 1e-9);
}

TEST(GroundSight, LiesOnTheGroundUnderItsAngleWhereverTheLineClimbs) {
  for (const double slope : {-0.2, 0.0, 0.3})
    for (const double squint_rad : {-0.3, 0.0, 0.2}) {
      const ReferenceTrack line{0.0, {0.0, -8000.0, height_m}, {100.0, 0.0, 100.0 * slope}};
      const GroundSight sight(line, {0.0, 0.0, 20.0}, squint_rad);
      for (const double time_s : {-1.0, 2.0})
        for (const double range_m : {6000.0, 9000.0}) {
          const core::Vec3 from_m = line.at(time_s);
          const core::Vec3 to_m = sight.point_at(from_m, range_m) - from_m;
          EXPECT_NEAR(from_m.z + to_m.z, 20.0, 1e-6) << slope << " " << squint_rad;
          EXPECT_NEAR(core::norm(to_m), range_m, 1e-6) << slope << " " << squint_rad;
          EXPECT_NEAR(core::dot(to_m, sight.ahead()), range_m * std::sin(squint_rad), 1e-6)
              << slope << " " << squint_rad;
          EXPECT_GT(to_m.y, 0.0);
        }
    }
}

TEST(GroundGrid, RefusesGroundOutOfReachAndVerticalLines) {
  EXPECT_THROW((void)on_ground(slant_image(0.0), {0.0, 0.0, -9000.0}), std::invalid_argument);
  // Across a line that climbs by 0.5 ground 7700 m below is 8609 m away at the middle; 8459 m at the first pulse.
  EXPECT_NO_THROW((void)on_ground(slant_image(0.5), {0.0, 0.0, height_m - 7700.0}));
  EXPECT_THROW((void)on_ground(slant_image(0.5), {0.0, 0.0, height_m - 8000.0}), std::invalid_argument);
  FocusedImage vertical = slant_image(0.0);
  vertical.frame.along = {0.0, 0.0, 1.0};
  EXPECT_THROW((void)on_ground(vertical, {0.0, 0.0, 0.0}), std::invalid_argument);
}

}  // namespace ground_grid_test
}  // namespace sarsim::signal
