#include "radar/motion/gait_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sarsim::radar {
namespace gait_curve_test {

const std::vector<core::Knot> points{{0.17, 3.0}, {0.4, 3.0}, {0.75, 70.0}, {1.0, 3.0}};

TEST(GaitCurve, GoesThroughItsPoints) {
  const GaitCurve curve(points);
  for (const core::Knot& point : points) EXPECT_NEAR(curve.at(point.x), point.y, 1e-12);
}

TEST(GaitCurve, RepeatsAndStaysWithinItsPoints) {
  const GaitCurve curve(points);
  for (double x = -1.0; x < 2.0; x += 1e-3) {
    EXPECT_NEAR(curve.at(x), curve.at(x + 1.0), 1e-10);
    EXPECT_GE(curve.at(x), 3.0 - 1e-12);
    EXPECT_LE(curve.at(x), 70.0 + 1e-12);
  }
  EXPECT_NEAR(curve.at(0.3), 3.0, 1e-12);
}

// Slopes are below 6 * 67/0.25 per period, and change by less than 100 times that in a period.
TEST(GaitCurve, HasAContinuousSlope) {
  const GaitCurve curve(points);
  constexpr double h = 1e-5;
  for (const double x : {0.0, 0.17, 0.4, 0.75, 0.9999999, 0.6}) {
    const double left = (curve.at(x) - curve.at(x - h)) / h, right = (curve.at(x + h) - curve.at(x)) / h;
    EXPECT_NEAR(left, right, 0.2);
  }
}

TEST(GaitCurve, TakesTheFirstOfPointsThatCoincide) {
  const GaitCurve curve({{-0.1, 25.0}, {0.5, -15.0}, {0.9, 99.0}});
  EXPECT_NEAR(curve.at(0.9), 25.0, 1e-12);
}

TEST(GaitCurve, OfOnePointIsConstant) {
  const GaitCurve curve({{0.3, 7.0}});
  for (const double x : {0.0, 0.3, 0.9, 1.0}) EXPECT_EQ(curve.at(x), 7.0);
}

}  // namespace gait_curve_test
}  // namespace sarsim::radar
