#include "core/maths/interpolator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/maths/constants.hpp"

namespace sarsim::core {
namespace interpolator_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr std::array all_methods{Interpolation::linear, Interpolation::cubic, Interpolation::low_pass};

Interpolator through(Interpolation method, std::vector<Knot> knots, LowPassRule rule = LowPassRule::first_knot) {
  return Interpolator(SampledFunction{method, std::move(knots)}, rule);
}

// Uneven knots, spacing between 0.5 and 1.5, ordinates within 1.
std::vector<Knot> uneven_knots(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> gap(0.5, 1.5);
  std::uniform_real_distribution<double> ordinate(-1.0, 1.0);
  std::vector<Knot> knots;
  double x = -3.0;
  for (std::size_t i = 0; i < count; ++i, x += gap(random)) knots.push_back({x, ordinate(random)});
  return knots;
}

TEST(Interpolator, OfNoKnotsIsZero) {
  for (const Interpolation method : all_methods) {
    EXPECT_EQ(through(method, {}).value(17.0), 0.0);
    EXPECT_TRUE(through(method, {}).empty());
  }
  EXPECT_EQ(Interpolator().value(-3.0), 0.0);
}

TEST(Interpolator, OfOneKnotIsConstantWithoutSlope) {
  for (const Interpolation method : all_methods)
    for (const double x : {-1e9, 2.0, 3.0, 1e9}) {
      const Jet jet = through(method, {{2.0, 5.5}}).jet(x);
      EXPECT_EQ(jet.value, 5.5);
      EXPECT_EQ(jet.slope, 0.0);
      EXPECT_EQ(jet.curvature, 0.0);
    }
}

TEST(Interpolator, ScalesOrdinatesAndTheirDerivatives) {
  const SampledFunction function{Interpolation::cubic, {{0.0, 0.0}, {1.0, 1.0}, {3.0, 0.0}}};
  const Interpolator plain(function);
  const Interpolator doubled(function, LowPassRule::first_knot, 2.0);
  for (const double x : {-1.0, 0.3, 1.7, 4.0}) {
    EXPECT_EQ(doubled.jet(x).value, 2.0 * plain.jet(x).value);
    EXPECT_EQ(doubled.jet(x).slope, 2.0 * plain.jet(x).slope);
    EXPECT_EQ(doubled.jet(x).curvature, 2.0 * plain.jet(x).curvature);
  }
}

TEST(LinearInterpolator, ExtendsTheFirstAndTheLastSegment) {
  const Interpolator f = through(Interpolation::linear, {{0.0, 1.0}, {1.0, 3.0}, {3.0, -1.0}});
  EXPECT_EQ(f.value(0.5), 2.0);
  EXPECT_EQ(f.value(2.0), 1.0);
  EXPECT_EQ(f.value(-2.0), -3.0);
  EXPECT_EQ(f.value(5.0), -5.0);
}

TEST(LinearInterpolator, HasTheSlopeToTheRightAtAKnot) {
  const Interpolator f = through(Interpolation::linear, {{0.0, 1.0}, {1.0, 3.0}, {3.0, -1.0}});
  EXPECT_EQ(f.jet(0.0).slope, 2.0);
  EXPECT_EQ(f.jet(1.0).slope, -2.0);
  EXPECT_EQ(f.jet(std::nextafter(1.0, 0.0)).slope, -2.0);  // a send time that missed the knot by rounding
  EXPECT_EQ(f.jet(1.0 - 1e-9).slope, 2.0);
  EXPECT_EQ(f.jet(3.0).slope, -2.0);
}

TEST(CubicInterpolator, ThroughTwoKnotsIsTheStraightLine) {
  const Interpolator f = through(Interpolation::cubic, {{1.0, 2.0}, {3.0, 8.0}});
  for (const double x : {-4.0, 1.0, 1.7, 3.0, 12.0}) {
    EXPECT_NEAR(f.jet(x).value, 3.0 * x - 1.0, 8.0 * epsilon * (3.0 * std::abs(x) + 1.0));
    EXPECT_NEAR(f.jet(x).slope, 3.0, 8.0 * epsilon);
  }
}

// On (0,0) (1,1) (2,0) the clamped slopes are 1, 0, -1: u + u^2 - u^3 on the first segment.
TEST(CubicInterpolator, MatchesTheHandCalculationOnEvenKnots) {
  const Interpolator f = through(Interpolation::cubic, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}});
  EXPECT_NEAR(f.value(0.5), 0.625, 4.0 * epsilon);
  EXPECT_NEAR(f.value(1.5), 0.625, 4.0 * epsilon);
  EXPECT_NEAR(f.jet(1.0).slope, 0.0, 4.0 * epsilon);
  EXPECT_NEAR(f.jet(0.5).curvature, 2.0 - 3.0, 16.0 * epsilon);
}

