#include "radar/atmosphere/polynomial_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::radar {
namespace polynomial_nodes_test {

TEST(PolynomialNodes, ReachBothEnds) {
  EXPECT_EQ(polynomial_nodes<9>().y.front(), -1.0);
  EXPECT_EQ(polynomial_nodes<9>().y.back(), 1.0);
  EXPECT_EQ(polynomial_nodes<9>().y[4], 0.0);
}

TEST(PowersThrough, FindThePolynomialOfTheValues) {
  const std::array<double, 6> powers{1.0, -2.0, 0.5, 0.25, -3.0, 0.125};
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < 6; ++i) values[i] = value_of_powers(powers, polynomial_nodes<6>().y[i]);
  const auto found = powers_through(values);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(found[k], powers[k], 1e-14);
}

TEST(PowersThrough, FollowASmoothFunction) {
  std::array<double, 9> values{};
  for (std::size_t i = 0; i < 9; ++i) values[i] = std::exp(polynomial_nodes<9>().y[i]);
  for (const double y : {-1.0, -0.3, 0.1, 0.77, 1.0})
    EXPECT_NEAR(value_of_powers(powers_through(values), y), std::exp(y), 2e-8);
}

}  // namespace polynomial_nodes_test
}  // namespace sarsim::radar
