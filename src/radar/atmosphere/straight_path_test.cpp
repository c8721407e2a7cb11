#include "radar/atmosphere/straight_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace straight_path_test {

constexpr double radius_m = 6'371'000.0;
constexpr double flat = std::numeric_limits<double>::infinity();

// Height over the sphere of the point that divides the line between two points, in plane coordinates and 80 bits.
long double height_of_point(const Climb& climb, long double s) {
  const long double r1 = radius_m + static_cast<long double>(climb.low_m);
  const long double r2 = radius_m + static_cast<long double>(climb.high_m);
  const long double d = climb.length_m;
  const long double along = (r2 * r2 - r1 * r1 - d * d) / (2.0L * d);  // r1 sin(elevation)
  return std::sqrt(r1 * r1 + 2.0L * along * s + s * s) - radius_m;
}

TEST(Climb, KnowsTheHeightsOfThePath) {
  for (const StraightPath& path :
       {StraightPath{0.0, 700e3, 900e3, radius_m}, StraightPath{3000.0, 10.0, 50e3, radius_m},
        StraightPath{5000.0, 5000.0, 200e3, radius_m}}) {
    const Climb climb = climb_of(path);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const double s = share * climb.length_m;
      EXPECT_NEAR(climb.height_at(s), static_cast<double>(height_of_point(climb, s)), 1e-9 + 1e-14 * climb.length_m);
    }
    EXPECT_NEAR(climb.height_at(climb.length_m), climb.high_m, 1e-9);
  }
}

TEST(Climb, DoesNotMindTheOrderOfTheEnds) {
  const Climb up = climb_of({10.0, 3000.0, 50e3, radius_m}), down = climb_of({3000.0, 10.0, 50e3, radius_m});
  EXPECT_EQ(up.low_m, 10.0);
  EXPECT_EQ(up.high_m, 3000.0);
  EXPECT_EQ(up.rise, down.rise);
}

TEST(Climb, IsStraightOverTheFlatEarth) {
  const Climb climb = climb_of({0.0, 3000.0, 5000.0, flat});
  EXPECT_DOUBLE_EQ(climb.rise, 0.6);
  EXPECT_DOUBLE_EQ(climb.height_at(1000.0), 600.0);
  EXPECT_DOUBLE_EQ(climb.distance_to(1500.0), 2500.0);
  EXPECT_EQ(climb.turn_m(), 0.0);
}

TEST(Climb, DipsBetweenEqualHeights) {
  const Climb climb = climb_of({5000.0, 5000.0, 200e3, radius_m});
  EXPECT_NEAR(climb.sine(), -200e3 / (2.0 * (radius_m + 5000.0)), 1e-15);
  EXPECT_NEAR(climb.turn_m(), 100e3, 1e-6);
  const double lowest_m = std::sqrt(std::pow(radius_m + 5000.0, 2) - 1e10) - radius_m;
  EXPECT_NEAR(climb.height_at(climb.turn_m()), lowest_m, 1e-8);
  EXPECT_NEAR(climb_from_turn(climb).low_m, lowest_m, 1e-8);
  EXPECT_NEAR(climb_from_turn(climb).distance_to(5000.0), 100e3, 1e-5);
}

TEST(PathAtElevation, ComesBackToItsElevation) {
  for (const double r : {radius_m, flat})
    for (const double elevation_deg : {0.5, 5.0, 30.0, 60.0, 89.9, 90.0}) {
      const double elevation = elevation_deg * core::rad_per_deg;
      const auto path = path_at_elevation(100.0, elevation, 693e3, r);
      ASSERT_TRUE(path);
      EXPECT_NEAR(std::sin(low_elevation_rad(*path)), std::sin(elevation), 1e-13);
      EXPECT_NEAR(climb_of(*path).height_at(path->distance_m), 693e3, 1e-8);
    }
}

TEST(PathAtElevation, LooksFromTheOtherEnd) {
  const auto up = path_at_elevation(0.0, 0.3, 700e3, radius_m);
  ASSERT_TRUE(up);
  const double cosine = std::cos(0.3) * radius_m / (radius_m + 700e3);
  const auto down = path_at_elevation(700e3, -std::acos(cosine), 0.0, radius_m);
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->distance_m, up->distance_m, 1e-6);
  EXPECT_NEAR(climb_of(*down).rise, climb_of(*up).rise, 1e-12);
}

TEST(PathAtElevation, KnowsWhatItCannotReach) {
  EXPECT_FALSE(path_at_elevation(700e3, -0.1, 0.0, radius_m));  // passes over the horizon
  EXPECT_FALSE(path_at_elevation(700e3, 0.1, 0.0, radius_m));
  EXPECT_FALSE(path_at_elevation(100.0, -0.1, 200.0, flat));
  EXPECT_FALSE(path_at_elevation(100.0, 0.0, 200.0, flat));
  const auto level = path_at_elevation(1000.0, -0.01, 1000.0, radius_m);
  ASSERT_TRUE(level);
  EXPECT_NEAR(level->distance_m, 2.0 * (radius_m + 1000.0) * std::sin(0.01), 1e-6);
}

TEST(LengthBelow, TakesThePartOfARisingPath) {
  EXPECT_DOUBLE_EQ(length_below_m({0.0, 3000.0, 5000.0, flat}, 1500.0), 2500.0);
  EXPECT_DOUBLE_EQ(length_below_m({0.0, 3000.0, 5000.0, flat}, 3000.0), 5000.0);
  EXPECT_EQ(length_below_m({2000.0, 3000.0, 5000.0, flat}, 1500.0), 0.0);
  EXPECT_EQ(length_below_m({1000.0, 1000.0, 70.0, flat}, 1500.0), 70.0);
  EXPECT_EQ(length_below_m({1000.0, 1000.0, 70.0, flat}, 999.0), 0.0);
  const auto path = path_at_elevation(0.0, core::pi / 2.0, 700e3, radius_m);
  EXPECT_NEAR(length_below_m(*path, 5000.0), 5000.0, 1e-8);
}

TEST(LengthBelow, TakesTheMiddleOfADippingPath) {
  const StraightPath path{6000.0, 6500.0, 250e3, radius_m};
  const Climb climb = climb_of(path);
  ASSERT_LT(climb.height_at(climb.turn_m()), 5500.0);
  int below = 0;
  constexpr int steps = 250'000;
  for (int i = 0; i < steps; ++i) below += climb.height_at((i + 0.5) * path.distance_m / steps) < 5500.0 ? 1 : 0;
  EXPECT_NEAR(length_below_m(path, 5500.0), path.distance_m * below / steps, 2.0);
  EXPECT_EQ(length_below_m(path, climb.height_at(climb.turn_m()) - 1.0), 0.0);
  EXPECT_LT(length_below_m(path, 6100.0), length_below_m(path, 6400.0));
  EXPECT_EQ(length_below_m(path, 6500.0), path.distance_m);
}

}  // namespace straight_path_test
}  // namespace sarsim::radar
