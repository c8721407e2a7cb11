#include "radar/atmosphere/ionosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace ionosphere_test {

constexpr double radius_m = 6'371'000.0;
constexpr double flat = std::numeric_limits<double>::infinity();

TEST(IonosphereGroup, HasTheNumbersOfTheSpecification) {
  EXPECT_NEAR(ionosphere_group_m(10.0 * tec_unit_per_m2, 1.257e9), 2.5506, 5e-5);
  EXPECT_NEAR(ionosphere_group_m(10.0 * tec_unit_per_m2, 5.405e9), 0.13795, 5e-6);
  EXPECT_NEAR(ionosphere_group_m(10.0 * tec_unit_per_m2, 9.65e9), 0.04328, 5e-6);
}

TEST(Faraday, HasTheNumberOfTheSpecification) {
  const double rotation_rad = faraday_rad(50.0 * tec_unit_per_m2, 40e-6, 1.257e9);
  EXPECT_NEAR(rotation_rad * core::deg_per_rad, 17.2, 0.05);
  EXPECT_DOUBLE_EQ(faraday_rad(50.0 * tec_unit_per_m2, -40e-6, 1.257e9), -rotation_rad);
}

TEST(ShellFactor, IsOneAtTheZenith) {
  EXPECT_NEAR(shell_factor(*path_at_elevation(0.0, core::pi / 2.0, 700e3, radius_m)), 1.0, 1e-14);
  EXPECT_NEAR(shell_factor({0.0, 700e3, 700e3, flat}), 1.0, 1e-15);
}

// sin z' = R cos(elevation)/(R + h), the usual single-layer mapping.
TEST(ShellFactor, IsTheMappingOfTheSingleLayer) {
  for (const double shell_m : {350e3, 450e3})
    for (const double elevation_deg : {0.5, 10.0, 45.0, 80.0}) {
      const double elevation = elevation_deg * core::rad_per_deg;
      const double sine = radius_m * std::cos(elevation) / (radius_m + shell_m);
      const auto path = path_at_elevation(0.0, elevation, 700e3, radius_m);
      EXPECT_NEAR(shell_factor(*path, shell_m), 1.0 / std::sqrt(1.0 - sine * sine), 1e-11);
      const StraightPath turned{path->height_b_m, path->height_a_m, path->distance_m, radius_m};
      EXPECT_EQ(shell_factor(turned, shell_m), shell_factor(*path, shell_m));
    }
  EXPECT_NEAR(shell_factor({0.0, 600e3, 1200e3, flat}), 2.0, 1e-14);
}

TEST(ShellFactor, IsNothingOnOneSide) {
  EXPECT_EQ(shell_factor({0.0, 12e3, 50e3, radius_m}), 0.0);
  EXPECT_EQ(shell_factor({500e3, 600e3, 300e3, radius_m}), 0.0);
  EXPECT_EQ(shell_factor({450e3, 600e3, 300e3, radius_m}), 0.0);
  EXPECT_GT(shell_factor({0.0, 450e3, 600e3, radius_m}), 1.0);
}

}  // namespace ionosphere_test
}  // namespace sarsim::radar
