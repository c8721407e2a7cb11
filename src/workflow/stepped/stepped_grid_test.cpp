#include "workflow/stepped/stepped_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sarsim::workflow {
namespace stepped_grid_test {

using radar::CarrierPlan;

TEST(SteppedGrid, OfAListIsThatOfTheSameSteps) {
  const auto stepped = stepped_grid(CarrierPlan::stepped(9e9, 10e6, 8, 2), 0);
  std::vector<double> list;
  for (std::int64_t n = 0; n < 16; ++n) list.push_back(CarrierPlan::stepped(9e9, 10e6, 8, 2).carrier_hz(n));
  const auto listed = stepped_grid(CarrierPlan::list(list), 0);
  ASSERT_TRUE(stepped && listed);
  EXPECT_EQ(listed->steps, 8U);
  EXPECT_EQ(listed->pulses_per_step, 2U);
  EXPECT_EQ(listed->first_hz, stepped->first_hz);
  EXPECT_DOUBLE_EQ(listed->step_hz, stepped->step_hz);
  EXPECT_TRUE(listed->order.empty());
  std::ranges::reverse(list);
  const auto down = stepped_grid(CarrierPlan::list(list), 0);
  ASSERT_TRUE(down);
  EXPECT_EQ(down->first_hz, 9.07e9);
  EXPECT_DOUBLE_EQ(down->step_hz, -10e6);
}

// Whatever the order: first + step * order[place] is the carrier, to 1e-12 of it.
TEST(SteppedGrid, OfHoppingCarriersSaysTheStepOfEachPlace) {
  std::mt19937_64 random(7);
  for (int turn = 0; turn < 50; ++turn) {
    const std::size_t steps = 2 + random() % 40;
    const std::size_t run = 1 + random() % 3;
    std::vector<double> places;
    for (std::size_t i = 0; i < steps; ++i) places.push_back(1e9 + 3.3e6 * static_cast<double>(i));
    std::ranges::shuffle(places, random);
    std::vector<double> list;
    for (const double hz : places) list.insert(list.end(), run, hz);
    const auto grid = stepped_grid(CarrierPlan::list(list), 0);
    ASSERT_TRUE(grid) << steps;
    EXPECT_EQ(grid->steps, steps);
    EXPECT_EQ(grid->pulses_per_step, run);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::size_t place = i / run;
      const std::size_t step = grid->order.empty() ? place : grid->order[place];
      EXPECT_NEAR(grid->first_hz + static_cast<double>(step) * grid->step_hz, list[i], 2e-12 * list[i]);
    }
  }
}

TEST(SteppedGrid, IsNoneWhereCarriersAreUnevenOrOneComesMoreOften) {
  EXPECT_FALSE(stepped_grid(CarrierPlan::list({9e9, 9.1e9, 9.3e9}), 0));
  EXPECT_FALSE(stepped_grid(CarrierPlan::list({9e9, 9.1e9, 9e9, 9.2e9}), 0));
  EXPECT_FALSE(stepped_grid(CarrierPlan::list({9e9, 9e9, 9.1e9}), 0));
  const auto one = stepped_grid(CarrierPlan::list({9e9, 9e9}), 0);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->steps, 1U);
  EXPECT_EQ(stepped_grid(CarrierPlan::single(5e9), 0)->first_hz, 5e9);
}

}  // namespace stepped_grid_test
}  // namespace sarsim::workflow
