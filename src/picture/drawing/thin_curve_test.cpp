#include "picture/drawing/thin_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sarsim::picture {
namespace thin_curve_test {

TEST(ThinnedCurve, KeepsFewPointsAsTheyAre) {
  const std::vector<Point> points{{0.0, 5.0}, {0.1, -3.0}, {0.2, 9.0}, {0.3, 1.0}, {7.0, 2.0}, {3.0, 4.0}};
  const std::vector<Point> kept = thinned(points, 0.5);
  ASSERT_EQ(kept.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(kept[i].x, points[i].x);
    EXPECT_EQ(kept[i].y, points[i].y);
  }
  EXPECT_TRUE(thinned({}, 0.5).empty());
}

TEST(ThinnedCurve, KeepsTheEndsAndTheExtremesOfEachColumn) {
  const std::vector<Point> kept =
      thinned({{1.00, 0.0}, {1.05, 7.0}, {1.10, 2.0}, {1.15, -4.0}, {1.20, 3.0}, {1.25, 1.0}, {1.60, 0.0}}, 0.5);
  ASSERT_EQ(kept.size(), 5U);
  EXPECT_EQ(kept[0].y, 0.0);
  EXPECT_EQ(kept[1].y, 7.0);
  EXPECT_EQ(kept[2].y, -4.0);
  EXPECT_EQ(kept[3].y, 1.0);
  EXPECT_EQ(kept[4].x, 1.60);
}

// 400 columns of half a pixel.
TEST(ThinnedCurve, HasAtMostFourPointsInAColumn) {
  std::vector<Point> points;
  for (int i = 0; i < 100'000; ++i) points.push_back({200.0 * i / 100'000.0, 100.0 * std::sin(0.9 * i)});
  EXPECT_LE(thinned(points, 0.5).size(), 1600U);
}

}  // namespace thin_curve_test
}  // namespace sarsim::picture