// On (0,0) (1,1) (3,0): end slopes 1 and -1/2, 2 * 1 + 6 s - 1/2 = 3 (2 * 1 - 1/2), so s = 1/2 at the middle knot.
TEST(CubicInterpolator, MatchesTheHandCalculationOnUnevenKnots) {
  const Interpolator f = through(Interpolation::cubic, {{0.0, 0.0}, {1.0, 1.0}, {3.0, 0.0}});
  EXPECT_NEAR(f.jet(0.0).slope, 1.0, 4.0 * epsilon);
  EXPECT_NEAR(f.jet(1.0).slope, 0.5, 4.0 * epsilon);
  EXPECT_NEAR(f.jet(3.0).slope, -0.5, 8.0 * epsilon);
}

TEST(CubicInterpolator, ReproducesAStraightLineOnUnevenKnots) {
  std::vector<Knot> knots = uneven_knots(1, 9);
  for (Knot& knot : knots) knot.y = 2.0 - 0.75 * knot.x;
  const Interpolator f = through(Interpolation::cubic, knots);
  for (double x = -6.0; x < 9.0; x += 0.37) {
    EXPECT_NEAR(f.jet(x).value, 2.0 - 0.75 * x, 100.0 * epsilon);  // nine unknowns, numbers up to 10
    EXPECT_NEAR(f.jet(x).slope, -0.75, 100.0 * epsilon);
    EXPECT_NEAR(f.jet(x).curvature, 0.0, 1000.0 * epsilon);
  }
}

// Left and right of a knot by d: values differ by slope 2d, slopes by curvature 2d, curvatures by third derivative 2d.
// Ordinates within 1 on knots 0.5 apart keep slopes below 10, curvatures below 100, third derivatives below 1000.
TEST(CubicInterpolator, HasContinuousSlopeAndCurvatureAtInnerKnots) {
  const std::vector<Knot> knots = uneven_knots(2, 12);
  const Interpolator f = through(Interpolation::cubic, knots);
  constexpr double d = 1e-9;
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    const Jet left = f.jet(knots[i].x - d);
    const Jet right = f.jet(knots[i].x + d);
    EXPECT_NEAR(f.value(knots[i].x), knots[i].y, 100.0 * epsilon);
    EXPECT_NEAR(left.value, right.value, 10.0 * 2.0 * d);
    EXPECT_NEAR(left.slope, right.slope, 100.0 * 2.0 * d);
    EXPECT_NEAR(left.curvature, right.curvature, 1000.0 * 2.0 * d);
  }
}

TEST(CubicInterpolator, HasTheSlopesOfTheOuterChordsAtTheEndsAndGoesOnStraight) {
  const std::vector<Knot> knots = uneven_knots(3, 7);
  const Interpolator f = through(Interpolation::cubic, knots);
  const Knot &a = knots[0], &b = knots[1], &y = knots[5], &z = knots[6];
  const double first_chord = (b.y - a.y) / (b.x - a.x);
  const double last_chord = (z.y - y.y) / (z.x - y.x);
  EXPECT_NEAR(f.jet(a.x).slope, first_chord, 20.0 * epsilon);
  EXPECT_NEAR(f.jet(z.x).slope, last_chord, 200.0 * epsilon);
  EXPECT_NEAR(f.value(a.x - 10.0), a.y - 10.0 * first_chord, 200.0 * epsilon);
  EXPECT_NEAR(f.value(z.x + 10.0), z.y + 10.0 * last_chord, 200.0 * epsilon);
  EXPECT_EQ(f.jet(a.x - 1.0).curvature, 0.0);
  EXPECT_EQ(f.jet(z.x + 1.0).curvature, 0.0);
}

