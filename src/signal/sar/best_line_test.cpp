#include "signal/sar/best_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sarsim::signal {
namespace best_line_test {

TEST(BestLine, IsThatOfTheLeastWeightedSquares) {
  const std::vector<double> x{0.0, 1.0, 3.0, 100.0}, weights{1.0, 2.0, 3.0, 0.0};
  const StraightLine line = best_line(x, std::vector<double>{5.0, 3.0, -1.0, 1e6}, weights);
  EXPECT_NEAR(line.constant, 5.0, 1e-12);
  EXPECT_NEAR(line.slope, -2.0, 1e-12);
  EXPECT_EQ(best_line(x, x, std::vector<double>(4)).slope, 0.0);
  const StraightLine level =
      best_line(std::vector<double>{2.0, 2.0}, std::vector<double>{1.0, 4.0}, std::vector<double>{2.0, 1.0});
  EXPECT_NEAR(level.at(7.0), 2.0, 1e-12);
}

}  // namespace best_line_test
}  // namespace sarsim::signal
