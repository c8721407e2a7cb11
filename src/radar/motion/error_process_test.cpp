#include "radar/motion/error_process.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sarsim::radar {
namespace error_process_test {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

core::Interpolator envelope(std::vector<core::Knot> knots, core::Interpolation method = core::Interpolation::linear) {
  return core::Interpolator(core::SampledFunction{method, std::move(knots)});
}

ErrorProcess process(const core::Interpolator& h, std::uint64_t object = 5, int axis = 0) {
  return {h, core::RandomStream(1, core::RandomKind::position_envelope, object), axis};
}

struct Shape {
  const char* name;
  core::Interpolator h;
};

std::vector<Shape> shapes() {
  std::vector<core::Knot> bell;
  for (int i = -8; i <= 8; ++i) bell.push_back({0.5 + i / 16.0, 1.5 * std::exp(-0.5 * i * i / 6.0)});
  return {{"box", envelope({{0.0, 0.8}, {2.0, 0.8}})},
          {"triangle", envelope({{-1.0, 0.0}, {0.0, 2.0}, {1.0, 0.0}})},
          {"bell", envelope(bell, core::Interpolation::cubic)}};
}

double support_s(const core::Interpolator& h) { return h.knots().back().x - h.knots().front().x; }

// Integral of h(u) h(u + lag), h = 0 outside its knots, by the midpoint rule.
double autocorrelation(const core::Interpolator& h, double lag_s) {
  constexpr int panels = 20'000;
  const double first = h.knots().front().x;
  const double length = support_s(h) - lag_s;
  double sum = 0.0;
  for (int i = 0; i < panels && length > 0.0; ++i) {
    const double u = first + length * (i + 0.5) / panels;
    sum += h.value(u) * h.value(u + lag_s);
  }
  return std::max(0.0, length) * sum / panels;
}

// Times one support and a bit apart, so that the deviations at them are independent; on both sides of zero.
constexpr int looks = 4000;
double look_time_s(const core::Interpolator& h, int i) { return 1.031 * support_s(h) * (i - looks / 2); }

TEST(ErrorProcess, OfFewerThanTwoKnotsIsNoDeviation) {
  EXPECT_FALSE(ErrorProcess().active());
  EXPECT_FALSE(process(envelope({{0.0, 3.0}})).active());
  EXPECT_EQ(process(envelope({{0.0, 3.0}})).at(7.0).value, 0.0);
}

TEST(ErrorProcess, AutocorrelationIsThatOfTheEnvelope) {
  for (const auto& [name, h] : shapes()) {
    const ErrorProcess d = process(h);
    const double variance = autocorrelation(h, 0.0);
    for (const double share : {0.0, 0.25, 0.6, 1.01}) {
      const double lag_s = share * support_s(h);
      const double expected = autocorrelation(h, lag_s);
      double sum = 0.0;
      for (int i = 0; i < looks / 2; ++i) {
        const double t = look_time_s(h, 2 * i);  // every other: the pairs must be independent of each other
        sum += d.at(t).value * d.at(t + lag_s).value;
      }
      // The mean of n products of normal numbers has variance (R0^2 + R(lag)^2)/n. The grid's own error is below
      // 1/512 of the variance for a box.
      const double sigma = std::sqrt((variance * variance + expected * expected) / (looks / 2));
      EXPECT_NEAR(sum / (looks / 2), expected, 5.0 * sigma + variance / 512.0) << name << " at lag " << lag_s;
    }
  }
}

TEST(ErrorProcess, HasMeanZero) {
  for (const auto& [name, h] : shapes()) {
    const ErrorProcess d = process(h);
    double sum = 0.0;
    for (int i = 0; i < looks; ++i) sum += d.at(look_time_s(h, i)).value;
    EXPECT_NEAR(sum / looks, 0.0, 5.0 * std::sqrt(autocorrelation(h, 0.0) / looks)) << name;
  }
}

// d' = integral of h'(u) w(t - u) du: variance integral of h'^2, for the triangle 2^2 * 2 s.
TEST(ErrorProcess, SpeedHasTheVarianceOfTheEnvelopesSlope) {
  const core::Interpolator h = shapes()[1].h;
  const ErrorProcess d = process(h);
  double sum = 0.0;
  for (int i = 0; i < looks; ++i) {
    const double slope = d.at(look_time_s(h, i)).slope;
    sum += slope * slope;
  }
  EXPECT_NEAR(sum / looks, 8.0, 5.0 * 8.0 * std::sqrt(2.0 / looks));
}

TEST(ErrorProcess, SlopeIsTheDifferenceQuotientAndTheDeviationIsContinuous) {
  const core::Interpolator h = shapes()[1].h;
  const ErrorProcess d = process(h);
  const double step_s = support_s(h) / 512.0;
  for (const double cell : {-700.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 12345.0}) {
    const core::Jet start = d.at(cell * step_s);
    const core::Jet middle = d.at((cell + 0.5) * step_s);
    const core::Jet end = d.at((cell + 1.0) * step_s);
    // Sums of 512 terms of about 0.05: 512 * 0.05 * epsilon per value.
    EXPECT_NEAR(start.slope, (end.value - start.value) / step_s, 100.0 * epsilon / step_s);
    EXPECT_NEAR(middle.value, 0.5 * (start.value + end.value), 100.0 * epsilon * (1.0 + std::abs(cell)));
    EXPECT_EQ(middle.slope, start.slope);
  }
}

// A jump of h makes white noise of the speed, and a grid of 512 steps would give it the variance jump^2 512/T.
TEST(ErrorProcess, HasNoSpeedWhereTheEnvelopeJumps) {
  for (const auto& knots :
       {std::vector<core::Knot>{{0.0, 0.8}, {2.0, 0.8}}, std::vector<core::Knot>{{0.0, 0.0}, {2.0, 0.8}},
        std::vector<core::Knot>{{-1.0, -0.02}, {0.0, 1.0}, {1.0, 0.0}}}) {
    const ErrorProcess d = process(envelope(knots));
    for (const double t : {-3.0, 0.0, 0.4, 77.7}) {
      EXPECT_NE(d.at(t).value, 0.0);
      EXPECT_EQ(d.at(t).slope, 0.0);
    }
  }
  EXPECT_NE(process(envelope({{-1.0, 0.005}, {0.0, 1.0}, {1.0, 0.0}})).at(0.4).slope, 0.0);
}

TEST(ErrorProcess, DependsOnTimeAloneNotOnTheOrderOfQuestions) {
  const ErrorProcess d = process(shapes()[2].h);
  std::vector<double> forwards, backwards;
  for (int i = -20; i <= 20; ++i) forwards.push_back(d.at(0.37 * i).value);
  for (int i = 20; i >= -20; --i) backwards.push_back(process(shapes()[2].h).at(0.37 * i).value);
  std::ranges::reverse(backwards);
  EXPECT_EQ(forwards, backwards);
}

TEST(ErrorProcess, IsLinearInTheEnvelope) {
  const ErrorProcess box = process(envelope({{0.0, 1.0}, {2.0, 1.0}}));
  const ErrorProcess ramp = process(envelope({{0.0, -1.0}, {2.0, 3.0}}));
  const ErrorProcess sum = process(envelope({{0.0, 1.0}, {2.0, 7.0}}));  // 2 * box + ... = 2 * 1 + 1.5 * ramp + 0.5
  for (const double t : {-3.3, 0.0, 0.004, 19.0})
    EXPECT_NEAR(sum.at(t).value, 2.5 * box.at(t).value + 1.5 * ramp.at(t).value, 1000.0 * epsilon);
}

TEST(ErrorProcess, ComesLaterWithALaterEnvelope) {
  constexpr double later_s = 2.0 / 512.0 * 100.0;
  const ErrorProcess d = process(envelope({{0.0, 0.5}, {2.0, 1.0}}));
  const ErrorProcess delayed = process(envelope({{later_s, 0.5}, {2.0 + later_s, 1.0}}));
  for (const double t : {-1.0, 0.0, 0.5, 3.0}) EXPECT_NEAR(delayed.at(t + later_s).value, d.at(t).value, 1e4 * epsilon);
}

TEST(ErrorProcess, ASmoothOneHasTheDerivativeOfItsPositionsAndTheVelocityOfItsEnvelope) {
  // h = u exp(-u): the variance is 1/4, that of the velocity the integral of h'^2, 1/4 too.
  core::SampledFunction h{core::Interpolation::cubic, {}};
  for (int i = 0; i <= 240; ++i) h.knots.push_back({0.05 * i, 0.05 * i * std::exp(-0.05 * i)});
  const core::RandomStream stream(7, core::RandomKind::position_envelope, 3);
  const ErrorProcess d(core::Interpolator(h, {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot}), stream, 1,
                       true);
  double position2 = 0.0, velocity2 = 0.0, worst = 0.0;
  constexpr int points = 40000;
  for (int i = 0; i < points; ++i) {
    const double t = 0.31 * i;
    const core::Jet at = d.at(t);
    const double quotient = (d.at(t + 1e-5).value - d.at(t - 1e-5).value) / 2e-5;
    worst = std::max(worst, std::abs(quotient - at.slope));
    position2 += at.value * at.value / points;
    velocity2 += at.slope * at.slope / points;
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_NEAR(position2, 0.25, 0.012);
  EXPECT_NEAR(velocity2, 0.25, 0.012);
}

TEST(ErrorProcess, AxesAndObjectsAreIndependent) {
  const core::Interpolator h = shapes()[0].h;
  const double variance = autocorrelation(h, 0.0);
  const ErrorProcess x = process(h, 5, 0), y = process(h, 5, 1), other = process(h, 6, 0);
  double xy = 0.0, objects = 0.0;
  for (int i = 0; i < looks / 2; ++i) {
    const double t = look_time_s(h, i);
    const double value = x.at(t).value;
    xy += value * y.at(t).value;
    objects += value * other.at(t).value;
  }
  const double bound = 5.0 * variance / std::sqrt(looks / 2);
  EXPECT_NEAR(xy / (looks / 2), 0.0, bound);
  EXPECT_NEAR(objects / (looks / 2), 0.0, bound);
}

}  // namespace error_process_test
}  // namespace sarsim::radar
