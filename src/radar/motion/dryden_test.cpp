#include "radar/motion/dryden.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "radar/motion/error_process.hpp"

namespace sarsim::radar {
namespace dryden_test {

constexpr double foot = 0.3048;

// The gusts of the specification's numbers.
Gusts gusts(GustForm form, double sigma = 1.5) { return {form, sigma, 533.4, 120.0}; }

constexpr GustForm forms[] = {GustForm::along, GustForm::across};

// Integral of h(u) h(u + lag) by Simpson's rule over 40 scale lengths: what is beyond is below exp(-80).
double correlation_of_envelope(const Gusts& g, double lag_s) {
  constexpr int panels = 20'000;
  const double step = 40.0 * g.length_m / g.airspeed_mps / panels;
  double sum = 0.0;
  for (int i = 0; i <= panels; ++i) {
    const double weight = i == 0 || i == panels ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * gust_envelope(g, i * step) * gust_envelope(g, i * step + lag_s);
  }
  return sum * step / 3.0;
}

TEST(TurbulenceAt, HasTheNumbersOfTheTable) {
  const Turbulence low = turbulence_at(200.0 * foot, TurbulenceSeverity::moderate);
  EXPECT_NEAR(low.length_u_m, 221.2196, 5e-5);
  EXPECT_EQ(low.length_v_m, low.length_u_m);
  EXPECT_NEAR(low.length_w_m, 200.0 * foot, 1e-12);
  EXPECT_NEAR(low.sigma_u_mps / low.sigma_w_mps, 1.53671, 5e-6);
  EXPECT_NEAR(low.sigma_w_mps, 1.5433, 5e-5);
  const Turbulence at_1000_ft = turbulence_at(304.8, TurbulenceSeverity::light);
  EXPECT_NEAR(at_1000_ft.length_u_m, 304.8, 1e-9);
  EXPECT_NEAR(at_1000_ft.sigma_u_mps / at_1000_ft.sigma_w_mps, 1.0, 1e-12);
  EXPECT_NEAR(at_1000_ft.sigma_w_mps, 1.5433 / 2.0, 5e-5);
}

TEST(TurbulenceAt, FollowsTheFigureHighUp) {
  const Turbulence t = turbulence_at(7500.0 * foot, TurbulenceSeverity::severe);
  for (const double sigma : {t.sigma_u_mps, t.sigma_v_mps, t.sigma_w_mps}) EXPECT_NEAR(sigma, 23.6 * foot, 1e-12);
  for (const double length : {t.length_u_m, t.length_v_m, t.length_w_m}) EXPECT_NEAR(length, 533.4, 1e-9);
  EXPECT_NEAR(turbulence_at(2000.0 * foot, TurbulenceSeverity::light).sigma_w_mps, (6.9 + 0.5 / 8.0) * foot, 1e-12);
  EXPECT_NEAR(turbulence_at(20'000.0 * foot, TurbulenceSeverity::moderate).sigma_w_mps, 7.3 * foot, 1e-12);
  EXPECT_EQ(turbulence_at(20e3, TurbulenceSeverity::light).sigma_w_mps, 0.0);
  EXPECT_NEAR(turbulence_at(20e3, TurbulenceSeverity::severe).sigma_w_mps, 15.1 * foot, 1e-12);
}

TEST(TurbulenceAt, IsLinearInBetweenAndContinuous) {
  for (const auto severity : {TurbulenceSeverity::light, TurbulenceSeverity::moderate, TurbulenceSeverity::severe}) {
    const Turbulence low = turbulence_at(1000.0 * foot, severity), high = turbulence_at(2000.0 * foot, severity);
    const Turbulence middle = turbulence_at(1500.0 * foot, severity);
    EXPECT_NEAR(middle.sigma_w_mps, 0.5 * (low.sigma_w_mps + high.sigma_w_mps), 1e-12);
    EXPECT_NEAR(middle.length_u_m, 0.5 * (304.8 + 533.4), 1e-9);
    for (const double h_ft : {1000.0, 2000.0, 3750.0, 45'000.0}) {
      const Turbulence below = turbulence_at((h_ft - 1e-6) * foot, severity);
      const Turbulence above = turbulence_at((h_ft + 1e-6) * foot, severity);
      EXPECT_NEAR(below.sigma_u_mps, above.sigma_u_mps, 1e-7);
      EXPECT_NEAR(below.length_w_m, above.length_w_m, 1e-5);
    }
  }
}

TEST(TurbulenceAt, CountsTheGroundAsTenFeet) {
  EXPECT_EQ(turbulence_at(-3.0, TurbulenceSeverity::light).length_w_m, 10.0 * foot);
}

TEST(GustEnvelope, HoldsTheVariance) {
  for (const GustForm form : forms) EXPECT_NEAR(correlation_of_envelope(gusts(form), 0.0), 2.25, 2.25e-10);
}

TEST(GustEnvelope, HasDrydensCorrelation) {
  EXPECT_NEAR(gust_correlation(gusts(GustForm::along), 2.0), 0.637664, 5e-7);
  EXPECT_NEAR(gust_correlation(gusts(GustForm::across), 2.0), 0.494208, 5e-7);
  for (const GustForm form : forms)
    for (const double lag : {0.5, 2.0, 10.0})
      EXPECT_NEAR(correlation_of_envelope(gusts(form), lag), 2.25 * gust_correlation(gusts(form), lag), 1e-9);
}

// |Fourier transform of h|^2 is pi times the one-sided spectra of the specification.
TEST(GustEnvelope, HasDrydensSpectrum) {
  for (const GustForm form : forms) {
    const Gusts g = gusts(form);
    const double t0 = g.length_m / g.airspeed_mps;
    for (const double x : {0.1, 1.0, 5.0}) {  // L w/V
      constexpr int panels = 40'000;
      const double step = 40.0 * t0 / panels;
      double re = 0.0, im = 0.0;
      for (int i = 0; i <= panels; ++i) {
        const double weight = (i == 0 || i == panels ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) * step / 3.0;
        re += weight * gust_envelope(g, i * step) * std::cos(x / t0 * i * step);
        im -= weight * gust_envelope(g, i * step) * std::sin(x / t0 * i * step);
      }
      const double along = 2.25 * 2.0 * t0 / (1.0 + x * x);
      const double across = 2.25 * t0 * (1.0 + 3.0 * x * x) / std::pow(1.0 + x * x, 2);
      EXPECT_NEAR(re * re + im * im, form == GustForm::along ? along : across, 1e-7);
    }
  }
}

TEST(GustFunction, IsTheEnvelope) {
  for (const GustForm form : forms) {
    const core::Interpolator h = gust_function(gusts(form));
    const double first = gust_envelope(gusts(form), 0.0);
    double variance = 0.0;
    const double last = h.knots().back().x;
    constexpr int looks = 10'000;
    for (int i = 0; i < looks; ++i) {
      const double lag = last * (i + 0.5) / looks;
      EXPECT_NEAR(h.value(lag), gust_envelope(gusts(form), lag), 1e-6 * first);
      variance += h.value(lag) * h.value(lag) * last / looks;
    }
    EXPECT_NEAR(variance, 2.25, 2.25 * 3e-6);
  }
}

// 4000 independent looks: a relative sqrt(2/4000) = 0.022 of the variance; the grid takes up to 1 %.
TEST(GustFunction, MakesGustsOfItsVariance) {
  for (const GustForm form : forms) {
    const core::Interpolator h = gust_function(gusts(form));
    const ErrorProcess air(h, core::RandomStream(1, core::RandomKind::position_envelope, 3), 0);
    double sum = 0.0;
    constexpr int looks = 4000;
    for (int i = 0; i < looks; ++i) sum += std::pow(air.at(1.03 * h.knots().back().x * i).value, 2);
    EXPECT_NEAR(sum / looks, 2.25, 2.25 * (5.0 * 0.022 + 0.01));
    EXPECT_EQ(air.at(3.0).slope, 0.0);
  }
}

TEST(GustEnvelope, IsNothingBeforeItsTime) { EXPECT_EQ(gust_envelope(gusts(GustForm::along), -1e-9), 0.0); }

}  // namespace dryden_test
}  // namespace sarsim::radar
