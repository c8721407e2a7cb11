#include "process/cfar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sarsim {

namespace {

void expect(bool right, const char* what) {
  if (!right) throw std::invalid_argument(what);
}

std::size_t rank_of(std::size_t cells, double share) {
  const double rank = std::ceil(share * static_cast<double>(cells) - 1e-9);
  return std::clamp<std::size_t>(static_cast<std::size_t>(rank), 1, cells);
}

// Factors for every number of reference cells that may occur.
std::vector<double> factors_up_to(std::size_t cells, const CfarOptions& options) {
  std::vector<double> factors(cells + 1);
  for (std::size_t n = 1; n <= cells; ++n)
    factors[n] = options.kind == CfarOptions::Kind::cell_averaging
                     ? cell_averaging_factor(n, options.false_alarm)
                     : ordered_statistic_factor(n, rank_of(n, options.rank_share), options.false_alarm);
  return factors;
}

struct Range {
  std::size_t begin, end;
};

Range around(std::size_t at, std::size_t reach, std::size_t count) {
  return {at > reach ? at - reach : 0, std::min(count, at + reach + 1)};
}

// The reference cells of one cell.
void gather(std::span<const float> power, std::size_t columns, std::size_t row, std::size_t column,
            const CfarOptions& options, std::vector<float>& cells) {
  cells.clear();
  const std::size_t rows = power.size() / columns;
  const Range all_rows = around(row, options.reference_rows, rows);
  const Range all_columns = around(column, options.reference_columns, columns);
  const Range guard_rows = around(row, options.guard_rows, rows);
  const Range guard_columns = around(column, options.guard_columns, columns);
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
  const auto at = cells.begin() + static_cast<std::ptrdiff_t>(rank_of(cells.size(), options.rank_share)) - 1;
  std::nth_element(cells.begin(), at, cells.end());
  return static_cast<double>(*at);
}

}  // namespace

double cell_averaging_factor(std::size_t cells, double false_alarm) {
  const auto n = static_cast<double>(cells);
  return n * std::expm1(-std::log(false_alarm) / n);
}

double cell_averaging_probability(std::size_t cells, double factor, double snr) {
  const auto n = static_cast<double>(cells);
  return std::exp(-n * std::log1p(factor / (n * (1.0 + snr))));
}

double ordered_statistic_probability(std::size_t cells, std::size_t rank, double factor, double snr) {
  double logarithm = 0.0;
  for (std::size_t i = 0; i < rank; ++i) logarithm -= std::log1p(factor / (1.0 + snr) / static_cast<double>(cells - i));
  return std::exp(logarithm);
}

double ordered_statistic_factor(std::size_t cells, std::size_t rank, double false_alarm) {
  // The probability falls from 1 towards 0: doubling finds an upper end, halving the factor.
  double high = 1.0;
  while (ordered_statistic_probability(cells, rank, high, 0.0) > false_alarm) high *= 2.0;
  double low = 0.0;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (ordered_statistic_probability(cells, rank, middle, 0.0) > false_alarm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<CfarDetection> detect_cfar(std::span<const float> power, std::size_t columns, const CfarOptions& options,
                                       const WorkControl& control) {
  expect(columns > 0 && power.size() % columns == 0, "detection: the map is not a whole number of rows");
  expect(options.false_alarm > 0.0 && options.false_alarm < 1.0,
         "detection: the probability of false alarm is not between 0 and 1");
  expect(options.rank_share > 0.0 && options.rank_share <= 1.0,
         "detection: the rank is not within the reference cells");
  const std::size_t rows = power.size() / columns;
  const std::size_t most =
      (2 * std::min(options.reference_rows, rows) + 1) * (2 * std::min(options.reference_columns, columns) + 1);
  const std::vector<double> factors = factors_up_to(most, options);
  std::vector<std::vector<CfarDetection>> found(rows);
  parallel_ranges(rows, 4, control, [&](std::size_t begin, std::size_t end) {
    std::vector<float> cells;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        gather(power, columns, row, column, options, cells);
        if (cells.empty()) continue;
        const double factor = factors[cells.size()];
        const double noise = noise_of(cells, options);
        const auto here = static_cast<double>(power[row * columns + column]);
        if (here > factor * noise) found[row].push_back({row, column, here, noise, factor * noise});
      }
  });
  std::vector<CfarDetection> all;
  for (const auto& in_row : found) all.insert(all.end(), in_row.begin(), in_row.end());
  return all;
}

}  // namespace sarsim
