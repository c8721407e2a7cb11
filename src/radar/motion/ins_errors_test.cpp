#include "radar/motion/ins_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/maths/constants.hpp"
#include "radar/motion/error_process.hpp"
#include "radar/motion/level_turn.hpp"

namespace sarsim::radar {
namespace ins_errors_test {

constexpr double deg = core::rad_per_deg;
constexpr double micro_g = 1e-6 * standard_gravity_mps2;
constexpr double deg_per_hour = deg / 3600.0;

TEST(InsErrors, HaveTheNumbersOfTheTable) {
  EXPECT_NEAR(position_error({50.0 * micro_g, 0.0, 0.0}, InsModel::polynomial, 60.0).value, 0.883, 5e-4);
  EXPECT_NEAR(position_error({0.0, 0.05 * deg_per_hour, 0.0}, InsModel::polynomial, 60.0).value, 0.0856, 5e-5);
  EXPECT_NEAR(angle_walk_rad(0.003 * deg / 60.0, 60.0) / deg, 3.87e-4, 5e-7);
  EXPECT_NEAR(2.0 * core::pi / schuler_frequency_rad_per_s() / 60.0, 84.406, 5e-4);
}

TEST(InsErrors, GivePairedEchoesTheirLevel) {
  EXPECT_NEAR(paired_echo_db(1e-4, 0.031), -33.9, 0.05);
  EXPECT_NEAR(paired_echo_db(5e-4, 0.031), -19.9, 0.05);
}

TEST(PositionError, SwingsAsAPolynomialInTheFirstMinutes) {
  const InsBias bias{50.0 * micro_g, 0.05 * deg_per_hour, 0.0};
  // (w t)^2/12 of the first and (w t)^2/20 of the second error.
  for (const double t : {1.0, 10.0, 60.0, 200.0}) {
    const double share = std::pow(schuler_frequency_rad_per_s() * t, 2) / 12.0;
    const double grown = position_error(bias, InsModel::polynomial, t).value;
    EXPECT_NEAR(position_error(bias, InsModel::schuler, t).value, grown, grown * share);
  }
}

TEST(PositionError, OfAnAccelerometerIsBoundedAndThatOfAGyroDrifts) {
  const double w = schuler_frequency_rad_per_s(), period = 2.0 * core::pi / w;
  const InsBias level{50.0 * micro_g, 0.0, 0.0};
  EXPECT_NEAR(position_error(level, InsModel::schuler, 0.5 * period).value, 2.0 * 50.0 * micro_g / (w * w), 1e-9);
  EXPECT_NEAR(position_error(level, InsModel::schuler, period).value, 0.0, 1e-9);
  // g/w^2 = R: the drift is that of an angle at the Earth's centre.
  const InsBias drift{0.0, 0.01 * deg_per_hour, 0.0};
  EXPECT_NEAR(position_error(drift, InsModel::schuler, period).value, schuler_radius_m * 0.01 * deg_per_hour * period,
              1e-6);
}

TEST(PositionError, DerivativesAreQuotients) {
  const InsBias bias{50.0 * micro_g, 0.05 * deg_per_hour, 30.0};
  constexpr double h = 0.01;
  for (const InsModel model : {InsModel::polynomial, InsModel::schuler})
    for (const double t : {31.0, 100.0, 3000.0}) {
      const core::Jet before = position_error(bias, model, t - h), now = position_error(bias, model, t),
                      then = position_error(bias, model, t + h);
      EXPECT_NEAR((then.value - before.value) / (2.0 * h), now.slope, 1e-8 * (1.0 + now.value));
      EXPECT_NEAR((then.slope - before.slope) / (2.0 * h), now.curvature, 1e-8);
    }
  EXPECT_EQ(position_error(bias, InsModel::schuler, 30.0).value, 0.0);
  EXPECT_EQ(position_error(bias, InsModel::polynomial, -5.0).curvature, 0.0);
}

TEST(GaussMarkovFunction, HoldsTheVarianceAndItsCorrelation) {
  const core::Interpolator h = gauss_markov_function(0.3, 120.0);
  const double last = h.knots().back().x;
  double variance = 0.0, correlation = 0.0;
  constexpr int looks = 20'000;
  for (int i = 0; i < looks; ++i) {
    const double u = last * (i + 0.5) / looks;
    EXPECT_NEAR(h.value(u), 0.3 * std::sqrt(2.0 / 120.0) * std::exp(-u / 120.0), 1e-6 * h.value(0.0));
    variance += h.value(u) * h.value(u) * last / looks;
    if (u + 60.0 < last) correlation += h.value(u) * h.value(u + 60.0) * last / looks;
  }
  EXPECT_NEAR(variance, 0.09, 0.09 * 1e-6);
  EXPECT_NEAR(correlation / 0.09, std::exp(-0.5), 1e-6);
}

// Differences over a lag: variance density^2 lag; 3000 looks are right to 5 sqrt(2/3000) of it, and the grid to 1 %.
TEST(RandomWalkFunction, WalksLikeASensorDoes) {
  const double density = 0.003 * deg / 60.0;
  const core::Interpolator h = random_walk_function(density, 100.0);
  const ErrorProcess angle(h, core::RandomStream(1, core::RandomKind::rotation_envelope, 4), 0);
  constexpr int looks = 3000;
  for (const double lag : {10.0, 60.0}) {
    double sum = 0.0;
    for (int i = 0; i < looks; ++i) sum += std::pow(angle.at(207.7 * i + lag).value - angle.at(207.7 * i).value, 2);
    const double expected = std::pow(angle_walk_rad(density, lag), 2);
    EXPECT_NEAR(sum / looks, expected, expected * (5.0 * 0.026 + 0.01)) << lag;
  }
}

// The integrals of a walk over n steps of white noise: sums of k and k^2/2 squared become T^3/3 and T^5/20.
TEST(RandomWalks, HaveTheVarianceOfIntegratedNoise) {
  constexpr int steps = 10'000;
  const double dt = 60.0 / steps;
  double speed = 0.0, position = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double age = 60.0 - (i + 0.5) * dt;
    speed += age * age * dt;
    position += std::pow(0.5 * age * age, 2) * dt;
  }
  EXPECT_NEAR(velocity_walk_position_m(2e-3, 60.0), 2e-3 * std::sqrt(speed), 1e-9);
  EXPECT_NEAR(tilt_walk_position_m(1e-6, 60.0), standard_gravity_mps2 * 1e-6 * std::sqrt(position), 1e-9);
}

}  // namespace ins_errors_test
}  // namespace sarsim::radar
