#include "radar/echo/prolate_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace sarsim::radar {
namespace bin_functions_test {

constexpr int steps = 2000;

// Integral over [-1, 1] by the midpoint rule, whose error is about 1e-6 of the second derivative here.
template <class F>
auto integral(const F& f) {
  auto sum = 0.0 * f(0.0);
  for (int i = 0; i < steps; ++i) sum += f(-1.0 + (2.0 * i + 1.0) / steps) * (2.0 / steps);
  return sum;
}

TEST(ProlateBasis, AreOrthonormal) {
  for (const double c : {0.0, 0.3, 1.4, 3.0})
    for (std::size_t k = 0; k < ProlateBasis::count; ++k)
      for (std::size_t m = 0; m <= k; ++m) {
        const ProlateBasis f(c);
        EXPECT_NEAR(integral([&](double y) { return f.value(k, y) * f.value(m, y); }), k == m ? 1.0 : 0.0, 3e-4)
            << c << ' ' << k << ' ' << m;
      }
}

TEST(ProlateBasis, WithoutPhaseAreLegendresPolynomials) {
  const ProlateBasis f(0.0);
  for (const double y : {-1.0, -0.3, 0.2, 0.9}) {
    EXPECT_NEAR(f.value(0, y), std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(f.value(1, y), std::sqrt(1.5) * y, 1e-14);
    EXPECT_NEAR(std::abs(f.value(2, y)), std::abs(std::sqrt(2.5) * 0.5 * (3.0 * y * y - 1.0)), 1e-13);
    EXPECT_NEAR(std::abs(f.value(7, y)), std::abs(std::sqrt(7.5) * std::legendre(7, y)), 1e-11);
  }
}

TEST(ProlateBasis, SecondDerivativesAreTheirs) {
  const ProlateBasis f(1.4);
  constexpr double h = 1e-4;
  for (std::size_t k = 0; k < ProlateBasis::count; ++k)
    for (const double y : {-0.8, -0.1, 0.4, 0.95})
      EXPECT_NEAR(f.second_derivative(k, y), (f.value(k, y + h) - 2.0 * f.value(k, y) + f.value(k, y - h)) / (h * h),
                  1e-4 * (1.0 + std::abs(f.second_derivative(k, y))));
}

// Root mean square of what is left of exp(j c x y) by the best sums of the first n functions, over both variables.
double left_over(const ProlateBasis& f, double c, std::size_t n) {
  const double energy = integral([&](double x) {
    double kept = 0.0;
    for (std::size_t k = 0; k < n; ++k)
      kept += std::norm(integral([&](double y) { return f.value(k, y) * std::polar(1.0, c * x * y); }));
    return 2.0 - kept;
  });
  return std::sqrt(std::max(0.0, energy) / 4.0);
}

// Slepian's singular values: 5e-9 for eight functions at the phase of a chirp whose band is 0.83 of the sampling rate.
TEST(ProlateBasis, LeaveAboutAsLittleAsAnyFunctionsCan) {
  constexpr double c = 2.0;
  const ProlateBasis f(c);
  for (const std::size_t n : {1u, 2u, 3u, 4u}) {
    const double left = left_over(f, c, n);
    EXPECT_LE(ProlateBasis::needed(c, 1.3 * left), n);
    EXPECT_GT(ProlateBasis::needed(c, 0.7 * left), n);
  }
}

TEST(ProlateBasis, AreNeededInGrowingNumbers) {
  EXPECT_EQ(ProlateBasis::needed(0.0, 1e-7), 1u);
  EXPECT_EQ(ProlateBasis::needed(0.7, 1.3e-7), 6u);
  EXPECT_EQ(ProlateBasis::needed(1.31, 1e-7), 8u);
  EXPECT_EQ(ProlateBasis::needed(1.31, 1e-3), 4u);
  EXPECT_GT(ProlateBasis::needed(3.0, 1e-7), ProlateBasis::count);
}

}  // namespace bin_functions_test
}  // namespace sarsim::radar
