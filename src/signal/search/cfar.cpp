#include "signal/search/cfar.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"
#include "signal/search/cfar_factor.hpp"

namespace sarsim::signal {

namespace {

struct Range {
  std::size_t begin, end;
};

Range around(std::size_t at, std::size_t reach, std::size_t count) {
  return {at > reach ? at - reach : 0, std::min(count, at + reach + 1)};
}

// Numbers of cells in reach and of those in the guard, each pair once, that places along one side of a map meet.
std::set<std::pair<std::size_t, std::size_t>> numbers_along(std::size_t count, std::size_t reach, std::size_t guard) {
  std::set<std::pair<std::size_t, std::size_t>> numbers;
  const auto meet = [&](std::size_t at) {
    const Range all = around(at, reach, count);
    const Range guarded = around(at, std::min(guard, reach), count);
    numbers.insert({all.end - all.begin, guarded.end - guarded.begin});
  };
  for (std::size_t from_end = 0; from_end <= std::min(reach, count - 1); ++from_end) {
    meet(from_end);
    meet(count - 1 - from_end);
  }
  return numbers;
}

// Factors for the numbers of reference cells that occur; the search for one of an ordered statistic takes its time.
std::vector<double> factors_of(std::size_t rows, std::size_t columns, const CfarOptions& options) {
  std::vector<double> factors(1, 0.0);
  const auto along_columns = numbers_along(columns, options.reference_columns, options.guard_columns);
  for (const auto& [all_rows, guard_rows] : numbers_along(rows, options.reference_rows, options.guard_rows))
    for (const auto& [all_columns, guard_columns] : along_columns) {
      const std::size_t cells = all_rows * all_columns - guard_rows * guard_columns;
      if (cells >= factors.size()) factors.resize(cells + 1, 0.0);
      if (cells > 0 && factors[cells] == 0.0) factors[cells] = cfar_factor(cells, options);
    }
  return factors;
}

// The reference cells of one cell.
void gather(std::span<const float> power, std::size_t columns, std::size_t row, std::size_t column,
            const CfarOptions& options, std::vector<float>& cells) {
  cells.clear();
  const std::size_t rows = power.size() / columns;
  const Range all_rows = around(row, options.reference_rows, rows);
  const Range all_columns = around(column, options.reference_columns, columns);
  const Range guard_rows = around(row, std::min(options.guard_rows, options.reference_rows), rows);
  const Range guard_columns = around(column, std::min(options.guard_columns, options.reference_columns), columns);
  for (std::size_t r = all_rows.begin; r < all_rows.end; ++r) {
    const auto line = power.subspan(r * columns, columns);
    const bool guarded = r >= guard_rows.begin && r < guard_rows.end;
    for (std::size_t c = all_columns.begin; c < all_columns.end; ++c) {
      if (guarded && c == guard_columns.begin) c = guard_columns.end;
      if (c < all_columns.end) cells.push_back(line[c]);
    }
  }
}

double noise_of(std::vector<float>& cells, const CfarOptions& options) {
  if (options.kind == CfarOptions::Kind::cell_averaging) {
    double sum = 0.0;
    for (const float p : cells) sum += static_cast<double>(p);
    return sum / static_cast<double>(cells.size());
  }
  const auto at = cells.begin() + static_cast<std::ptrdiff_t>(cfar_rank(cells.size(), options.rank_share)) - 1;
  std::nth_element(cells.begin(), at, cells.end());
  return static_cast<double>(*at);
}

// ln of the gamma function at x >= 1, by Stirling's series beyond 12 (Abramowitz and Stegun 6.1.40), to 1e-12.
// (std::lgamma writes a global variable: not to be called from several threads.)
double log_gamma(double x) {
  double product = 1.0;
  while (x < 12.0) product *= x++;
  const double square = 1.0 / (x * x);
  const double series = (1.0 / 12.0 - square * (1.0 / 360.0 - square * (1.0 / 1260.0 - square / 1680.0))) / x;
  return (x - 0.5) * std::log(x) - x + 0.5 * std::log(2.0 * core::pi) + series - std::log(product);
}

double averaging_factor(double cells, double false_alarm) { return cells * std::expm1(-std::log(false_alarm) / cells); }

// ln of the probability of an ordered statistic, for numbers of cells and ranks between the whole ones:
// Gamma(N + 1) Gamma(N - k + 1 + a)/(Gamma(N - k + 1) Gamma(N + 1 + a)).
double log_statistic_probability(double cells, double rank, double factor) {
  const double rest = cells - rank + 1.0;
  return log_gamma(cells + 1.0) - log_gamma(rest) + log_gamma(rest + factor) - log_gamma(cells + 1.0 + factor);
}

// Correlation of two numbers' exceeding the same value, the numbers being powers of correlated noise.
double exceedance_correlation(double power_correlation, double value) {
  double before = 1.0;
  double polynomial = 1.0 - value;
  double power = power_correlation;
  double sum = 0.0;
  for (int n = 1; n < 100 && power > 1e-9; ++n, power *= power_correlation) {
    sum += power * (polynomial - before) * (polynomial - before);
    const double next = ((2.0 * n + 1.0 - value) * polynomial - n * before) / (n + 1.0);
    before = polynomial;
    polynomial = next;
  }
  return sum * std::exp(-value) / -std::expm1(-value);
}

double independent_factor(std::size_t cells, const CfarOptions& options) {
  const bool mean = options.kind == CfarOptions::Kind::cell_averaging;
  const std::size_t rank = cfar_rank(cells, options.rank_share);
  if (options.independence == 1.0)
    return mean ? cell_averaging_factor(cells, options.false_alarm)
                : ordered_statistic_factor(cells, rank, options.false_alarm);
  const double worth = std::max(1.0, options.independence * static_cast<double>(cells));
  if (mean) return averaging_factor(worth, options.false_alarm);
  // The middle of the cells' rank keeps its place among fewer.
  const double among = 0.5 + worth * (static_cast<double>(rank) - 0.5) / static_cast<double>(cells);
  return factor_where([&](double factor) { return log_statistic_probability(worth, among, factor); },
                      std::log(options.false_alarm), 1e-15);
}

}  // namespace

double cfar_factor(std::size_t cells, const CfarOptions& options) {
  CORE_EXPECT(cells > 0);
  CORE_EXPECT(options.independence > 0.0 && options.independence <= 1.0);
  CORE_EXPECT(options.calibration > 0.0);
  return options.calibration * independent_factor(cells, options);
}

std::vector<std::complex<double>> noise_correlation(std::span<const std::complex<double>> filter) {
  double energy = 0.0;
  for (const std::complex<double>& tap : filter) energy += std::norm(tap);
  if (!(energy > 0.0)) return {1.0};
  const core::Fft fft(core::good_fft_size(2 * filter.size()));
  std::vector<std::complex<double>> values(filter.begin(), filter.end());
  values.resize(fft.size());
  fft.forward(values);
  for (std::complex<double>& value : values) value = std::norm(value);
  fft.inverse(values);
  values.resize(filter.size());
  for (std::complex<double>& value : values) value /= energy * static_cast<double>(fft.size());
  values[0] = 1.0;
  return values;
}

std::vector<double> power_correlation(std::span<const std::complex<double>> filter) {
  std::vector<double> powers;
  for (const std::complex<double>& rho : noise_correlation(filter)) powers.push_back(std::norm(rho));
  return powers;
}

double independence(std::span<const double> along_columns, std::span<const double> along_rows,
                    const CfarOptions& options) {
  CORE_EXPECT(!along_columns.empty());
  CORE_EXPECT(!along_rows.empty());
  constexpr double negligible = 1e-4;
  const double quantile = -std::log1p(-std::min(options.rank_share, 0.99));
  const bool mean = options.kind == CfarOptions::Kind::cell_averaging;
  double sum = 0.0;
  for (std::size_t m = 0; m < along_columns.size(); ++m)
    for (const double row : along_rows) {
      const double power = along_columns[m] * row;
      if (power < negligible) continue;
      const double correlation = mean || power > 0.9999 ? power : exceedance_correlation(power, quantile);
      sum += m == 0 ? correlation : 2.0 * correlation;
    }
  return std::min(1.0, 1.0 / sum);
}

std::size_t cfar_rank(std::size_t cells, double share) {
  CORE_EXPECT(share > 0.0 && share <= 1.0);
  const double rank = std::ceil(share * static_cast<double>(cells) - 1e-9);
  return std::clamp<std::size_t>(static_cast<std::size_t>(rank), 1, cells);
}

std::size_t reference_cells(const CfarOptions& options, std::size_t rows, std::size_t columns) {
  if (rows == 0 || columns == 0) return 0;
  const auto within = [](std::size_t reach, std::size_t count) {
    const std::size_t middle = count / 2;
    return std::min(reach, middle) + 1 + std::min(reach, count - 1 - middle);
  };
  const std::size_t guard_rows = std::min(options.guard_rows, options.reference_rows);
  const std::size_t guard_columns = std::min(options.guard_columns, options.reference_columns);
  return within(options.reference_rows, rows) * within(options.reference_columns, columns) -
         within(guard_rows, rows) * within(guard_columns, columns);
}

bool has_reference_cells(const CfarOptions& options, std::size_t rows, std::size_t columns) {
  const auto covered = [](std::size_t reach, std::size_t guard, std::size_t count) {
    return std::min(guard, reach) + 1 >= std::min(reach + 1, count);
  };
  return !covered(options.reference_rows, options.guard_rows, rows) ||
         !covered(options.reference_columns, options.guard_columns, columns);
}

double noise_power(const CfarDetection& detection, const CfarOptions& options) {
  if (options.kind == CfarOptions::Kind::cell_averaging) return detection.noise;
  const std::size_t cells = detection.reference_cells;
  double expected = 0.0;
  for (std::size_t i = 0; i < cfar_rank(cells, options.rank_share); ++i)
    expected += 1.0 / static_cast<double>(cells - i);
  return detection.noise / expected;
}

double cell_averaging_factor(std::size_t cells, double false_alarm) {
  CORE_EXPECT(cells > 0);
  CORE_EXPECT(false_alarm > 0.0 && false_alarm <= 1.0);
  return averaging_factor(static_cast<double>(cells), false_alarm);
}

double cell_averaging_probability(std::size_t cells, double factor, double snr) {
  CORE_EXPECT(cells > 0);
  CORE_EXPECT(factor >= 0.0);
  CORE_EXPECT(snr >= 0.0);
  const auto n = static_cast<double>(cells);
  return std::exp(-n * std::log1p(factor / (n * (1.0 + snr))));
}

double ordered_statistic_probability(std::size_t cells, std::size_t rank, double factor, double snr) {
  CORE_EXPECT(rank >= 1 && rank <= cells);
  CORE_EXPECT(factor >= 0.0);
  CORE_EXPECT(snr >= 0.0);
  double logarithm = 0.0;
  for (std::size_t i = 0; i < rank; ++i) logarithm -= std::log1p(factor / (1.0 + snr) / static_cast<double>(cells - i));
  return std::exp(logarithm);
}

double ordered_statistic_factor(std::size_t cells, std::size_t rank, double false_alarm) {
  CORE_EXPECT(rank >= 1 && rank <= cells);
  CORE_EXPECT(false_alarm > 0.0 && false_alarm <= 1.0);
  return factor_where([&](double factor) { return std::log(ordered_statistic_probability(cells, rank, factor, 0.0)); },
                      std::log(false_alarm), 1e-15);
}

std::vector<CfarDetection> detect_cfar(std::span<const float> power, std::size_t columns, const CfarOptions& options,
                                       const core::WorkControl& control) {
  core::expect(columns > 0 && power.size() % columns == 0, "detection: the map is not a whole number of rows");
  core::expect(options.false_alarm > 0.0 && options.false_alarm < 1.0,
               "detection: the probability of false alarm is not between 0 and 1");
  core::expect(options.rank_share > 0.0 && options.rank_share <= 1.0,
               "detection: the rank is not within the reference cells");
  core::expect(options.independence > 0.0 && options.independence <= 1.0,
               "detection: a reference cell is worth more than one, or nothing");
  const std::size_t rows = power.size() / columns;
  if (rows == 0) return {};
  const std::vector<double> factors = factors_of(rows, columns, options);
  std::vector<std::vector<CfarDetection>> found(rows);
  core::parallel_ranges(rows, 4, control, [&](std::size_t begin, std::size_t end) {
    std::vector<float> cells;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        gather(power, columns, row, column, options, cells);
        if (cells.empty()) continue;
        const double factor = factors[cells.size()];
        const double noise = noise_of(cells, options);
        const auto here = static_cast<double>(power[row * columns + column]);
        if (here > factor * noise) found[row].push_back({row, column, here, noise, factor * noise, cells.size()});
      }
  });
  std::vector<CfarDetection> all;
  for (const auto& in_row : found) all.insert(all.end(), in_row.begin(), in_row.end());
  return all;
}

}  // namespace sarsim::signal
