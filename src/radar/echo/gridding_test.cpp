#include "radar/echo/gridding.hpp"

#include <limits>
#include <numeric>

#include "core/maths/fft.hpp"
#include "radar/echo/echo_test_support.hpp"

namespace sarsim::radar {
namespace spreading_test {

template <class Real>
constexpr double rounding_of = static_cast<double>(std::numeric_limits<Real>::epsilon());

template <class Real>
class Gridding : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Gridding, Precisions);

TYPED_TEST(Gridding, FitReproducesAPolynomialAndLeavesThePaddingZero) {
  const auto f = [](std::size_t lane, double x) {
    return (static_cast<double>(lane) + 1.0) * (1.0 + x * (-2.0 + x * (0.5 + x * (3.0 + x * (x - 1.0)))));
  };
  const auto p = fit_lanes<TypeParam>(5, f, 1e-12).value();
  EXPECT_LE(p.degree, 5u);
  ASSERT_EQ(p.lanes, 64 / sizeof(TypeParam));
  ASSERT_EQ(p.coefficients.size(), p.pieces * (p.degree + 1) * p.lanes);
  for (std::size_t lane = 0; lane < p.lanes; ++lane)
    for (const double x : {0.0, 0.3, 0.77, 1.0})
      EXPECT_NEAR(p.value(lane, x), lane < 5 ? f(lane, x) : 0.0, 20.0 * rounding_of<TypeParam> + 1e-12);
}

TYPED_TEST(Gridding, FitHasTheSecondDerivativeToo) {
  const auto f = [](std::size_t lane, double x) { return std::sin((2.0 + static_cast<double>(lane)) * x); };
  const auto p = fit_lanes<TypeParam>(3, f, 1e-7, {.grain = 4}).value();
  ASSERT_EQ(p.lanes, 4u);
  for (std::size_t lane = 0; lane < p.lanes; ++lane)
    for (double x = 0.0; x <= 1.0; x += 0.0173) {
      const double rate = 2.0 + static_cast<double>(lane);
      EXPECT_NEAR(p.second_derivative(lane, x), lane < 3 ? -rate * rate * f(lane, x) : 0.0, 2e-3 * rate * rate);
    }
}

TYPED_TEST(Gridding, FitTakesTheLowestDegreeThatKeepsTheToleranceOnATableOfItsSize) {
  const auto f = [](std::size_t, double x) { return std::exp(20.0 * (x - 1.0)); };
  std::size_t before = 0;
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto p = fit_lanes<TypeParam>(40, f, tolerance).value();
    EXPECT_LE(p.coefficients.size() * sizeof(TypeParam), sizeof(TypeParam) == 4 ? 8192u : 32768u);
    EXPECT_GE(p.degree, before);
    before = p.degree;
    for (double x = 0.0; x <= 1.0; x += 0.001)
      EXPECT_LT(std::abs(p.value(39, x) - f(0, x)), 1.1 * tolerance + 4.0 * rounding_of<TypeParam>);
    // One degree less would not do: the error of degree n - 1 is near (20/(2 pieces))^n exp(0)/(2^(n-1) n!).
    if (p.degree == 3) continue;
    const auto n = static_cast<double>(p.degree);
    const double pieces = std::exp2(std::floor(std::log2((sizeof(TypeParam) == 4 ? 8192.0 : 32768.0) /
                                                         (n * static_cast<double>(p.lanes) * sizeof(TypeParam)))));
    EXPECT_GT(std::pow(10.0 / pieces, n) / (std::exp2(n - 1.0) * std::tgamma(n + 1.0)), 0.5 * tolerance);
  }
  EXPECT_GT(before, 3u);
}

TYPED_TEST(Gridding, FitOfWhatNoPolynomialReachesIsNothing) {
  EXPECT_FALSE(fit_lanes<TypeParam>(
      1, [](std::size_t, double x) { return x < 0.3 ? 0.0 : 1.0; }, 1e-6));
  EXPECT_FALSE(fit_lanes<TypeParam>(
      1, [](std::size_t, double x) { return std::exp(x); }, 0.0));
}

