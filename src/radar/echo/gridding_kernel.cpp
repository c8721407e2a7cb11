#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/echo/gridding.hpp"

namespace sarsim::radar {

namespace {

double polynomial(const std::vector<double>& lowest_first, double y) {
  double sum = 0.0;
  for (std::size_t p = lowest_first.size(); p-- > 0;) sum = sum * y + lowest_first[p];
  return sum;
}

// Fits polynomials of one degree at Chebyshev points of [-1/2, 1/2].
class ChebyshevFit {
 public:
  explicit ChebyshevFit(std::size_t degree) : points_(degree + 1), checks_(degree + 2), series_(points_ * points_) {
    const auto n = static_cast<double>(points_);
    for (std::size_t i = 0; i < points_; ++i) {
      nodes_.push_back(0.5 * std::cos(core::pi * (static_cast<double>(i) + 0.5) / n));
      for (std::size_t m = 0; m < points_; ++m)
        series_[m * points_ + i] =
            (m == 0 ? 1.0 : 2.0) / n * std::cos(core::pi * static_cast<double>(m) * (static_cast<double>(i) + 0.5) / n);
    }
    // The error is largest about halfway between the points that were fitted, and at the ends; these are met from
    // inside, where f is still that of the piece.
    constexpr double inside = 0.4999;
    for (std::size_t i = 0; i < checks_.size(); ++i)
      checks_[i] = inside * std::cos(core::pi * static_cast<double>(i) / n);
  }

  // Monomial coefficients, lowest first, of the polynomial in y that fits f on [from, from + length] at
  // from + length (y + 1/2); nothing where it is off by `tolerance` or more anywhere between.
  [[nodiscard]] std::optional<std::vector<double>> fit(const std::function<double(double)>& f, double from,
                                                       double length, double tolerance) const {
    std::vector<double> values;
    for (const double y : nodes_) values.push_back(f(from + length * (y + 0.5)));
    std::vector<double> fit = monomials(values);
    for (const double y : checks_)
      if (!(std::abs(polynomial(fit, y) - f(from + length * (y + 0.5))) < tolerance)) return std::nullopt;
    return fit;
  }

 private:
  // T_m(2y) as monomials by the recurrence T_m = 4 y T_(m-1) - T_(m-2).
  [[nodiscard]] std::vector<double> monomials(const std::vector<double>& values) const {
    std::vector<double> sum(points_, 0.0), before{1.0}, now{0.0, 2.0};
    for (std::size_t m = 0; m < points_; ++m) {
      double weight = 0.0;
      for (std::size_t i = 0; i < points_; ++i) weight += values[i] * series_[m * points_ + i];
      for (std::size_t p = 0; p < before.size(); ++p) sum[p] += weight * before[p];
      std::vector<double> next(now.size() + 1, 0.0);
      for (std::size_t p = 0; p < now.size(); ++p) next[p + 1] += 4.0 * now[p];
      for (std::size_t p = 0; p < before.size(); ++p) next[p] -= before[p];
      before = std::move(now);
      now = std::move(next);
    }
    return sum;
  }

  std::size_t points_;
  std::vector<double> checks_;
  std::vector<double> series_;  // weight of Chebyshev polynomial m in value i
  std::vector<double> nodes_;
};

// Pieces that a table of `bytes` has room for, a power of two.
std::size_t pieces_in(std::size_t bytes, std::size_t bytes_per_piece) {
  std::size_t pieces = 1;
  while (2 * pieces * bytes_per_piece <= bytes) pieces *= 2;
  return pieces;
}

// The piece that x is on, and where on it.
struct PlaceOnPieces {
  std::size_t piece;
  double y;

  template <class Real>
  PlaceOnPieces(const LanePolynomials<Real>& all, double x) {
    const double scaled = x * static_cast<double>(all.pieces);
    const double whole = std::min(std::floor(scaled), static_cast<double>(all.pieces - 1));
    piece = static_cast<std::size_t>(whole);
    y = scaled - whole - 0.5;
  }