TEST(CubicInterpolator, IsTheMirrorImageOfThatOfMirroredKnots) {
  const std::vector<Knot> knots = uneven_knots(4, 10);
  std::vector<Knot> mirrored;
  for (const Knot& knot : knots) mirrored.insert(mirrored.begin(), {-knot.x, knot.y});
  const Interpolator f = through(Interpolation::cubic, knots);
  const Interpolator g = through(Interpolation::cubic, mirrored);
  for (double x = -5.0; x < 10.0; x += 0.31) EXPECT_NEAR(f.value(x), g.value(-x), 500.0 * epsilon);
}

Interpolator not_a_knot(std::vector<Knot> knots) {
  return Interpolator(SampledFunction{Interpolation::cubic, std::move(knots)},
                      {LowPassRule::first_knot, CubicEnds::not_a_knot});
}

TEST(NotAKnot, ReproducesCubicPolynomialsOnUnevenKnots) {
  const auto p = [](double x) { return 2.0 + x * (-0.75 + x * (0.3 - 0.125 * x)); };
  const auto slope = [](double x) { return -0.75 + x * (0.6 - 0.375 * x); };
  for (const std::size_t count : {4U, 5U, 9U, 30U}) {
    std::vector<Knot> knots = uneven_knots(1, count);
    for (Knot& knot : knots) knot.y = p(knot.x);
    const Interpolator f = not_a_knot(knots);
    const double first = knots.front().x, last = knots.back().x;
    const double largest = std::abs(p(first)) + std::abs(p(last)) + 10.0;
    for (int i = 0; i <= 100; ++i) {
      const double x = first + (last - first) * i / 100.0;
      ASSERT_NEAR(f.jet(x).value, p(x), 100.0 * epsilon * largest) << count << ' ' << x;
      ASSERT_NEAR(f.jet(x).slope, slope(x), 1000.0 * epsilon * largest) << count << ' ' << x;
    }
    // Straight lines outside.
    EXPECT_NEAR(f.value(last + 3.0), p(last) + 3.0 * slope(last), 4000.0 * epsilon * largest);
  }
}

TEST(NotAKnot, IsTheParabolaThroughThreeKnotsAndTheLineThroughTwo) {
  const Interpolator parabola = not_a_knot({{0.0, 1.0}, {1.0, 0.0}, {3.0, 4.0}});  // (x - 1)^2
  for (const double x : {0.0, 0.3, 1.0, 2.2, 3.0}) {
    EXPECT_NEAR(parabola.jet(x).value, (x - 1.0) * (x - 1.0), 16.0 * epsilon);
    EXPECT_NEAR(parabola.jet(x).slope, 2.0 * (x - 1.0), 16.0 * epsilon);
  }
  EXPECT_NEAR(not_a_knot({{1.0, 2.0}, {3.0, 8.0}}).value(2.5), 6.5, 8.0 * epsilon);
  EXPECT_EQ(not_a_knot({{1.0, 2.0}}).value(7.0), 2.0);
}

// Through (0,0) (1,0) (2,1) (3,0) (4,0) one cubic reaches from 0 to 2, level at 2 by symmetry: x (x - 1) (2 - 3/4 x).
TEST(NotAKnot, MatchesTheHandCalculationOnFiveKnots) {
  const Interpolator f = not_a_knot({{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}, {3.0, 0.0}, {4.0, 0.0}});
  EXPECT_NEAR(f.jet(0.0).slope, -2.0, 32.0 * epsilon);
  EXPECT_NEAR(f.value(0.5), -0.40625, 32.0 * epsilon);
  EXPECT_NEAR(f.value(1.5), 0.75 * (2.0 - 1.125), 32.0 * epsilon);
  EXPECT_NEAR(f.value(3.5), -0.40625, 32.0 * epsilon);
  EXPECT_NEAR(f.jet(2.0).slope, 0.0, 32.0 * epsilon);
}

TEST(NotAKnot, HasEqualThirdDerivativesOnBothSidesOfTheKnotsNextToTheEnds) {
  for (const unsigned seed : {2U, 3U}) {
    const std::vector<Knot> knots = uneven_knots(seed, 12);
    const Interpolator f = not_a_knot(knots);
    constexpr double d = 1e-6;
    for (const std::size_t i : {std::size_t{1}, knots.size() - 2}) {
      const double left = f.third_derivative(knots[i].x - d), right = f.third_derivative(knots[i].x + d);
      EXPECT_NEAR(left, right, 1e5 * epsilon * (1.0 + std::abs(left)));
    }
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
      EXPECT_NEAR(f.value(knots[i].x), knots[i].y, 100.0 * epsilon);
      EXPECT_NEAR(f.jet(knots[i].x - d).curvature, f.jet(knots[i].x + d).curvature, 4.0 * d * 1000.0);
    }
  }
}

