#include "workflow/image/polynomial_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sarsim::workflow {

namespace {

// Powers x^i y^j of a point, row by row.
std::vector<double> powers_at(double x, double y, std::size_t degree_x, std::size_t degree_y) {
  std::vector<double> powers;
  double of_x = 1.0;
  for (std::size_t i = 0; i <= degree_x; ++i, of_x *= x) {
    double of_both = of_x;
    for (std::size_t j = 0; j <= degree_y; ++j, of_both *= y) powers.push_back(of_both);
  }
  return powers;
}

// Orthonormal columns by the method of Gram and Schmidt, twice for accuracy; what a column adds to those before it may
// be nothing, and its coefficient is then 0.
class LeastSquares {
 public:
  explicit LeastSquares(std::vector<std::vector<double>> columns) : columns_(std::move(columns)) {
    const std::size_t count = columns_.size();
    upper_.assign(count, std::vector<double>(count, 0.0));
    for (std::size_t k = 0; k < count; ++k) {
      const double before = length(columns_[k]);
      for (int pass = 0; pass < 2; ++pass)
        for (std::size_t m = 0; m < k; ++m) {
          const double part = product(columns_[m], columns_[k]);
          upper_[m][k] += part;
          for (std::size_t n = 0; n < columns_[k].size(); ++n) columns_[k][n] -= part * columns_[m][n];
        }
      const double left = length(columns_[k]);
      constexpr double nothing = 1e-10;
      upper_[k][k] = left > nothing * before ? left : 0.0;
      for (double& number : columns_[k]) number = upper_[k][k] > 0.0 ? number / left : 0.0;
    }
  }

  [[nodiscard]] std::vector<double> solve(const std::vector<double>& values) const {
    const std::size_t count = columns_.size();
    std::vector<double> solution(count, 0.0);
    for (std::size_t k = count; k-- > 0;) {
      if (!(upper_[k][k] > 0.0)) continue;
      double rest = product(columns_[k], values);
      for (std::size_t m = k + 1; m < count; ++m) rest -= upper_[k][m] * solution[m];
      solution[k] = rest / upper_[k][k];
    }
    return solution;
  }

 private:
  static double product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
  }
  static double length(const std::vector<double>& a) { return std::sqrt(product(a, a)); }

  std::vector<std::vector<double>> columns_;
  std::vector<std::vector<double>> upper_;
};

double largest_of(std::span<const SurfacePoint> points, double SurfacePoint::*coordinate) {
  double largest = 0.0;
  for (const SurfacePoint& point : points) largest = std::max(largest, std::abs(point.*coordinate));
  return largest > 0.0 ? largest : 1.0;
}

}  // namespace

std::vector<std::vector<double>> polynomial_surface(std::span<const SurfacePoint> points, std::size_t degree_x,
                                                    std::size_t degree_y) {
  const double scale_x = largest_of(points, &SurfacePoint::x);
  const double scale_y = largest_of(points, &SurfacePoint::y);
  const std::size_t count = (degree_x + 1) * (degree_y + 1);
  std::vector<std::vector<double>> columns(count);
  std::vector<double> values;
  for (const SurfacePoint& point : points) {
    const std::vector<double> powers = powers_at(point.x / scale_x, point.y / scale_y, degree_x, degree_y);
    for (std::size_t k = 0; k < count; ++k) columns[k].push_back(powers[k]);
    values.push_back(point.value);
  }
  const std::vector<double> solution = LeastSquares(std::move(columns)).solve(values);
  std::vector<std::vector<double>> polynomial(degree_x + 1, std::vector<double>(degree_y + 1));
  for (std::size_t i = 0; i <= degree_x; ++i)
    for (std::size_t j = 0; j <= degree_y; ++j)
      polynomial[i][j] = solution[i * (degree_y + 1) + j] /
                         (std::pow(scale_x, static_cast<double>(i)) * std::pow(scale_y, static_cast<double>(j)));
  return polynomial;
}

double surface_value(const std::vector<std::vector<double>>& polynomial, double x, double y) {
  double value = 0.0;
  for (std::size_t i = polynomial.size(); i-- > 0;) {
    double row = 0.0;
    for (std::size_t j = polynomial[i].size(); j-- > 0;) row = row * y + polynomial[i][j];
    value = value * x + row;
  }
  return value;
}

}  // namespace sarsim::workflow
