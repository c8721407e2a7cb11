#include "radar/echo/polynomial_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sarsim::radar {
namespace polynomial_fit_test {

FitTerms at_nodes(const auto& f) {
  FitTerms values;
  for (std::size_t k = 0; k < fit_terms; ++k) values[k] = f(fit_nodes()[k]);
  return values;
}

TEST(ChebyshevSeries, OfAPolynomialGivesItsPowersBack) {
  const std::complex<double> a(0.3, -1.0), b(2.0, 0.25), c(-1.0, 4.0);
  const FitTerms series = chebyshev_series(at_nodes([&](double y) { return a + b * y + c * std::pow(y, 7); }));
  EXPECT_EQ(degree_within(series, 1e-12), 7u);
  const FitTerms powers = powers_of(series, 7);
  for (std::size_t d = 0; d < fit_terms; ++d) {
    const std::complex<double> expected = d == 0 ? a : d == 1 ? b : d == 7 ? c : 0.0;
    // Powers of T_7 reach 112: values of 5, rounded, times that.
    EXPECT_LT(std::abs(powers[d] - expected), 5.0 * 112.0 * 2.2e-16 * 10.0) << d;
  }
}

// A Chebyshev series that is cut is wrong by no more than what was cut off, here by far more than by what aliases.
TEST(ChebyshevSeries, CutToADegreeIsWithinTheTolerance) {
  const auto f = [](double y) { return std::exp(std::complex<double>(0.4, 1.1) * y); };
  const FitTerms series = chebyshev_series(at_nodes(f));
  for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
    const std::size_t degree = degree_within(series, tolerance);
    const FitTerms powers = powers_of(series, degree);
    for (double y = -1.0; y <= 1.0; y += 0.01)
      EXPECT_LT(std::abs(polynomial({powers.data(), degree + 1}, y) - f(y)), tolerance + 1e-11) << degree;
    EXPECT_LT(degree, fit_terms - 1);
  }
}

TEST(ChebyshevSeries, OfAKinkNeedsAllTerms) {
  const FitTerms series = chebyshev_series(at_nodes([](double y) { return std::complex(std::abs(y - 0.1), 0.0); }));
  EXPECT_EQ(degree_within(series, 1e-4), fit_terms - 1);
}

TEST(ChebyshevSeries, OfNumbersThatAreNoneNeedsAllTerms) {
  const FitTerms series = chebyshev_series(at_nodes([](double) { return std::complex(std::nan(""), 0.0); }));
  EXPECT_EQ(degree_within(series, 1e-4), fit_terms - 1);
}

TEST(Polynomial, HasTheLowestPowerFirst) {
  const std::array<std::complex<double>, 3> powers{{{1.0, -1.0}, {10.0, 0.0}, {0.0, 100.0}}};
  EXPECT_EQ(polynomial(powers, 2.0), std::complex<double>(21.0, 399.0));
}

}  // namespace polynomial_fit_test
}  // namespace sarsim::radar