// A circular orbit at 700 km, a point every 10 s, of acceleration a: the slope of a chord is wrong by a h/2, which
// moves the path by 0.08 a h^2 near the ends (64 m) and dies by 2 - sqrt(3) from point to point. Not a knot leaves 1/38
// of the fourth derivative times h^4 there and 1/384 inside.
TEST(NotAKnot, FollowsAnOrbitWhereChordsLoseTensOfMetres) {
  constexpr double radius_m = 7.071e6, rate = 1.0617e-3, h = 10.0;
  std::vector<Knot> knots;
  for (int i = -12; i <= 12; ++i) knots.push_back({h * i, radius_m * std::cos(rate * h * i)});
  const auto worst = [&](const Interpolator& f, double from, double to) {
    double error = 0.0;
    for (double t = from; t <= to; t += 0.1)
      error = std::max(error, std::abs(f.value(t) - radius_m * std::cos(rate * t)));
    return error;
  };
  constexpr double a = radius_m * rate * rate;
  constexpr double fourth = a * rate * rate * h * h * h * h;
  const Interpolator chords = through(Interpolation::cubic, knots), smooth = not_a_knot(knots);
  EXPECT_NEAR(worst(chords, -120.0, -110.0) / (a * h * h), 0.08, 0.008);
  EXPECT_NEAR(worst(chords, -100.0, -90.0) / worst(chords, -110.0, -100.0), 2.0 - std::sqrt(3.0), 0.01);
  EXPECT_NEAR(worst(smooth, -120.0, -110.0) / fourth, 1.0 / 38.0, 0.1 / 38.0);
  EXPECT_NEAR(worst(smooth, -20.0, 20.0) / fourth, 1.0 / 384.0, 0.1 / 384.0);
}

// Central differences over +-h err by h^2/6 |f'''| in the slope and h^2/12 |f''''| in the curvature, and by rounding
// R/h and 4 R/h^2 with R the rounding of a value. Pieces are about 1 wide with ordinates within 1: third and fourth
// derivatives stay below 1000 (tapered sincs: 22 terms, each below pi^3/4 and pi^4/5, plus the normalisation), R below
// 100 epsilon.
TEST(Interpolator, DerivativesAgreeWithCentralDifferences) {
  constexpr double h = 1e-4;
  constexpr double slope_bound = h * h / 6.0 * 1e3 + 100.0 * epsilon / h;
  constexpr double curvature_bound = h * h / 12.0 * 1e4 + 400.0 * epsilon / (h * h);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-4.0, 14.0);
  const std::vector<Knot> knots = uneven_knots(5, 16);
  for (const Interpolation method : all_methods)
    for (const LowPassRule rule : {LowPassRule::first_knot, LowPassRule::origin}) {
      const Interpolator f = through(method, knots, rule);
      const double step = (knots.back().x - knots.front().x) / 15.0;
      for (int i = 0; i < 300; ++i) {
        const double x = place(random);
        // Where the function may bend or, for the bare sinc, jump between two sets of terms, there is nothing to
        // compare.
        const bool near_knot = std::ranges::any_of(knots, [&](const Knot& k) { return std::abs(k.x - x) < 2.0 * h; });
        const double cell = x / step - 0.5;
        if (near_knot || std::abs(cell - std::round(cell)) < 2.0 * h / step) continue;
        const Jet jet = f.jet(x);
        const double left = f.value(x - h), right = f.value(x + h);
        ASSERT_NEAR(jet.slope, (right - left) / (2.0 * h), slope_bound) << x;
        ASSERT_NEAR(jet.curvature, (right - 2.0 * jet.value + left) / (h * h), curvature_bound) << x;
      }
    }
}