TYPED_TEST(Gridding, DegreesAndPiecesKeepTheLimits) {
  const auto f = [](std::size_t, double x) { return std::cos(2.6 * x); };
  const auto of = [&](std::size_t lowest_degree, std::size_t pieces) {
    const std::size_t bytes = pieces * (lowest_degree + 1) * 8 * sizeof(TypeParam);
    return fit_lanes<TypeParam>(8, f, 1e-7, {.grain = 8, .lowest_degree = lowest_degree, .bytes = bytes}).value();
  };
  const LanePolynomials<TypeParam> low = of(2, 128);
  EXPECT_EQ(low.degree, 2u);
  EXPECT_EQ(low.pieces, 128u);
  for (double x = 0.0; x <= 1.0; x += 0.0173) EXPECT_NEAR(low.value(3, x), f(3, x), 2e-7);
  EXPECT_EQ(of(3, 64).degree, 3u);
  EXPECT_GT(of(2, 32).degree, 2u);  // too few pieces
}

TYPED_TEST(Gridding, TapsAreTheKernelAtTheCellsAroundAPosition) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-11}) {
    const GriddingKernel kernel(tolerance);
    const auto taps = tap_polynomials<TypeParam>(kernel, tolerance);
    ASSERT_GE(taps.lanes, kernel.width);
    const auto half = 0.5 * static_cast<double>(kernel.width);
    for (std::size_t tap = 0; tap < kernel.width; ++tap)
      for (double x = 0.0; x < 1.0; x += 0.0173) {
        const double expected = kernel.value((x - half + static_cast<double>(tap)) / half);
        // Checked at 33 points: half as much again between them.
        EXPECT_NEAR(taps.value(tap, x), expected, 1.5 * tolerance + 4.0 * rounding_of<TypeParam>);
      }
  }
}

TEST(GriddingKernel, IsAsWideAsItsToleranceAsks) {
  EXPECT_EQ(GriddingKernel(1e-7).width, 8u);
  EXPECT_EQ(GriddingKernel(1.1e-7).width, 8u);
  EXPECT_EQ(GriddingKernel(0.9e-7).width, 9u);
  EXPECT_EQ(GriddingKernel(0.5).width, 4u);
  EXPECT_EQ(GriddingKernel(1e-30).width, 14u);
}

TEST(GriddingKernel, IsTheExponentialOfASemicircle) {
  const GriddingKernel kernel(1e-7);
  EXPECT_EQ(kernel.value(0.0), 1.0);
  EXPECT_NEAR(kernel.value(0.6), std::exp(-0.2 * kernel.beta), 1e-15);
  EXPECT_EQ(kernel.value(-0.6), kernel.value(0.6));
  EXPECT_NEAR(kernel.value(1.0), std::exp(-kernel.beta), 1e-15);
  EXPECT_EQ(kernel.value(1.0001), 0.0);
}

// Trapezium over the kernel in cells, where it ends in a step of exp(-beta) with an upright tangent. The transform
// itself is a midpoint rule of 200 points, with a kink of exp(-beta) at the ends.
TEST(GriddingKernel, TransformIsItsFourierIntegral) {
  for (const double tolerance : {1e-3, 1e-7, 1e-12}) {
    const GriddingKernel kernel(tolerance);
    const double half = 0.5 * static_cast<double>(kernel.width);
    for (const double nu : {0.0, 0.01, 0.1, 0.2, 0.25, 0.3}) {
      constexpr int steps = 200000;
      double sum = 0.0;
      for (int i = 0; i <= steps; ++i) {
        const double g = half * (2.0 * i / steps - 1.0);
        sum += (i == 0 || i == steps ? 0.5 : 1.0) * kernel.value(g / half) * std::cos(2.0 * core::pi * g * nu);
      }
      const double h = 2.0 * half / steps;
      EXPECT_NEAR(kernel.transform(nu), sum * h,
                  kernel.beta * std::exp(-kernel.beta) * 3.0 * std::pow(h, 1.5) +
                      half * std::exp(-kernel.beta) * 2e-5 * 2.0 + 1e-12);
    }
  }
}

