#include "signal/search/cfar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "signal/search/cfar_calibration.hpp"

namespace sarsim::signal {
namespace cfar_test {

using Kind = CfarOptions::Kind;
const core::WorkControl one{1, nullptr};

std::vector<float> noise_map(std::size_t cells, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::exponential_distribution<double> power(1.0 / 3.0);
  std::vector<float> map(cells);
  for (float& p : map) p = static_cast<float>(power(random));
  return map;
}

TEST(CfarFactor, IsThatOfTheTables) {
  // Ordered statistic of 32 cells, rank 18, 1e-6: published to the tolerance of its solver.
  EXPECT_NEAR(ordered_statistic_factor(32, 18, 1e-6), 26.1270827, 1e-3);
  EXPECT_NEAR(cell_averaging_factor(1, 0.1), 9.0, 1e-12);
  EXPECT_NEAR(cell_averaging_factor(16, 1e-4), 16.0 * (std::pow(1e-4, -1.0 / 16.0) - 1.0), 1e-12);
  // Without end the mean is the noise itself: -ln P.
  EXPECT_NEAR(cell_averaging_factor(100000000, 1e-6), -std::log(1e-6), 1e-5);
}

TEST(CfarProbability, OfNoiseIsWhatTheFactorWasMadeFor) {
  for (const std::size_t cells : {2u, 8u, 32u})
    for (const double p : {0.1, 1e-4, 1e-9}) {
      EXPECT_NEAR(cell_averaging_probability(cells, cell_averaging_factor(cells, p), 0.0) / p, 1.0, 1e-9);
      const std::size_t rank = 3 * cells / 4;
      EXPECT_NEAR(ordered_statistic_probability(cells, rank, ordered_statistic_factor(cells, rank, p), 0.0) / p, 1.0,
                  1e-9);
    }
}

// Every cell tells: neighbours share reference cells, which makes the count vary less than twice as much as
// independent ones would.
TEST(DetectCfar, HasTheFalseAlarmsItPromises) {
  const std::size_t columns = 1000, rows = 400;
  const std::vector<float> map = noise_map(columns * rows, 11);
  for (const Kind kind : {Kind::cell_averaging, Kind::ordered_statistic})
    for (const std::size_t reference_rows : {0u, 2u}) {
      CfarOptions options;
      options.kind = kind;
      options.false_alarm = 1e-3;
      options.reference_rows = reference_rows;
      options.reference_columns = 8;
      options.guard_columns = 1;
      options.guard_rows = reference_rows / 2;
      const double expected = 1e-3 * static_cast<double>(map.size());
      const auto found = static_cast<double>(detect_cfar(map, columns, options, one).size());
      EXPECT_NEAR(found, expected, 5.0 * std::sqrt(2.0 * expected)) << static_cast<int>(kind) << reference_rows;
    }
}

TEST(CfarFactor, BetweenWholeNumbersOfCellsGoesOnAsTheFormulasDo) {
  CfarOptions options;
  options.false_alarm = 1e-5;
  const double whole = cfar_factor(16, options);
  options.independence = 0.5;
  EXPECT_NEAR(cfar_factor(32, options), whole, 1e-9 * whole);
  options.independence = 0.52;
  EXPECT_LT(cfar_factor(32, options), whole);
  options.kind = Kind::ordered_statistic;
  // The middle of rank 24 of 32 is as far up as that of rank 12.25 of 16.
  options.independence = 0.5;
  EXPECT_LT(cfar_factor(32, options), ordered_statistic_factor(16, 12, 1e-5));
  EXPECT_GT(cfar_factor(32, options), ordered_statistic_factor(16, 13, 1e-5));
  options.independence = 1.0 - 1e-12;
  EXPECT_NEAR(cfar_factor(32, options), ordered_statistic_factor(32, 24, 1e-5), 1e-6);
  // However little a cell is worth, they are worth one.
  options.independence = 1e-6;
  const double few = cfar_factor(32, options);
  options.independence = 1.0 / 32.0;
  EXPECT_EQ(cfar_factor(32, options), few);
}

TEST(DetectCfar, HasNoMoreFalseAlarmsAtTheEdgesOfAMap) {
  constexpr std::size_t columns = 20, rows = 40000;
  const std::vector<float> map = noise_map(columns * rows, 16);
  for (const Kind kind : {Kind::cell_averaging, Kind::ordered_statistic}) {
    CfarOptions options;
    options.kind = kind;
    options.false_alarm = 1e-3;
    options.reference_columns = 8;
    options.guard_columns = 1;
    double found = 0.0;
    for (const CfarDetection& d : detect_cfar(map, columns, options, one)) {
      const bool edge = d.column < 2 || d.column >= columns - 2;
      EXPECT_EQ(d.reference_cells == 7u, edge);
      found += edge ? 1.0 : 0.0;
    }
    // Pairs of neighbours share most of their reference cells.
    EXPECT_NEAR(found, 4e-3 * rows, 5.0 * std::sqrt(2.0 * 4e-3 * rows));
  }
}

using Filter = std::vector<std::complex<double>>;

TEST(PowerCorrelation, IsThatOfFilteredNoise) {
  EXPECT_EQ(power_correlation(Filter{{0.0, 2.0}}), std::vector<double>{1.0});
  EXPECT_EQ(power_correlation({}), std::vector<double>{1.0});
  const auto turned = power_correlation(Filter{1.0, {0.0, 2.0}, 1.0});
  ASSERT_EQ(turned.size(), 3u);
  // (1 2j + 2 1)... of an energy of 6: |2j - 2j|^2 = 0 beside it, 1/36 two apart.
  EXPECT_NEAR(turned[1], 0.0, 1e-15);
  EXPECT_NEAR(turned[2], 1.0 / 36.0, 1e-15);
}

TEST(Independence, OfAMeanIsThatOfItsVariance) {
  const CfarOptions options;
  const std::vector<double> alone{1.0}, pair{1.0, 0.25};
  EXPECT_EQ(independence(alone, alone, options), 1.0);
  EXPECT_NEAR(independence(pair, alone, options), 1.0 / 1.5, 1e-12);
  // Three rows, all the way round.
  EXPECT_NEAR(independence(pair, std::vector<double>{1.0, 0.1, 0.1}, options), 1.0 / (1.5 * 1.2), 1e-12);
}

TEST(Independence, OfAStatisticIsThatOfExceedingIt) {
  CfarOptions options;
  options.kind = Kind::ordered_statistic;
  const std::vector<double> alone{1.0};
  // Pairs of correlated powers, counted where both exceed the quantile.
  std::mt19937_64 random(15);
  std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
  for (const double power : {0.1, 0.5, 0.9}) {
    const double quantile = -std::log(0.25);
    constexpr int pairs = 400000;
    double both = 0.0;
    for (int i = 0; i < pairs; ++i) {
      const std::complex<double> a(normal(random), normal(random)), b(normal(random), normal(random));
      const std::complex<double> c = std::sqrt(power) * a + std::sqrt(1.0 - power) * b;
      both += std::norm(a) > quantile && std::norm(c) > quantile ? 1.0 : 0.0;
    }
    const double correlation = (both / pairs - 0.0625) / 0.1875;
    // The share of pairs has a standard deviation of at most 0.5/632.
    EXPECT_NEAR(1.0 / independence(std::vector<double>{1.0, power}, alone, options), 1.0 + 2.0 * correlation, 0.042)
        << power;
  }
}

TEST(DetectCfar, KeepsItsFalseAlarmsWhereNeighboursAreCorrelated) {
  std::mt19937_64 random(14);
  std::normal_distribution<double> normal;
  const Filter filter{0.5, {0.3, 0.9}, {0.2, 0.9}, {0.0, 0.4}};
  const std::size_t columns = 1000, rows = 1000;
  std::vector<float> map;
  for (std::size_t r = 0; r < rows; ++r) {
    std::vector<std::complex<double>> white(columns + filter.size());
    for (auto& w : white) w = {normal(random), normal(random)};
    for (std::size_t c = 0; c < columns; ++c) {
      std::complex<double> sum;
      for (std::size_t k = 0; k < filter.size(); ++k) sum += filter[k] * white[c + k];
      map.push_back(static_cast<float>(std::norm(sum)));
    }
  }
  for (const Kind kind : {Kind::cell_averaging, Kind::ordered_statistic}) {
    CfarOptions options;
    options.kind = kind;
    options.false_alarm = 1e-3;
    options.guard_columns = 4;
    options.reference_columns = 14;
    const double expected = 1e-3 * static_cast<double>(map.size());
    // Neighbours raise the variance of the count, at most threefold.
    const double spread = 5.0 * std::sqrt(3.0 * expected);
    EXPECT_GT(static_cast<double>(detect_cfar(map, columns, options, one).size()), expected + spread);
    options.independence = independence(power_correlation(filter), std::vector<double>{1.0}, options);
    options.calibration = cfar_calibration({noise_correlation(filter), {1.0}}, options, rows, columns);
    EXPECT_NEAR(static_cast<double>(detect_cfar(map, columns, options, one).size()), expected, spread);
  }
}

TEST(DetectCfar, FindsFluctuatingTargetsAsOftenAsTheFormulasSay) {
  std::mt19937_64 random(12);
  std::exponential_distribution<double> power(1.0);
  constexpr std::size_t columns = 21, rows = 20000;
  for (const double snr : {3.0, 20.0}) {
    std::vector<float> map(columns * rows);
    for (std::size_t i = 0; i < map.size(); ++i)
      map[i] = static_cast<float>(power(random) * (i % columns == 10 ? 1.0 + snr : 1.0));
    for (const Kind kind : {Kind::cell_averaging, Kind::ordered_statistic}) {
      CfarOptions options;
      options.kind = kind;
      options.false_alarm = 1e-3;
      options.reference_columns = 10;
      options.guard_columns = 2;
      const double wanted = kind == Kind::cell_averaging
                                ? cell_averaging_probability(16, cell_averaging_factor(16, 1e-3), snr)
                                : ordered_statistic_probability(16, 12, ordered_statistic_factor(16, 12, 1e-3), snr);
      double hits = 0.0;
      for (const CfarDetection& d : detect_cfar(map, columns, options, {2, nullptr}))
        hits += d.column == 10 ? 1.0 : 0.0;
      EXPECT_NEAR(hits / rows, wanted, 5.0 * std::sqrt(wanted * (1.0 - wanted) / rows)) << snr;
    }
  }
}

TEST(DetectCfar, OfOrderedStatisticsIsNotDeafenedByANeighbour) {
  std::vector<float> map(64, 1.0F);
  map[20] = 40.0F;
  map[28] = 4000.0F;
  CfarOptions options;
  options.false_alarm = 1e-3;
  options.reference_columns = 10;
  const auto columns_of = [&](Kind kind) {
    options.kind = kind;
    std::vector<std::size_t> columns;
    for (const CfarDetection& d : detect_cfar(map, 64, options, one)) columns.push_back(d.column);
    return columns;
  };
  EXPECT_EQ(columns_of(Kind::cell_averaging), (std::vector<std::size_t>{28}));
  EXPECT_EQ(columns_of(Kind::ordered_statistic), (std::vector<std::size_t>{20, 28}));
}

TEST(DetectCfar, TellsWhatItComparedWithGuardsLeftOut) {
  // A map of five by five: the guard of the middle is bright, the rest 2, the corners 6.
  std::vector<float> map(25, 2.0F);
  for (const std::size_t corner : {0u, 4u, 20u, 24u}) map[corner] = 6.0F;
  for (std::size_t r = 1; r < 4; ++r)
    for (std::size_t c = 1; c < 4; ++c) map[5 * r + c] = 500.0F;
  map[12] = 5000.0F;
  CfarOptions options;
  options.false_alarm = 0.01;
  options.reference_rows = options.reference_columns = 2;
  options.guard_rows = options.guard_columns = 1;
  bool seen = false;
  for (const CfarDetection& d : detect_cfar(map, 5, options, one)) {
    if (d.row != 2 || d.column != 2) continue;
    seen = true;
    EXPECT_NEAR(d.noise, (12 * 2.0 + 4 * 6.0) / 16.0, 1e-12);
    EXPECT_NEAR(d.threshold, cell_averaging_factor(16, 0.01) * d.noise, 1e-9);
    EXPECT_EQ(d.power, 5000.0);
  }
  EXPECT_TRUE(seen);
}

TEST(DetectCfar, ComparesWithTheCellOfTheRankAskedFor) {
  const std::vector<float> map{3.0F, 8.0F, 1.0F, 6.0F, 900.0F, 5.0F, 2.0F, 7.0F, 4.0F};
  CfarOptions options;
  options.kind = Kind::ordered_statistic;
  options.false_alarm = 0.01;
  options.reference_columns = 4;
  options.guard_columns = 0;
  for (const auto& [share, rank] :
       {std::pair{0.75, 6.0}, std::pair{0.7, 6.0}, std::pair{0.01, 1.0}, std::pair{1.0, 8.0}}) {
    options.rank_share = share;
    double noise = 0.0;
    for (const CfarDetection& d : detect_cfar(map, 9, options, one))
      if (d.column == 4) noise = d.noise;
    EXPECT_EQ(noise, rank);
  }
}

TEST(DetectCfar, IsTheSameForAnyNumberOfThreads) {
  const std::vector<float> map = noise_map(90 * 100, 13);
  CfarOptions options;
  options.false_alarm = 0.01;
  options.reference_rows = 1;
  const auto expected = detect_cfar(map, 90, options, one);
  ASSERT_GT(expected.size(), 20u);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const auto got = detect_cfar(map, 90, options, {threads, nullptr});
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_EQ(got[i].row, expected[i].row);
      EXPECT_EQ(got[i].column, expected[i].column);
      EXPECT_EQ(got[i].threshold, expected[i].threshold);
    }
  }
}

