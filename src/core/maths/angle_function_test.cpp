#include "core/maths/angle_function.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::core {
namespace angle_function_test {
namespace {

SampledFunction lines(std::vector<Knot> knots) { return {Interpolation::linear, std::move(knots)}; }

AngleFunction azimuth(std::vector<Knot> knots, Interpolation method = Interpolation::linear) {
  return {SampledFunction{method, std::move(knots)}, {}, AngleRule::azimuth};
}

AngleFunction elevation(std::vector<Knot> knots, Interpolation method = Interpolation::linear) {
  return {SampledFunction{method, std::move(knots)}, {}, AngleRule::elevation};
}

// A straight line through two of the points, by hand.
double between(const Knot& a, const Knot& b, double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); }

TEST(AngleFunction, TellsOneSideFromTheOther) {
  const AngleFunction cut =
      elevation({{-90, -40}, {-10, -30}, {-2, -3}, {0, 0}, {2, -1}, {10, -6}, {40, -12}, {90, -40}});
  EXPECT_FALSE(cut.is_even());
  EXPECT_EQ(cut.value(10.0), -6.0);
  EXPECT_EQ(cut.value(-10.0), -30.0);
  EXPECT_EQ(cut.value(0.0), 0.0);
  EXPECT_TRUE(cut.covers(90.0) && cut.covers(-90.0));
}

// Tables of one side, as scripts of 1998 mean them; they end at half a turn or before.
TEST(AngleFunction, MirrorsTablesWithoutNegativeAngles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 180.0), gain(-60.0, 0.0);
  for (int draw = 0; draw < 200; ++draw) {
    std::vector<Knot> knots;
    for (int i = 0; i < 6; ++i) knots.push_back({place(random), gain(random)});
    std::ranges::sort(knots, {}, &Knot::x);
    for (const AngleRule rule : {AngleRule::azimuth, AngleRule::elevation})
      for (const Interpolation method : {Interpolation::linear, Interpolation::cubic, Interpolation::low_pass}) {
        const AngleFunction cut({method, knots}, {}, rule);
        const Interpolator half({method, knots}, {LowPassRule::first_knot, CubicEnds::chords, Beyond::held});
        ASSERT_TRUE(cut.is_even());
        for (int look = 0; look < 20; ++look) {
          const double x = place(random);
          ASSERT_EQ(cut.value(x), half.value(x));
          ASSERT_EQ(cut.value(-x), half.value(x));
          ASSERT_EQ(cut.covers(-x), x >= knots.front().x - 1e-9 && x <= knots.back().x + 1e-9);
        }
      }
  }
}

TEST(AngleFunction, HoldsTheNearerEndWhereATableHasNoPoints) {
  const AngleFunction cut = azimuth({{-20, -30}, {-10, -40}, {0, 0}, {10, -35}, {20, -25}});
  EXPECT_FALSE(cut.goes_round());
  for (const double x : {20.5, 60.0, 90.0, 179.0}) {
    EXPECT_EQ(cut.value(x), -25.0) << x;
    EXPECT_EQ(cut.value(-x), -30.0) << x;
    EXPECT_FALSE(cut.covers(x) || cut.covers(-x)) << x;
  }
  const AngleFunction one_side = azimuth({{10, -3}, {20, -9}});
  EXPECT_EQ(one_side.value(0.0), -3.0);
  EXPECT_EQ(one_side.value(-180.0), -9.0);
}

// Angles of 0 to 360 degrees, of a table that begins anywhere: with a period.
TEST(AngleFunction, TakesAnglesAWholeTurnAway) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> gain(-60.0, 0.0), angle(-180.0, 180.0), start(-180.0, -1.0);
  for (int draw = 0; draw < 200; ++draw) {
    std::vector<Knot> signed_knots;
    const double first = start(random);
    for (int i = 0; i < 36; ++i) signed_knots.push_back({first + 10.0 * i, gain(random)});
    std::vector<Knot> turned = signed_knots;
    for (Knot& knot : turned) knot.x += knot.x < 0.0 ? 360.0 : 0.0;
    std::ranges::sort(turned, {}, &Knot::x);
    for (const Interpolation method : {Interpolation::linear, Interpolation::cubic, Interpolation::low_pass}) {
      const AngleFunction a = azimuth(signed_knots, method);
      const AngleFunction b = azimuth(turned, method);
      ASSERT_TRUE(a.goes_round() && b.goes_round());
      for (int look = 0; look < 20; ++look) {
        const double x = angle(random);
        // A slope of 60 dB in 10 degrees times the rounding of the angles; what is left of a spline's ends is 1e-14.
        ASSERT_NEAR(a.value(x), b.value(x), 1e-9) << x;
      }
      ASSERT_NEAR(a.value(-180.0), a.value(180.0), 1e-9);
    }
  }
}