TEST(GriddingKernel, TransformsOfARowAreThoseOfItsModes) {
  for (const double tolerance : {1e-3, 1e-7, 1e-12}) {
    const GriddingKernel kernel(tolerance);
    for (const std::size_t count : {1u, 2u, 77u, 3000u}) {
      const std::vector<double> values = kernel.transforms(4 * count, count);
      ASSERT_EQ(values.size(), count);
      for (std::size_t j = 0; j < count; j += 1 + count / 50)
        EXPECT_NEAR(values[j], kernel.transform(static_cast<double>(j) / static_cast<double>(4 * count)),
                    3e-13 * kernel.transform(0.0));
    }
  }
}

template <class Real>
struct Sources {
  std::vector<double> position;
  std::vector<std::complex<Real>> strength;  // terms x positions
};

// Random places, and some next to 0, to the period and on cells.
template <class Real>
Sources<Real> sources(std::size_t count, std::size_t cells, std::size_t terms) {
  std::mt19937_64 random(12);
  const auto period = static_cast<double>(cells);
  std::uniform_real_distribution<double> place(0.0, period), unit(-1.0, 1.0);
  Sources<Real> s;
  s.position = {0.0, 1e-9, 0.3, 0.9999, 1.0, 2.0, period - 1e-9, period - 0.5, period - 1.0, period};
  while (s.position.size() < count) s.position.push_back(place(random));
  for (std::size_t i = 0; i < terms * count; ++i)
    s.strength.push_back({static_cast<Real>(unit(random)), static_cast<Real>(unit(random))});
  return s;
}

template <class Real>
void expect_transform(double tolerance, std::size_t cells, std::size_t terms) {
  const GriddingKernel kernel(tolerance);
  const auto taps = tap_polynomials<Real>(kernel, 0.3 * tolerance);
  const std::size_t count = 60;
  const auto s = sources<Real>(count, cells, terms);
  SpreadGrid<Real> grid;
  grid.resize(cells, terms);
  grid.clear();
  spread<Real>(taps, kernel.width, static_cast<double>(cells), s.position, s.strength, {}, grid);
  const core::BasicFft<Real> fft(cells);
  const auto period = static_cast<double>(cells);
  for (std::size_t r = 0; r < terms; ++r) {
    const std::span<std::complex<Real>> cell = grid.fold(r);
    ASSERT_EQ(cell.size(), cells);
    fft.forward(cell);
    double error = 0.0, total = 0.0;
    const auto half = static_cast<std::ptrdiff_t>(cells / 4);
    for (std::ptrdiff_t j = -half; j < half; ++j) {
      std::complex<double> sum = 0.0;
      for (std::size_t k = 0; k < count; ++k)
        sum += std::complex<double>(s.strength[r * count + k]) *
               std::polar(1.0, -2.0 * core::pi * std::remainder(static_cast<double>(j) * s.position[k] / period, 1.0));
      const auto at = static_cast<std::size_t>(j < 0 ? j + static_cast<std::ptrdiff_t>(cells) : j);
      const std::complex<double> got =
          std::complex<double>(cell[at]) / kernel.transform(static_cast<double>(j) / period);
      error += std::norm(got - sum);
      total += std::norm(sum);
    }
    // The kernel's own error for a grid of twice as many points as modes: its width is chosen to be within the
    // tolerance, the folded tails of all 60 sources may be a few times worse.
    EXPECT_LT(std::sqrt(error / total), 4.0 * tolerance + 10.0 * rounding_of<Real>)
        << cells << " cells, width " << kernel.width << ", term " << r;
  }
}

