#include "core/maths/window.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace sarsim::core {
namespace window_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(Windows, AreSymmetricAboutTheMiddleAndOneThere) {
  const std::function<double(double)> windows[]{
      [](double x) { return hanning_window(x, 0.0); }, [](double x) { return hanning_window(x, 0.3); }, hamming_window,
      bartlett_window, [](double x) { return kaiser_window(2 * x - 1, 6.0); }};
  for (const auto& window : windows) {
    EXPECT_NEAR(window(0.5), 1.0, 4.0 * epsilon);
    for (const double x : {0.0, 0.125, 0.3, 0.45}) EXPECT_NEAR(window(x), window(1.0 - x), 20.0 * epsilon);
  }
}

TEST(HanningWindow, StandsOnItsPedestal) {
  for (const double pedestal : {0.0, 0.25, 1.0}) {
    EXPECT_NEAR(hanning_window(0.0, pedestal), pedestal, 2.0 * epsilon);
    EXPECT_NEAR(hanning_window(0.25, pedestal), 0.5 * (1.0 + pedestal), 2.0 * epsilon);
  }
}

TEST(HammingWindow, EndsAtEightHundredths) {
  EXPECT_NEAR(hamming_window(0.0), 0.08, 2.0 * epsilon);
  EXPECT_NEAR(hamming_window(0.25), 0.54, 2.0 * epsilon);
}

TEST(BartlettWindow, IsATriangle) {
  EXPECT_EQ(bartlett_window(0.0), 0.0);
  EXPECT_EQ(bartlett_window(0.25), 0.5);
  EXPECT_EQ(bartlett_window(0.875), 0.25);
  EXPECT_EQ(bartlett_window(1.0), 0.0);
}

// I0(2) = 2.2795853..., I0(sqrt 3) = 1.8929... by their power series sum (x^2/4)^k/(k!)^2.
// Abramowitz and Stegun, table 9.8: exp(-x) I0(x) at 1, 5 and 20 to ten digits; and the library's function.
TEST(BesselI0, HasTheTabulatedValues) {
  EXPECT_EQ(bessel_i0(0.0), 1.0);
  EXPECT_NEAR(std::exp(-1.0) * bessel_i0(1.0), 0.4657596076, 5e-11);
  EXPECT_NEAR(std::exp(-5.0) * bessel_i0(5.0), 0.1835408126, 5e-11);
  EXPECT_NEAR(std::exp(-20.0) * bessel_i0(20.0), 0.0897803119, 5e-11);
  for (double x = 0.1; x < 40.0; x += 0.7) EXPECT_NEAR(bessel_i0(x) / std::cyl_bessel_i(0.0, x), 1.0, 1e-13) << x;
}

TEST(KaiserWindow, IsTheRatioOfBesselFunctions) {
  const auto i0 = [](double x) {
    double term = 1.0, sum = 1.0;
    for (int k = 1; k < 40; ++k) sum += term *= x * x / 4.0 / (k * k);
    return sum;
  };
  EXPECT_NEAR(kaiser_window(0.5, 2.0), i0(std::sqrt(3.0)) / i0(2.0), 20.0 * epsilon);
  EXPECT_NEAR(kaiser_window(1.0, 2.0), 1.0 / i0(2.0), 20.0 * epsilon);
  EXPECT_EQ(kaiser_window(1.001, 2.0), 0.0);
  EXPECT_EQ(kaiser_window(-1.001, 2.0), 0.0);
}

}  // namespace window_test
}  // namespace sarsim::core