// Knots 1 apart and points 1/200 apart: the curvature of a cubic is largest at a knot, which is among the points.
TEST(Interpolator, CurvatureBoundIsReachedByCubicsAndPassedByNone) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> y(-1.0, 1.0);
  for (const CubicEnds ends : {CubicEnds::chords, CubicEnds::not_a_knot}) {
    SampledFunction function{Interpolation::cubic, {}};
    for (int i = 0; i < 6; ++i) function.knots.push_back({static_cast<double>(i), y(random)});
    const Interpolator f(function, InterpolationRules(LowPassRule::first_knot, ends));
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i) largest = std::max(largest, std::abs(f.jet(0.005 * i).curvature));
    EXPECT_NEAR(f.curvature_bound(), largest, 1e-12 * largest);
  }
  EXPECT_EQ(Interpolator({Interpolation::linear, {{0, 0}, {1, 5}, {2, 0}}}).curvature_bound(), 0.0);
  EXPECT_EQ(Interpolator({Interpolation::cubic, {{0, 7}}}).curvature_bound(), 0.0);
  EXPECT_TRUE(std::isinf(Interpolator({Interpolation::low_pass, {{0, 0}, {1, 5}, {2, 0}}}).curvature_bound()));
}

// The quotient of curvatures 2e-4 apart errs by 2e-8/6 of the fifth derivative (below 1e5) and rounding as above.
TEST(Interpolator, ThirdDerivativeIsThatOfTheCurvature) {
  constexpr double h = 1e-4;
  const std::vector<Knot> knots = uneven_knots(5, 16);
  for (const Interpolation method : all_methods) {
    const Interpolator f = through(method, knots);
    for (double x = -5.05; x < 14.0; x += 0.173) {
      const bool near_knot = std::ranges::any_of(knots, [&](const Knot& k) { return std::abs(k.x - x) < 2e-3; });
      if (near_knot) continue;
      const double quotient = (f.jet(x + h).curvature - f.jet(x - h).curvature) / (2.0 * h);
      ASSERT_NEAR(f.third_derivative(x), quotient, 1e-2 + 1e4 * epsilon / h) << x;
    }
  }
}

TEST(LowPassInterpolator, PassesThroughTheKnotsOfAUniformGrid) {
  std::vector<Knot> knots = uneven_knots(7, 40);
  for (std::size_t i = 0; i < knots.size(); ++i) knots[i].x = 100.0 + 0.25 * static_cast<double>(i);
  const Interpolator f = through(Interpolation::low_pass, knots);
  // sin(pi m) of a whole number m up to 11 is m epsilon; the largest of 22 terms counts.
  for (const Knot& knot : knots) EXPECT_NEAR(f.value(knot.x), knot.y, 22.0 * 11.0 * epsilon);
}

TEST(LowPassInterpolator, ReproducesAConstantEverywhere) {
  std::vector<Knot> knots = uneven_knots(8, 25);
  for (Knot& knot : knots) knot.y = -2.5;
  const Interpolator f = through(Interpolation::low_pass, knots);
  for (double x = -10.0; x < 30.0; x += 0.217) {
    EXPECT_NEAR(f.jet(x).value, -2.5, 50.0 * epsilon);
    EXPECT_NEAR(f.jet(x).slope, 0.0, 1e3 * epsilon);
  }
}

TEST(LowPassInterpolator, HoldsTheEndValuesOutside) {
  const Interpolator f = through(Interpolation::low_pass, {{0.0, 3.0}, {1.0, 1.0}, {2.0, -4.0}});
  EXPECT_EQ(f.value(-0.5), 3.0);
  EXPECT_EQ(f.value(-1e6), 3.0);
  EXPECT_EQ(f.value(2.5), -4.0);
  EXPECT_EQ(f.jet(7.0).slope, 0.0);
}

// A tone of a tenth of the grid's frequency, seen in the middle of 41 knots: the kernel's pass band reaches to
// 1/2 - 1/11, and its Hann taper leaves ripples below -60 dB there.
TEST(LowPassInterpolator, ReproducesASlowOscillationBetweenTheKnots) {
  std::vector<Knot> knots;
  for (int i = 0; i <= 40; ++i) knots.push_back({0.5 * i, std::cos(2.0 * pi * 0.1 * i)});
  const Interpolator f = through(Interpolation::low_pass, knots);
  for (double x = 7.0; x < 13.0; x += 0.11) EXPECT_NEAR(f.value(x), std::cos(2.0 * pi * 0.2 * x), 1e-3);
}