TEST(Spread, IsTheNonUniformTransformInSinglePrecision) {
  at_every_simd_level([] {
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7})
      for (const std::size_t terms : {1u, 2u, 5u}) expect_transform<float>(tolerance, 216, terms);
  });
}

TEST(Spread, IsTheNonUniformTransformInDoublePrecision) {
  at_every_simd_level([] {
    for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10, 1e-12})
      for (const std::size_t terms : {1u, 3u}) expect_transform<double>(tolerance, 300, terms);
  });
}

TYPED_TEST(Gridding, GridIsACircle) {
  const GriddingKernel kernel(1e-6);
  const auto taps = tap_polynomials<TypeParam>(kernel, 1e-7);
  const std::vector<std::complex<TypeParam>> one{{TypeParam(1), TypeParam(-2)}};
  const auto spread_at = [&](double position, std::size_t cells) {
    SpreadGrid<TypeParam> grid;
    grid.resize(cells, 1);
    grid.clear();
    const std::vector<double> at{position};
    spread<TypeParam>(taps, kernel.width, static_cast<double>(cells), at, one, {}, grid);
    const auto cell = grid.fold(0);
    return std::vector<std::complex<TypeParam>>(cell.begin(), cell.end());
  };
  at_every_simd_level([&] {
    EXPECT_EQ(spread_at(0.0, 50), spread_at(50.0, 50));
    EXPECT_EQ(spread_at(-12.0, 50), spread_at(38.0, 50));
    auto turned = spread_at(25.25, 50);
    std::rotate(turned.begin(), turned.begin() + 25, turned.end());
    EXPECT_EQ(spread_at(0.25, 50), turned);
    // A circle smaller than the kernel: everything arrives, several turns around it.
    const auto small = spread_at(0.25, 4), large = spread_at(0.25, 50);
    const auto sum = [](const auto& v) { return std::accumulate(v.begin(), v.end(), std::complex<TypeParam>()); };
    EXPECT_LT(std::abs(sum(small) - sum(large)), 20.0 * rounding_of<TypeParam>);
  });
}

// 70 echoes, more than a block: each at its place moved by its Doppler, its strength on the second grid in proportion.
TYPED_TEST(Gridding, MovesAndTiltsEchoesByTheirDoppler) {
  const GriddingKernel kernel(1e-6);
  const auto taps = tap_polynomials<TypeParam>(kernel, 1e-7);
  const SpreadMotion given{{}, 2e-7, 3e6, 4e6};
  std::vector<double> doppler, position, moved;
  std::vector<std::complex<TypeParam>> strength, both;
  for (int k = 0; k < 70; ++k) {
    doppler.push_back(2e-7 + 1e-9 * (k % 13 - 6));
    position.push_back(3.7 * k - 100.0);
    moved.push_back(position.back() + given.shift * (doppler.back() - given.middle));
    strength.emplace_back(TypeParam(1 + k % 3), TypeParam(k % 5));
  }
  both = strength;
  for (std::size_t k = 0; k < doppler.size(); ++k)
    both.push_back(static_cast<TypeParam>(given.tilt * (doppler[k] - given.middle)) * strength[k]);
  at_every_simd_level([&] {
    SpreadGrid<TypeParam> expected, got;
    for (auto* const grid : {&expected, &got}) {
      grid->resize(400, 2);
      grid->clear();
    }
    SpreadMotion motion = given;
    motion.doppler = doppler;
    spread<TypeParam>(taps, kernel.width, 400.0, moved, both, {}, expected);
    spread<TypeParam>(taps, kernel.width, 400.0, position, strength, motion, got);
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t i = 0; i < expected.term[r].size(); ++i)
        ASSERT_LT(std::abs(got.term[r][i] - expected.term[r][i]), 50.0 * rounding_of<TypeParam>) << r << ' ' << i;
  });
}