// Every cell with reference cells is over its threshold.
CfarOptions nearly_always(std::size_t reach, std::size_t guard, std::size_t rows) {
  CfarOptions options;
  options.reference_columns = reach;
  options.guard_columns = guard;
  options.reference_rows = rows;
  options.guard_rows = guard / 2;
  options.false_alarm = 0.999;
  return options;
}

// What the detector finds nothing to compare with, anywhere, has no reference.
TEST(HasReferenceCells, IsWhetherAnyCellOfTheMapHasSome) {
  for (const std::size_t rows : {1U, 3U, 4U})
    for (const std::size_t columns : {1U, 5U, 10U})
      for (const std::size_t reach : {0U, 2U, 4U, 20U})
        for (const std::size_t guard : {0U, 1U, 4U, 30U})
          for (const std::size_t other : {0U, 3U}) {
            const CfarOptions options = nearly_always(reach, guard, other);
            std::vector<float> map(rows * columns, 1.0F);
            EXPECT_EQ(has_reference_cells(options, rows, columns), !detect_cfar(map, columns, options, one).empty())
                << rows << ' ' << columns << ' ' << reach << ' ' << guard << ' ' << other;
          }
}

TEST(ReferenceCells, AreAsManyAsAnyCellOfTheMapHas) {
  for (const std::size_t rows : {1U, 3U, 4U})
    for (const std::size_t columns : {1U, 2U, 5U, 10U})
      for (const std::size_t reach : {1U, 2U, 4U, 20U})
        for (const std::size_t guard : {0U, 1U, 4U})
          for (const std::size_t other : {0U, 1U, 3U}) {
            const CfarOptions options = nearly_always(reach, guard, other);
            std::size_t middle = 0;
            for (const CfarDetection& d : detect_cfar(std::vector<float>(rows * columns, 1.0F), columns, options, one))
              if (d.row == rows / 2 && d.column == columns / 2) middle = d.reference_cells;
            EXPECT_EQ(reference_cells(options, rows, columns), middle)
                << rows << ' ' << columns << ' ' << reach << ' ' << guard << ' ' << other;
          }
}

TEST(DetectCfar, PassesOverCellsWithoutReference) {
  CfarOptions options;
  options.reference_columns = options.guard_columns = 2;
  EXPECT_TRUE(detect_cfar(noise_map(30, 1), 10, options, one).empty());
  EXPECT_TRUE(detect_cfar({}, 10, options, one).empty());
}

TEST(DetectCfar, RefusesWhatMakesNoSense) {
  const std::vector<float> map(30, 1.0F);
  const auto refuses = [&](std::size_t columns, double false_alarm, double share) {
    CfarOptions options;
    options.false_alarm = false_alarm;
    options.rank_share = share;
    EXPECT_THROW((void)detect_cfar(map, columns, options, one), std::invalid_argument);
  };
  refuses(7, 0.1, 0.5);
  refuses(0, 0.1, 0.5);
  refuses(10, 0.0, 0.5);
  refuses(10, 1.0, 0.5);
  refuses(10, 0.1, 0.0);
  refuses(10, 0.1, 1.1);
  CfarOptions options;
  options.independence = 0.0;
  EXPECT_THROW((void)detect_cfar(map, 10, options, one), std::invalid_argument);
}

}  // namespace cfar_test
}  // namespace sarsim::signal
