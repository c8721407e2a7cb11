#include "core/maths/rounding.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/text/number_text.hpp"

namespace sarsim::core {
namespace rounding_test {

TEST(Rounding, TakesAwayWhatSumsLeaveBehind) {
  EXPECT_EQ(tidy(0.1 + 0.2), 0.3);
  EXPECT_EQ(tidy(9860.166000000001), 9860.166);
  EXPECT_EQ(tidy(123456789.0, 4), 123500000.0);
  EXPECT_EQ(tidy(-1e-300), -1e-300);
  EXPECT_FALSE(std::signbit(tidy(-0.0)));
  EXPECT_TRUE(std::isnan(tidy(std::nan(""))));
  EXPECT_EQ(tidy(-std::numeric_limits<double>::infinity()), -std::numeric_limits<double>::infinity());
}

TEST(Rounding, GivesMultiplesOfAStepWithItsDecimals) {
  EXPECT_EQ(format_number(rounded_to(9860.16571, 1e-3)), "9860.166");
  EXPECT_EQ(format_number(rounded_to(0.0123456789012, 1e-9)), "0.012345679");
  for (int i = -5000; i <= 5000; ++i) {
    const double value = 9860.0 + 0.0017 * i;
    const double rounded = rounded_to(value, 1e-3);
    EXPECT_NEAR(rounded, value, 0.5000001e-3);
    EXPECT_LE(format_number(rounded).size(), std::string("9860.166").size()) << value;
  }
}

TEST(Rounding, KeepsAValueWhereThereIsNoStep) {
  EXPECT_EQ(rounded_to(0.1234567891234567, 0.0), 0.1234567891234567);
  EXPECT_EQ(rounded_to(2.5, -1.0), 2.5);
  EXPECT_TRUE(std::isnan(rounded_to(std::nan(""), 1.0)));
  EXPECT_EQ(rounded_to(1e308, 1e308), 1e308);
}

TEST(RoundedTo, TakesEachCoordinateOfAVector) {
  EXPECT_EQ(rounded_to(Vec3{1.26, -0.04, 7.0}, 0.1), (Vec3{1.3, 0.0, 7.0}));
}

}  // namespace rounding_test
}  // namespace sarsim::core
