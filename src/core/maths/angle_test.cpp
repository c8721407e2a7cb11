#include "core/maths/angle.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sarsim::core {
namespace angle_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Angle, KeepsTheDegreesThatWereTyped) {
  for (const double degrees : {0.0, -11.3, 0.1, 29.999, 360.0, 1e-300})
    EXPECT_EQ(Angle::from_deg(degrees).deg(), degrees);
}

TEST(Angle, TurnsDegreesIntoRadians) {
  EXPECT_EQ(Angle::from_deg(180.0).rad(), pi);
  EXPECT_EQ(Angle::from_deg(-90.0).rad(), -pi / 2.0);
}

// One product each way, each with a rounded factor and a rounded result: at most 4 half units.
TEST(Angle, ReturnsTheRadiansItWasGiven) {
  for (const double radians : {1.0, -0.3, 3e-5, 6.0})
    EXPECT_NEAR(Angle::from_rad(radians).rad(), radians, 2.0 * epsilon * std::abs(radians));
}

TEST(Angle, IsZeroUnlessSaid) { EXPECT_EQ(Angle(), Angle::from_deg(0.0)); }

TEST(Angle, ComparesWhatWasTyped) {
  EXPECT_EQ(Angle::from_deg(30.0), Angle::from_deg(30.0));
  EXPECT_NE(Angle::from_deg(0.0), Angle::from_deg(360.0));
}

TEST(PowerRatio, KeepsTheDecibelsThatWereTyped) {
  for (const double decibels : {0.0, 3.0, -0.1, 27.3}) EXPECT_EQ(PowerRatio::from_db(decibels).db(), decibels);
}

TEST(PowerRatio, IsTenToATenthOfTheDecibels) {
  EXPECT_EQ(PowerRatio().factor(), 1.0);
  EXPECT_DOUBLE_EQ(PowerRatio::from_db(10.0).factor(), 10.0);
  EXPECT_DOUBLE_EQ(PowerRatio::from_db(-20.0).factor(), 0.01);
  // 3 dB is 10^0.3 = 1.9952623..., not 2.
  EXPECT_NEAR(PowerRatio::from_db(3.0).factor(), 1.995262314968880, 4.0 * epsilon);
}

}  // namespace angle_test
}  // namespace sarsim::core
