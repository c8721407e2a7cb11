#include "radar/atmosphere/path_integral.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::radar {
namespace path_integral_test {

constexpr double radius_m = 6'371'000.0;
constexpr double endless = std::numeric_limits<double>::infinity();

// A power of height up to a top, in panels.
struct Power {
  int exponent = 0;
  double top_m = 10e3;

  [[nodiscard]] double value(double height_m) const { return std::pow(height_m, exponent); }
  [[nodiscard]] double next_break_m(double height_m) const {
    return height_m < top_m ? std::min(top_m, height_m + 3e3) : endless;
  }
};

TEST(GaussNodes, IntegratePolynomialsOfDegree31) {
  for (int degree = 0; degree <= 30; degree += 2) {
    double sum = 0.0;
    for (const auto& [x, weight] : gauss_nodes) sum += 2.0 * weight * std::pow(x, degree);
    EXPECT_NEAR(sum, 2.0 / (degree + 1), 2e-15) << degree;
  }
}

TEST(IntegralAlong, MeasuresThePathBelowTheTop) {
  EXPECT_DOUBLE_EQ(integral_along(climb_of({0.0, 20e3, 40e3, endless}), Power{}), 20e3);
  EXPECT_DOUBLE_EQ(integral_along(climb_of({2e3, 8e3, 6e3, radius_m}), Power{}), 6e3);
  EXPECT_EQ(integral_along(climb_of({12e3, 20e3, 40e3, radius_m}), Power{}), 0.0);
  const StraightPath dips{12e3, 14e3, 400e3, radius_m};
  EXPECT_NEAR(integral_along(climb_of(dips), Power{}), length_below_m(dips, 10e3), 1e-6);
}

TEST(IntegralAlong, IsThatOfTheHeight) {
  EXPECT_NEAR(integral_along(climb_of({0.0, 8e3, 16e3, endless}), Power{2}), 2.0 * std::pow(8e3, 3) / 3.0, 1.0);
  EXPECT_NEAR(integral_along(climb_of({0.0, 8e3, 8e3, radius_m}), Power{1}), 32e6, 1e-6);
}

TEST(IntegralAlong, OfAnEndlessPathEndsAtTheTop) {
  EXPECT_DOUBLE_EQ(integral_along(endless_climb(1e3, 1.0, radius_m), Power{}), 9e3);
  const Climb dips = endless_climb(5e3, -0.02, radius_m);
  const double turn_m = dips.turn_m(), below_m = dips.height_at(turn_m);
  const double to_top_m = std::sqrt((10e3 - below_m) * (2.0 * radius_m + 10e3 + below_m));
  EXPECT_NEAR(integral_along(dips, Power{}), turn_m + to_top_m, 1e-6);
}

TEST(IntegralAlong, OfNothingIsNothing) {
  EXPECT_EQ(integral_along(climb_of({100.0, 100.0, 0.0, radius_m}), Power{}), 0.0);
}

}  // namespace path_integral_test
}  // namespace sarsim::radar
