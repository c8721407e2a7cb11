#include "radar/motion/heave_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "radar/motion/error_process.hpp"

namespace sarsim::radar {
namespace plunge_test {

const Gusts air{GustForm::across, 1.5433, 533.4, 120.0};
const HeaveResponse aircraft{0.50986, 0.5, 0.7};

// Its lag is 1/40 of the gusts' time constant.
const HeaveResponse hasty{533.4 / 120.0 / 40.0, 0.5, 0.7};

double largest_of(const core::Interpolator& h) {
  double largest = 0.0;
  for (const core::Knot& knot : h.knots()) largest = std::max(largest, std::abs(knot.y));
  return largest;
}

TEST(HeaveLag, HasTheNumberOfTheTable) { EXPECT_NEAR(heave_lag_s(1500.0, 1.0, 120.0, 5.0), 0.50986, 5e-6); }

// The aircraft's own impulse response: the loop's exp(-zeta w0 t)(cos wd t - zeta w0/wd sin wd t) convolved with
// exp(-t/lag)/lag, in closed form by the complex poles p of the loop: s/((lag s + 1)(s - p)(s - p*)).
double response_of_aircraft(const HeaveResponse& r, double t) {
  const double a = r.hold_damping * r.hold_frequency_rad_per_s;
  const double wd = r.hold_frequency_rad_per_s * std::sqrt(1.0 - r.hold_damping * r.hold_damping);
  const std::complex<double> p(-a, wd);
  const double lag_pole = -1.0 / r.lag_s;
  const auto residue = p / ((r.lag_s * p + 1.0) * (p - std::conj(p)));
  const double lag_residue = lag_pole / r.lag_s / std::norm(lag_pole - p);
  return 2.0 * (residue * std::exp(p * t)).real() + lag_residue * std::exp(lag_pole * t);
}

// Convolution by the midpoint rule on 20 000 panels: smooth on both sides of t.
double convolved(const Gusts& g, const HeaveResponse& r, double t) {
  constexpr int panels = 20'000;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i) {
    const double u = t * (i + 0.5) / panels;
    sum += gust_envelope(g, u) * response_of_aircraft(r, t - u);
  }
  return sum * t / panels;
}

TEST(GustMotion, IsTheConvolutionOfGustAndAircraft) {
  for (const GustForm form : {GustForm::along, GustForm::across})
    for (const HeaveResponse& r : {aircraft, hasty}) {
      Gusts g = air;
      g.form = form;
      const GustMotion motion = gust_motion(g, r);
      EXPECT_EQ(motion.fault, "");
      const double bound = 1e-4 * largest_of(motion.displacement);
      for (const double t : {0.01, 0.2, 1.0, 3.003, 7.7, 20.0, 40.0})
        EXPECT_NEAR(motion.displacement.value(t), convolved(g, r, t), bound) << t;
    }
}

TEST(GustMotion, VelocityIsTheDerivative) {
  const GustMotion motion = gust_motion(air, aircraft);
  const double bound = 1e-4 * largest_of(motion.velocity);
  constexpr double h = 1e-4;
  for (const double t : {0.01, 0.2, 1.0, 3.003, 7.7, 20.0, 40.0}) {
    const double slope = (motion.displacement.value(t + h) - motion.displacement.value(t - h)) / (2.0 * h);
    EXPECT_NEAR(motion.velocity.value(t), slope, 10.0 * bound) << t;
    EXPECT_NEAR(motion.velocity.value(t), motion.displacement.jet(t).slope, bound) << t;
  }
}

TEST(GustMotion, StartsAndEndsAtRest) {
  for (const HeaveResponse& r : {aircraft, HeaveResponse{0.5, 0.25, 1.0}, HeaveResponse{1.0, 1.0, 2.0}}) {
    const GustMotion motion = gust_motion(air, r);
    for (const auto* h : {&motion.displacement, &motion.velocity}) {
      EXPECT_EQ(h->knots().front().y, 0.0);
      EXPECT_LT(std::abs(h->knots().back().y), 1e-3 * largest_of(*h));
    }
  }
}

// Power in the frequency domain: the two-sided integral of |H|^2/(2 pi), by steps of w = tan(u) over the whole axis.
TEST(GustMotion, HasTheVarianceOfItsSpectrum) {
  const GustMotion motion = gust_motion(air, aircraft);
  const double t0 = air.length_m / air.airspeed_mps, w0 = aircraft.hold_frequency_rad_per_s;
  double displacement = 0.0, velocity = 0.0;
  constexpr int panels = 100'000;
  for (int i = 0; i < panels; ++i) {
    const double u = 0.5 * 3.14159265358979 * (i + 0.5) / panels;
    const double w = std::tan(u), x = w * t0;
    const double gust = air.sigma_mps * air.sigma_mps * t0 * (1.0 + 3.0 * x * x) / std::pow(1.0 + x * x, 2);
    const std::complex<double> s(0.0, w);
    const auto transfer = s / ((aircraft.lag_s * s + 1.0) * (s * s + 2.0 * aircraft.hold_damping * w0 * s + w0 * w0));
    const double power = gust * std::norm(transfer) * (1.0 + w * w) * 0.5 / panels;
    displacement += power;
    velocity += power * w * w;
  }
  EXPECT_NEAR(motion.displacement_rms_m, std::sqrt(displacement), 1e-3 * std::sqrt(displacement));
  EXPECT_NEAR(motion.velocity_rms_mps, std::sqrt(velocity), 1e-3 * std::sqrt(velocity));
}

// Both deviations with the same noise: one is the slope of the other, up to the grid of ErrorProcess.
TEST(GustMotion, DrivesDisplacementAndSpeedTogether) {
  const GustMotion motion = gust_motion(air, aircraft);
  const core::RandomStream stream(1, core::RandomKind::position_envelope, 8);
  const ErrorProcess displacement(motion.displacement, stream, 2), velocity(motion.velocity, stream, 2);
  const double step = motion.displacement.knots().back().x / 512.0;
  double squares = 0.0, differences = 0.0, displacements = 0.0;
  constexpr int looks = 2000;
  for (int i = 0; i < looks; ++i) {
    const double t = 700.3 * step * i;
    const core::Jet d = displacement.at(t);
    const double v =
        0.5 * (velocity.at(std::floor(t / step) * step).value + velocity.at((std::floor(t / step) + 1.0) * step).value);
    squares += v * v;
    differences += std::pow(v - d.slope, 2);
    displacements += d.value * d.value;
  }
  EXPECT_LT(differences, 1e-3 * squares);
  // 2000 looks: a relative 5 sqrt(2/2000) of the variance.
  const double rms = motion.displacement_rms_m;
  EXPECT_NEAR(displacements / looks, rms * rms, rms * rms * (5.0 * 0.032 + 0.01));
}

// The variance that ErrorProcess keeps: means over its 512 steps, and straight lines between its grid times, which on
// average are worth 2/3 of the variance and 1/3 of the correlation between neighbours.
double kept_variance(const core::Interpolator& h) {
  constexpr int steps = 512, parts = 16;
  const double step = h.knots().back().x / steps;
  double variance = 0.0, neighbours = 0.0, last = 0.0;
  for (int k = 0; k < steps; ++k) {
    double mean = 0.0;
    for (int i = 0; i < parts; ++i) mean += h.value((k + (i + 0.5) / parts) * step) / parts;
    variance += mean * mean * step;
    neighbours += mean * last * step;
    last = mean;
  }
  return (2.0 * variance + neighbours) / 3.0;
}

TEST(GustMotion, IsKeptByTheStepsOfErrorProcess) {
  for (const HeaveResponse& r : {aircraft, hasty}) {
    const GustMotion motion = gust_motion(air, r);
    const double displacement = std::pow(motion.displacement_rms_m, 2), velocity = std::pow(motion.velocity_rms_mps, 2);
    EXPECT_NEAR(kept_variance(motion.displacement), displacement, 0.002 * displacement);
    EXPECT_NEAR(kept_variance(motion.velocity), velocity, 0.02 * velocity);
  }
}

// Without the loop a slow gust would carry the aircraft away; with it a stiffer loop holds it better.
TEST(GustMotion, IsHeldByTheLoop) {
  const double loose = gust_motion(air, {0.5, 0.2, 0.7}).displacement_rms_m;
  const double stiff = gust_motion(air, {0.5, 1.0, 0.7}).displacement_rms_m;
  EXPECT_GT(loose, 2.0 * stiff);
}

TEST(GustMotion, SaysWhatIsWrong) {
  const auto fault = [](const Gusts& g, const HeaveResponse& r) { return gust_motion(g, r).fault; };
  EXPECT_EQ(fault({GustForm::along, 1.0, 500.0, 0.0}, aircraft), "the airspeed is not positive");
  EXPECT_EQ(fault({GustForm::along, 1.0, 0.0, 100.0}, aircraft), "the scale length of the gusts is not positive");
  EXPECT_EQ(fault({GustForm::along, -1.0, 500.0, 100.0}, aircraft), "the standard deviation of the gusts is negative");
  EXPECT_EQ(fault(air, {0.0, 0.5, 0.7}), "the lag is not positive");
  EXPECT_EQ(fault(air, {0.5, 0.0, 0.7}), "the frequency of the holding loop is not positive");
  EXPECT_EQ(fault(air, {0.5, 0.5, 0.0}), "the damping of the holding loop is not positive");
}

}  // namespace plunge_test
}  // namespace sarsim::radar