TYPED_TEST(Gridding, ClearedGridIsZero) {
  SpreadGrid<TypeParam> grid;
  grid.resize(20, 2);
  for (auto& term : grid.term) std::ranges::fill(term, std::complex<TypeParam>(1, 1));
  grid.clear();
  for (const std::size_t r : {0u, 1u})
    for (const auto& cell : grid.fold(r)) EXPECT_EQ(cell, (std::complex<TypeParam>()));
}

// Eleven samples, 1 + i + (2 - i) j x at x after the piece's start.
template <class Real>
EdgePiece<Real> test_piece(double start) {
  EdgePiece<Real> piece;
  piece.start = start;
  piece.samples = fit_lanes<Real>(
                      22,
                      [](std::size_t lane, double x) {
                        const auto i = static_cast<double>(lane / 2);
                        return lane % 2 == 0 ? 1.0 + i : (2.0 - i) * (x + 1.0);
                      },
                      1e-12)
                      .value();
  piece.doppler_offset = 3e4;
  piece.doppler_slope = -210.0;
  piece.doppler_bend = 1.5;
  return piece;
}

std::complex<double> piece_sample(std::size_t i, double fraction, double doppler) {
  const double t = static_cast<double>(i) + fraction;
  const double turns = doppler * (3e4 + t * (-210.0 + t * 1.5));
  const auto n = static_cast<double>(i);
  return std::complex(1.0 + n, (2.0 - n) * (fraction + 1.0)) * std::polar(1.0, -2.0 * core::pi * turns);
}

template <class Real>
void expect_edges(double doppler_step) {
  const bool moving = doppler_step > 0.0;
  const EdgePiece<Real> piece = test_piece<Real>(3.5);
  std::vector<double> position{-40.0, -14.7, -9.1, -3.5, 0.0, 4.2, 4.5 - 1e-12, 4.5 + 1e-12, 33.3, 36.4999, 36.5, 90.0};
  std::vector<std::complex<Real>> strength;
  std::vector<double> doppler;
  for (std::size_t k = 0; k < position.size(); ++k) {
    strength.push_back({static_cast<Real>(1.0 + 0.1 * static_cast<double>(k)), Real(-0.4)});
    doppler.push_back(doppler_step * (static_cast<double>(k) - 4.0));
  }
  EdgeRow<Real> row;
  row.resize(40);
  row.clear();
  add_edges<Real>(piece, position, strength, moving ? doppler : std::vector<double>(), row);
  ComplexRow expected(40);
  for (std::size_t k = 0; k < position.size(); ++k) {
    const double first = std::ceil(position[k] + 3.5 - 1e-9);  // a sample that close behind the start is on it
    for (std::size_t i = 0; i < 11; ++i) {
      const double n = first + static_cast<double>(i);
      if (n < 0.0 || n >= 40.0) continue;
      const double fraction = std::max(0.0, first - position[k] - 3.5);
      expected[static_cast<std::size_t>(n)] +=
          std::complex<double>(strength[k]) * piece_sample(i, fraction, doppler[k]);
    }
  }
  for (std::size_t n = 0; n < 40; ++n)  // samples up to 19 from up to 12 echoes of 2
    EXPECT_LT(std::abs(std::complex<double>(row.samples[n + EdgeRow<Real>::padding]) - expected[n]),
              12.0 * 2.0 * 19.0 * 4.0 * rounding_of<Real> + 1e-11)
        << n;
}

TYPED_TEST(Gridding, EdgesOfRestingEchoesAreTheirPolynomials) {
  at_every_simd_level([] { expect_edges<TypeParam>(0.0); });
}

TYPED_TEST(Gridding, EdgesOfMovingEchoesTurnByTheExactDopplerPhase) {
  // Turning by up to 0.7 rad over half a piece, and by as much as a short series may: in single precision, in double.
  for (const double doppler_step : {1e-5, 2.5e-7, 1.2e-8})
    at_every_simd_level([&] { expect_edges<TypeParam>(doppler_step); });
}

}  // namespace spreading_test
}  // namespace sarsim::radar
