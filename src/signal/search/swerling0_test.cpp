#include "signal/search/swerling0.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/maths/window.hpp"
#include "signal/search/cfar.hpp"

namespace sarsim::signal {
namespace steady_target_test {

// Marcum's Q(a, b) by its definition, the integral of x exp(-(x^2 + a^2)/2) I0(a x) from b on.
double marcum_q(double a, double b) {
  constexpr int steps = 300;
  const double end = std::max(a, b) + 12.0;
  const double step = (end - b) / steps;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double x = b + i * step;
    const double value = x * std::exp(-0.5 * (x * x + a * a)) * core::bessel_i0(a * x);
    sum += value * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
  }
  return sum * step / 3.0;
}

// Mean of Q(sqrt(2 s), sqrt(2 t)) over a threshold t = scale y, y of density y^(n - 1) exp(-y)/(n - 1)!.
double mean_over_gamma(std::size_t n, double scale, double snr) {
  constexpr int steps = 600;
  const auto shape = static_cast<double>(n);
  const double end = shape + 14.0 * std::sqrt(shape) + 30.0;
  double sum = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double y = end * i / steps;
    double logarithm = (shape - 1.0) * std::log(y) - y;
    for (std::size_t k = 2; k < n; ++k) logarithm -= std::log(static_cast<double>(k));
    sum += std::exp(logarithm) * marcum_q(std::sqrt(2.0 * snr), std::sqrt(2.0 * scale * y)) *
           (i == steps   ? 1.0
            : i % 2 == 1 ? 4.0
                         : 2.0);
  }
  return sum * end / steps / 3.0;
}

TEST(SteadyTarget, IsDetectedAsOftenAsTheMeanOfMarcumsQSays) {
  for (const std::size_t cells : {4u, 16u, 32u})
    for (const double snr : {1.0, 8.0, 25.0}) {
      const double factor = cell_averaging_factor(cells, 1e-4);
      EXPECT_NEAR(cell_averaging_steady_probability(cells, factor, snr),
                  mean_over_gamma(cells, factor / static_cast<double>(cells), snr), 1e-6)
          << cells << " " << snr;
    }
}

TEST(SteadyTarget, OfNoSizeGivesFalseAlarms) {
  for (const double p : {0.1, 1e-4, 1e-8}) {
    EXPECT_NEAR(cell_averaging_steady_probability(24, cell_averaging_factor(24, p), 0.0) / p, 1.0, 1e-9);
    EXPECT_NEAR(ordered_statistic_steady_probability(24, 18, ordered_statistic_factor(24, 18, p), 0.0) / p, 1.0, 1e-9);
  }
}

TEST(SteadyTarget, AgainstASingleCellIsTheSmallestOfOne) {
  // One reference cell: the mean and the statistic are the same number.
  for (const double snr : {0.5, 5.0, 50.0})
    EXPECT_NEAR(cell_averaging_steady_probability(1, 9.0, snr), ordered_statistic_steady_probability(1, 1, 9.0, snr),
                1e-14);
}

TEST(SteadyTarget, AgainstEndlessCellsIsMarcumsQ) {
  const double threshold = -std::log(1e-6);
  EXPECT_NEAR(cell_averaging_steady_probability(200000, cell_averaging_factor(200000, 1e-6), 12.0),
              marcum_q(std::sqrt(24.0), std::sqrt(2.0 * threshold)), 1e-4);
}

TEST(SteadyTarget, IsSureToBeFoundWhereItIsStrong) {
  EXPECT_NEAR(cell_averaging_steady_probability(16, cell_averaging_factor(16, 1e-6), 1e4), 1.0, 1e-12);
  EXPECT_EQ(cell_averaging_steady_probability(16, 20.0, 1e9), cell_averaging_steady_probability(16, 20.0, 1e5));
}

// Beyond the ratio at which the sum ends early nothing is missing, and the numbers go on as they came.
TEST(SteadyTarget, IsFoundTheMoreOftenTheStrongerItIs) {
  for (const std::size_t cells : {1u, 2u, 16u, 256u, 4096u}) {
    const std::size_t rank = cfar_rank(cells, 0.75);
    const double mean_factor = cell_averaging_factor(cells, 1e-6);
    const double factor = ordered_statistic_factor(cells, rank, 1e-6);
    double before = 0.0;
    for (double snr = 0.25; snr < 2e5; snr *= 1.25) {
      const double mean = cell_averaging_steady_probability(cells, mean_factor, snr);
      const double found = ordered_statistic_steady_probability(cells, rank, factor, snr);
      EXPECT_GE(found, before - 1e-12) << cells << " " << snr;
      EXPECT_LE(found, 1.0 + 1e-12) << cells << " " << snr;
      EXPECT_GE(mean, found - 1e-12) << cells << " " << snr;  // Finn and Johnson: the mean wastes nothing.
      before = found;
    }
    if (cells > 2) {
      EXPECT_NEAR(before, 1.0, 1e-9) << cells;
    }
  }
}

TEST(SteadyTarget, AgainstMoreOrderedCellsThanFourThousandIsFoundAsOften) {
  const auto found = [](std::size_t cells, double snr) {
    const std::size_t rank = cfar_rank(cells, 0.75);
    return ordered_statistic_steady_probability(cells, rank, ordered_statistic_factor(cells, rank, 1e-6), snr);
  };
  for (const double snr : {8.0, 12.0, 16.0}) EXPECT_NEAR(found(4096, snr), found(32768, snr), 0.003) << snr;
}

TEST(SteadyTarget, IsFoundByTheDetectorsAsOftenAsTheFormulasSay) {
  std::mt19937_64 random(31);
  std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
  constexpr std::size_t columns = 21, rows = 20000;
  for (const double snr : {6.0, 12.0}) {
    std::vector<float> map(columns * rows);
    for (std::size_t i = 0; i < map.size(); ++i) {
      const double in_phase = normal(random) + (i % columns == 10 ? std::sqrt(snr) : 0.0);
      const double quadrature = normal(random);
      map[i] = static_cast<float>(in_phase * in_phase + quadrature * quadrature);
    }
    for (const auto kind : {CfarOptions::Kind::cell_averaging, CfarOptions::Kind::ordered_statistic}) {
      CfarOptions options;
      options.kind = kind;
      options.false_alarm = 1e-3;
      options.reference_columns = 10;
      options.guard_columns = 2;
      const double wanted =
          kind == CfarOptions::Kind::cell_averaging
              ? cell_averaging_steady_probability(16, cell_averaging_factor(16, 1e-3), snr)
              : ordered_statistic_steady_probability(16, 12, ordered_statistic_factor(16, 12, 1e-3), snr);
      double hits = 0.0;
      for (const CfarDetection& d : detect_cfar(map, columns, options, {2, nullptr}))
        hits += d.column == 10 ? 1.0 : 0.0;
      EXPECT_NEAR(hits / rows, wanted, 5.0 * std::sqrt(wanted * (1.0 - wanted) / rows)) << snr;
    }
  }
}

}  // namespace steady_target_test
}  // namespace sarsim::signal