  // Of y^m.
  template <class Real>
  [[nodiscard]] double coefficient(const LanePolynomials<Real>& all, std::size_t lane, std::size_t m) const {
    return static_cast<double>(all.coefficients[(piece * (all.degree + 1) + all.degree - m) * all.lanes + lane]);
  }
};

}  // namespace

template <class Real>
std::optional<LanePolynomials<Real>> fit_lanes(std::size_t count, const std::function<double(std::size_t, double)>& f,
                                               double tolerance, const LaneLimits<Real>& limits) {
  const std::size_t grain = limits.grain;
  CORE_EXPECT(count > 0);
  CORE_EXPECT(grain > 0);
  CORE_EXPECT(tolerance >= 0.0);
  constexpr std::size_t highest = 24;
  LanePolynomials<Real> result;
  result.lanes = (count + grain - 1) / grain * grain;
  const auto fits = [&] {
    const ChebyshevFit chebyshev(result.degree);
    const double length = 1.0 / static_cast<double>(result.pieces);
    result.coefficients.assign(result.pieces * (result.degree + 1) * result.lanes, Real(0));
    for (std::size_t lane = 0; lane < count; ++lane)
      for (std::size_t piece = 0; piece < result.pieces; ++piece) {
        const auto fit =
            chebyshev.fit([&](double x) { return f(lane, x); }, static_cast<double>(piece) * length, length, tolerance);
        if (!fit) return false;
        for (std::size_t p = 0; p <= result.degree; ++p)
          result.coefficients[(piece * (result.degree + 1) + p) * result.lanes + lane] =
              static_cast<Real>((*fit)[result.degree - p]);
      }
    return true;
  };
  for (result.degree = limits.lowest_degree; result.degree <= highest; ++result.degree) {
    result.pieces = pieces_in(limits.bytes, (result.degree + 1) * result.lanes * sizeof(Real));
    if (fits()) return result;
  }
  return std::nullopt;
}

template <class Real>
double LanePolynomials<Real>::value(std::size_t lane, double x) const {
  const PlaceOnPieces place(*this, x);
  double sum = 0.0;
  for (std::size_t m = degree + 1; m-- > 0;) sum = sum * place.y + place.coefficient(*this, lane, m);
  return sum;
}

template <class Real>
double LanePolynomials<Real>::second_derivative(std::size_t lane, double x) const {
  const PlaceOnPieces place(*this, x);
  double sum = 0.0;
  for (std::size_t m = degree; m >= 2; --m)
    sum = sum * place.y + static_cast<double>(m * (m - 1)) * place.coefficient(*this, lane, m);
  return sum * static_cast<double>(pieces * pieces);
}

template struct LanePolynomials<float>;
template struct LanePolynomials<double>;

template std::optional<LanePolynomials<float>> fit_lanes(std::size_t, const std::function<double(std::size_t, double)>&,
                                                         double, const LaneLimits<float>&);
template std::optional<LanePolynomials<double>> fit_lanes(std::size_t,
                                                          const std::function<double(std::size_t, double)>&, double,
                                                          const LaneLimits<double>&);

GriddingKernel::GriddingKernel(double tolerance)
    : width(static_cast<std::size_t>(std::clamp(std::ceil(std::log10(1.0 / tolerance)) + 1.0, 4.0, 14.0))),
      beta(2.30 * static_cast<double>(width)) {
  CORE_EXPECT(tolerance > 0.0);
  // With z = sin(theta) the integrand is smooth but for a kink of exp(-beta) at the ends: the midpoint rule is exact to
  // 1e-4 of that.
  constexpr int points = 100;
  const double half_width = 0.5 * static_cast<double>(width);
  const double step = 0.5 * core::pi / points;
  for (int i = 0; i < points; ++i) {
    const double theta = step * (i + 0.5);
    cells_.push_back(half_width * std::sin(theta));
    weights_.push_back(2.0 * half_width * step * value(std::sin(theta)) * std::cos(theta));
  }
}

double GriddingKernel::value(double z) const {
  const double inside = (1.0 - z) * (1.0 + z);
  return inside < 0.0 ? 0.0 : std::exp(beta * (std::sqrt(inside) - 1.0));
}

double GriddingKernel::transform(double nu) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i) sum += weights_[i] * std::cos(2.0 * core::pi * nu * cells_[i]);
  return sum;
}

std::vector<double> GriddingKernel::transforms(std::size_t cells, std::size_t count) const {
  CORE_EXPECT(cells > 0);
  const double span = static_cast<double>(count) / static_cast<double>(cells);
  const auto fit = fit_lanes<double>(
      1, [&](std::size_t, double x) { return transform(x * span); }, 1e-13 * transform(0.0));
  std::vector<double> values(count);
  for (std::size_t j = 0; j < count; ++j)
    values[j] = fit.value().value(0, static_cast<double>(j) / static_cast<double>(count));
  return values;
}

template <class Real>
LanePolynomials<Real> tap_polynomials(const GriddingKernel& kernel, double tolerance) {
  CORE_EXPECT(tolerance > 0.0);
  const auto tap = [&](std::size_t lane, double x) {
    const double g = x - 0.5 * static_cast<double>(kernel.width) + static_cast<double>(lane);
    return kernel.value(2.0 * g / static_cast<double>(kernel.width));
  };
  return fit_lanes<Real>(kernel.width, tap, tolerance).value();
}

template LanePolynomials<float> tap_polynomials(const GriddingKernel&, double);
template LanePolynomials<double> tap_polynomials(const GriddingKernel&, double);

template <class Real>
void SpreadGrid<Real>::resize(std::size_t cell_count, std::size_t terms) {
  CORE_EXPECT(cell_count > 0);
  CORE_EXPECT(terms > 0);
  cells = cell_count;
  term.resize(terms);
  for (auto& grid : term) grid.resize(cells + 2 * padding);
}

template <class Real>
void SpreadGrid<Real>::clear() {
  for (auto& grid : term) std::ranges::fill(grid, std::complex<Real>());
}

template <class Real>
std::span<std::complex<Real>> SpreadGrid<Real>::fold(std::size_t index) {
  CORE_EXPECT(index < term.size());
  auto& grid = term[index];
  for (std::size_t i = 0; i < padding; ++i) {
    grid[padding + (cells - (padding - i) % cells) % cells] += grid[i];
    grid[padding + i % cells] += grid[padding + cells + i];
  }
  return std::span(grid).subspan(padding, cells);
}

template struct SpreadGrid<float>;
template struct SpreadGrid<double>;

template <class Real>
void EdgeRow<Real>::resize(std::size_t sample_count) {
  count = sample_count;
  samples.assign(count + 2 * padding, {});
}

template <class Real>
void EdgeRow<Real>::clear() {
  std::ranges::fill(samples, std::complex<Real>());
}

template struct EdgeRow<float>;
template struct EdgeRow<double>;

}  // namespace sarsim::radar