TEST(LowPassInterpolator, TakesMeansOfCrowdedKnotsAndStraightLinesOverGaps) {
  // Step 1: both first knots belong to grid point 0, none to grid point 1.
  const std::vector<Knot> knots{{0.0, 1.0}, {0.25, 3.0}, {2.25, 7.0}, {3.0, 5.0}};
  const Interpolator f = through(Interpolation::low_pass, knots);
  EXPECT_NEAR(f.value(0.0), 2.0, 100.0 * epsilon);
  EXPECT_NEAR(f.value(1.0), 3.0 + 4.0 * 0.75 / 2.0, 1e3 * epsilon);
  EXPECT_NEAR(f.value(2.0), 7.0, 1e3 * epsilon);
}

// The sanitizer would report the overflow of an index.
TEST(LowPassInterpolator, IsNaNAtNaNAndByTheRuleOf1998Zero) {
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(through(Interpolation::low_pass, uneven_knots(4, 20)).value(nowhere)));
  EXPECT_EQ(through(Interpolation::low_pass, uneven_knots(4, 20), LowPassRule::origin).value(nowhere), 0.0);
}

// Inside, what lies beyond makes no difference; outside there is one value, without a slope.
TEST(Interpolator, HoldsItsEndsOrIsZeroOutsideWhereItIsAsked) {
  for (const Interpolation method : {Interpolation::linear, Interpolation::cubic, Interpolation::low_pass})
    for (const LowPassRule rule : {LowPassRule::first_knot, LowPassRule::origin})
      for (const unsigned seed : {1U, 2U, 3U}) {
        const SampledFunction function{method, uneven_knots(seed, 3 + 5 * seed)};
        const Interpolator extended(function, {rule, CubicEnds::chords});
        const Interpolator held(function, {rule, CubicEnds::chords, Beyond::held});
        const Interpolator zero(function, {rule, CubicEnds::chords, Beyond::zero});
        const double first = function.knots.front().x, last = function.knots.back().x;
        for (double share = 0.0; share <= 1.0; share += 0.03) {
          const double x = first + share * (last - first);
          ASSERT_EQ(held.value(x), extended.value(x));
          ASSERT_EQ(zero.value(x), extended.value(x));
        }
        for (const double off : {1e-9, 1.0, 1e6}) {
          ASSERT_EQ(zero.value(first - off), 0.0);
          ASSERT_EQ(zero.jet(last + off).slope, 0.0);
          ASSERT_EQ(held.jet(first - off).slope, 0.0);
          ASSERT_EQ(held.value(first - off), held.value(first - 2.0 * off));
          ASSERT_EQ(held.value(last + off), held.value(last + 2.0 * off));
          if (method == Interpolation::low_pass) continue;  // Its ends are means of knots.
          ASSERT_EQ(held.value(first - off), function.knots.front().y);
          ASSERT_EQ(held.value(last + off), function.knots.back().y);
        }
      }
}

TEST(Interpolator, OfOnePointIsConstantWhateverLiesBeyond) {
  const Interpolator f({Interpolation::linear, {{2.0, 5.0}}},
                       {LowPassRule::first_knot, CubicEnds::chords, Beyond::zero});
  EXPECT_EQ(f.value(7.0), 5.0);
}

TEST(ClassicLowPassInterpolator, IsTheBareSincOfTheTestVector) {
  const Interpolator f = through(Interpolation::low_pass, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}, LowPassRule::origin);
  EXPECT_NEAR(f.value(1.0), 1.0, epsilon);
  EXPECT_NEAR(f.value(0.5), 2.0 / pi, 4.0 * epsilon);
  EXPECT_NEAR(f.value(-1.5), std::sin(2.5 * pi) / (2.5 * pi), 4.0 * epsilon);
  EXPECT_EQ(f.value(12.0), 0.0);  // 21 terms: grid point 1 is 11 steps away
}

TEST(ClassicLowPassInterpolator, HasItsGridAnchoredAtZeroAndLeavesGapsEmpty) {
  // Step 1; 0.5 belongs to grid point 0 (upper border), 1.75 and 2.5 to grid point 2; grid point 1 stays 0.
  const Interpolator f = through(Interpolation::low_pass, {{0.5, 4.0}, {1.75, 1.0}, {2.5, 2.0}}, LowPassRule::origin);
  EXPECT_NEAR(f.value(0.0), 4.0, 10.0 * epsilon);
  EXPECT_NEAR(f.value(1.0), 0.0, 10.0 * epsilon);
  EXPECT_NEAR(f.value(2.0), 1.5, 10.0 * epsilon);
}

}  // namespace interpolator_test
}  // namespace sarsim::core
