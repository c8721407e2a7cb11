#include "radar/path/path.hpp"

#include <gtest/gtest.h>

#include "core/maths/constants.hpp"

namespace sarsim::radar {
namespace path_test {

constexpr double c = core::exact_light_speed_mps;

TEST(Path, OfAMicrosecondIsTheRadarMicrosecond) {
  EXPECT_DOUBLE_EQ(range_of(1e-6, c), 149.896229);
  EXPECT_DOUBLE_EQ(delay_of(149.896229, c), 1e-6);
  EXPECT_NEAR(delay_of(3000.0, c), 20.0138e-6, 1e-10);
}

TEST(Path, ToARangeAndBackHasItsDelayAndItsRange) {
  EXPECT_EQ(delay_of(there_and_back(1234.5), c), delay_of(1234.5, c));
  EXPECT_EQ(range_of(there_and_back(1234.5)), 1234.5);
}

TEST(Path, OfTwoDifferentWaysHasTheDelayOfBothTogether) {
  const Path path{c, 2.0 * c};
  EXPECT_DOUBLE_EQ(delay_of(path, c), 3.0);
  EXPECT_DOUBLE_EQ(range_of(path), range_of(delay_of(path, c), c));
}

TEST(Path, ToAPointThatRecedesIsCaughtUpWith) {
  const double speed_mps = 1e6;
  const double delay_s = moving_delay_of(there_and_back(3e5), speed_mps, c);
  // What the echo travels is the way of then and what the point went meanwhile, out and back.
  EXPECT_NEAR(c * delay_s, 6e5 + speed_mps * delay_s, 1e-9);
  EXPECT_EQ(moving_delay_of(there_and_back(3e5), 0.0, c), delay_of(3e5, c));
}

TEST(Path, RoundsAsTheFormulasThatItStandsFor) {
  for (double x = 0.123; x < 1e6; x *= 1.7) {
    EXPECT_EQ(delay_of(x, c), 2.0 * x / c);
    EXPECT_EQ(delay_of(x, c), x * 2.0 / c);
    EXPECT_EQ(moving_delay_of(there_and_back(x), 77.7, c), 2.0 * x / (c - 77.7));
    EXPECT_EQ(range_of(x, c), 0.5 * (c * x));
    EXPECT_EQ(range_of_cycle(x, c), c / (2.0 * x));
    EXPECT_EQ(turns_per_m(x, c), x * 2.0 / c);
    EXPECT_EQ(turns_of(x, 9.87e9, c), x * 9.87e9 * 2.0 / c);
    EXPECT_EQ(turns_of(x * -0.3, wavelength_of(9.87e9, c)), 2.0 * x * -0.3 / (c / 9.87e9));
    EXPECT_EQ(frequency_of_turns(1.0, x, c), 0.5 * c / x);
    EXPECT_EQ(frequency_of_turns(0.5, x, c), 0.25 * c / x);
    EXPECT_EQ(frequency_of_turns(77.0, x, c), 77.0 * c / (2.0 * x));
    EXPECT_EQ(speed_of(x, 0.031), -(0.5 * 0.031 * x));
    EXPECT_EQ(doppler_of(x, 9.87e9, c), -2.0 * x * 9.87e9 / c);
  }
}

TEST(Path, OfAMovingPointChangesItsTurnsByTheDopplerShift) {
  const double carrier_hz = 9.6e9;
  EXPECT_NEAR(turns_of(1001.0, carrier_hz, c) - turns_of(1000.0, carrier_hz, c), turns_per_m(carrier_hz, c), 1e-9);
  EXPECT_DOUBLE_EQ(turns_per_m(carrier_hz, c) * range_of_cycle(carrier_hz, c), 1.0);
  EXPECT_DOUBLE_EQ(doppler_of(12.0, carrier_hz, c), -12.0 * turns_per_m(carrier_hz, c));
  EXPECT_DOUBLE_EQ(speed_of(doppler_of(12.0, carrier_hz, c), carrier_hz, c), 12.0);
}

TEST(Path, GoesFromPhasesAndTurnsBackToRangesAndFrequencies) {
  const double carrier_hz = 9.6e9;
  EXPECT_DOUBLE_EQ(turns_of(1000.0, carrier_hz, c), turns_of(1000.0, wavelength_of(carrier_hz, c)));
  EXPECT_DOUBLE_EQ(frequency_of_turns(turns_of(1000.0, carrier_hz, c), 1000.0, c), carrier_hz);
  EXPECT_DOUBLE_EQ(range_of_phase(2.0 * core::pi, carrier_hz, c), range_of_cycle(carrier_hz, c));
}

static_assert(delay_of(there_and_back(0.0), c) == 0.0);

}  // namespace path_test
}  // namespace sarsim::radar
