#include "radar/echo/prolate_basis.hpp"

#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

template <std::size_t Terms>
using EvenSeries = std::array<double, Terms>;

// y^-n j_n(c y) in powers of y^2, but for a factor: each term is the last times -c^2/2/(i (2n + 2i + 1)).
template <std::size_t Terms>
EvenSeries<Terms> bessel_series(std::size_t n, double c) {
  EvenSeries<Terms> series{1.0};
  for (std::size_t i = 1; i < Terms; ++i)
    series[i] = series[i - 1] * -0.5 * c * c / static_cast<double>(i * (2 * n + 2 * i + 1));
  return series;
}

// y^shift of an even series.
template <std::size_t Terms>
EvenSeries<Terms> raised(const EvenSeries<Terms>& series, std::size_t shift) {
  EvenSeries<Terms> out{};
  for (std::size_t i = 0; i + shift < Terms; ++i) out[i + shift] = series[i];
  return out;
}

// Integral of the product over [-1, 1]; `odd` is 1 for odd functions.
template <std::size_t Terms>
double product(const EvenSeries<Terms>& a, const EvenSeries<Terms>& b, std::size_t odd) {
  double sum = 0.0;
  for (std::size_t i = 0; i < Terms; ++i)
    for (std::size_t j = 0; j < Terms; ++j) sum += 2.0 * a[i] * b[j] / static_cast<double>(2 * (i + j + odd) + 1);
  return sum;
}

}  // namespace

ProlateBasis::ProlateBasis(double c) {
  CORE_EXPECT(c >= 0.0 && c <= 8.0);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t odd = k % 2;
    auto& f = powers_[k];
    f = raised(bessel_series<terms>(k, c), k / 2);
    // Twice, since rounding leaves something of the others after the first time.
    for (int round = 0; round < 2; ++round)
      for (std::size_t other = odd; other < k; other += 2) {
        const double share = product(f, powers_[other], odd);
        for (std::size_t i = 0; i < terms; ++i) f[i] -= share * powers_[other][i];
      }
    const double length = std::sqrt(product(f, f, odd));
    for (double& power : f) power /= length;
  }
}

double ProlateBasis::value(std::size_t k, double y) const {
  CORE_EXPECT(k < count);
  double sum = 0.0;
  for (std::size_t i = terms; i-- > 0;) sum = sum * y * y + powers_[k][i];
  return k % 2 == 1 ? sum * y : sum;
}

double ProlateBasis::second_derivative(std::size_t k, double y) const {
  CORE_EXPECT(k < count);
  const std::size_t odd = k % 2;
  double sum = 0.0;
  for (std::size_t i = terms; i-- > 1;) {
    const auto power = static_cast<double>(2 * i + odd);
    sum = sum * y * y + power * (power - 1.0) * powers_[k][i];
  }
  return odd == 1 ? sum * y : sum;
}

// The root mean square of what n functions leave is about half the singular value of the next, sqrt(pi) c^n n!^2 /
// ((2n)! Gamma(n + 3/2)), each a fraction of the one before.
std::size_t ProlateBasis::needed(double c, double error) {
  CORE_EXPECT(error > 0.0);
  double left = 1.0;  // n = 0
  std::size_t n = 0;
  for (; n <= count && left > error; ++n) {
    const auto m = static_cast<double>(n);
    left *= c * (m + 1.0) * (m + 1.0) / ((2.0 * m + 1.0) * (2.0 * m + 2.0) * (m + 1.5));
  }
  return n;
}

}  // namespace sarsim::radar
