#include "radar/atmosphere/slant_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::radar {
namespace slant_table_test {

// Like the mapping of an atmosphere: 1/w to the zenith, round at the horizon.
double like_air(double height_m, double sine) {
  return std::exp(-height_m / 6000.0) / (sine + std::sqrt(sine * sine + 0.002));
}

constexpr SlantTable::Grid grid{{-10.0, 3000.0}, 500.0, -0.03, 0.004};

TEST(SlantTable, FollowsItsFunction) {
  const SlantTable table(grid, like_air);
  double worst = 0.0;
  for (double height_m = -10.0; height_m <= 3000.0; height_m += 41.0)
    for (double sine = -0.03; sine <= SlantTable::highest_sine; sine += 0.0007) {
      ASSERT_TRUE(table.holds(height_m, sine));
      worst = std::max(worst, std::abs(table.at(height_m, sine) / like_air(height_m, sine) - 1.0));
    }
  EXPECT_LT(worst, 3e-7);
}

TEST(SlantTable, HasNoStepsBetweenCells) {
  const SlantTable table(grid, like_air);
  for (double sine = -0.03; sine < 1.0; sine += 1e-5) {
    const double change = table.at(777.0, sine + 1e-5) / table.at(777.0, sine) - 1.0;
    const double truth = like_air(777.0, sine + 1e-5) / like_air(777.0, sine) - 1.0;
    EXPECT_NEAR(change, truth, 2e-10);
  }
}

TEST(SlantTable, HoldsItsEdgesAndNoMore) {
  const SlantTable table(grid, like_air);
  for (const double height_m : {-10.0, 3000.0})
    for (const double sine : {-0.03, SlantTable::highest_sine}) {
      EXPECT_TRUE(table.holds(height_m, sine));
      EXPECT_NEAR(table.at(height_m, sine), like_air(height_m, sine), 1e-9 * like_air(height_m, sine));
    }
  EXPECT_FALSE(table.holds(-10.1, 0.5));
  EXPECT_FALSE(table.holds(3000.1, 0.5));
  EXPECT_FALSE(table.holds(100.0, -0.0301));
  EXPECT_FALSE(table.holds(100.0, 1.03));
  EXPECT_FALSE(table.holds(std::nan(""), 0.5));
  EXPECT_FALSE(table.holds(100.0, std::nan("")));
  EXPECT_FALSE(SlantTable{}.holds(0.0, 0.5));
}

}  // namespace slant_table_test
}  // namespace sarsim::radar