TEST(AngleFunction, CrossesAGapOfTwoSpacingsAndNoWider) {
  const Knot first{-160, -10}, last{170, -20};
  const AngleFunction closed = azimuth({first, {-145, -3}, {0, 0}, {145, -3}, last});  // spacings up to 145, gap 30
  EXPECT_TRUE(closed.goes_round());
  EXPECT_NEAR(closed.value(180.0), between(last, {200, -10}, 180.0), 1e-12);
  EXPECT_NEAR(closed.value(-175.0), between(last, {200, -10}, 185.0), 1e-12);
  std::vector<Knot> fine;
  for (int i = -170; i <= 170; i += 10) fine.push_back({static_cast<double>(i), -0.1 * i});
  EXPECT_TRUE(azimuth(fine).goes_round());  // a gap of 20
  fine.front().x -= 5.0;
  EXPECT_TRUE(azimuth(fine).goes_round());  // a gap of 15 and a spacing of 15
  fine.erase(fine.begin(), fine.begin() + 2);
  EXPECT_FALSE(azimuth(fine).goes_round());  // a gap of 40
  EXPECT_EQ(azimuth(fine).value(-160.0), 15.0);
  EXPECT_EQ(azimuth(fine).value(180.0), -17.0);
}

// A spline that goes round has no seam: it meets a sine within the error of splines everywhere, 5 h^4/384 times the
// largest fourth derivative.
TEST(AngleFunction, OfASplineHasNoSeam) {
  std::vector<Knot> knots;
  const auto sine = [](double deg) { return std::sin(deg * rad_per_deg + 0.3); };
  for (int i = -180; i <= 180; i += 5) knots.push_back({static_cast<double>(i), sine(i)});
  knots.back().y = knots.front().y;  // one direction
  const AngleFunction cut = azimuth(knots, Interpolation::cubic);
  ASSERT_TRUE(cut.goes_round());
  const double error = 5.0 * std::pow(5.0 * rad_per_deg, 4) / 384.0;
  for (double x = -180.0; x <= 180.0; x += 0.37) EXPECT_NEAR(cut.value(x), sine(x), error) << x;
}

TEST(AngleFunction, OfOnePointIsConstantAndOfNoneZero) {
  EXPECT_EQ(azimuth({{-30, -7}}).value(120.0), -7.0);
  EXPECT_TRUE(azimuth({{-30, -7}}).covers(120.0));
  EXPECT_EQ(elevation({}).value(-3.0), 0.0);
  EXPECT_EQ(AngleFunction().value(10.0), 0.0);
}

// Both ends are the same direction, with different gains: a step there, nowhere else.
TEST(AngleFunction, KeepsAStepBehind) {
  const AngleFunction cut = azimuth({{-180, -50}, {0, 0}, {180, -20}});
  EXPECT_EQ(cut.value(-180.0), -50.0);
  EXPECT_EQ(cut.value(180.0), -20.0);
  EXPECT_EQ(cut.value(180.0 + 1e-13), -20.0);
}

TEST(AngleFunction, OfElevationDoesNotCrossTheZenith) {
  const AngleFunction cut = elevation({{-80, -40}, {0, 0}, {80, -10}});
  EXPECT_EQ(cut.value(90.0), -10.0);
  EXPECT_EQ(cut.value(-90.0), -40.0);
  EXPECT_FALSE(cut.covers(85.0));
}

TEST(AngleFunction, OfMagnitudesGoesOnAsTheProgramsOf1998Do) {
  const AngleFunction cut(lines({{-20, -30}, {-10, -40}, {0, 0}, {10, -40}, {20, -30}}), {}, AngleRule::magnitude);
  EXPECT_NEAR(cut.value(180.0), 130.0, 1e-12);
  EXPECT_NEAR(cut.value(-180.0), 130.0, 1e-12);
  EXPECT_TRUE(cut.is_even());
}

}  // namespace
}  // namespace angle_function_test
}  // namespace sarsim::core
