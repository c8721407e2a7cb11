#include "signal/search/cfar_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/maths/fft.hpp"
#include "core/maths/random.hpp"
#include "core/report/expect.hpp"
#include "signal/search/cfar_factor.hpp"

namespace sarsim::signal {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t max_calibrated_cells = 400;

// One step of Householder's reduction: makes the column below the diagonal of `at` a multiple of its first element and
// turns the rest of the matrix along. Returns |that element|^2.
double reduce_column(std::vector<Complex>& matrix, std::size_t size, std::size_t at) {
  const std::size_t first = at + 1;
  const std::size_t count = size - first;
  std::vector<Complex> v(count), p(count);
  double energy = 0.0;
  for (std::size_t i = 0; i < count; ++i) energy += std::norm(v[i] = matrix[(first + i) * size + at]);
  if (count < 2 || energy == 0.0) return energy;
  const double length = std::sqrt(energy);
  v[0] += std::abs(v[0]) > 0.0 ? length * v[0] / std::abs(v[0]) : Complex(length);
  double square = 0.0;
  for (const Complex& x : v) square += std::norm(x);
  const double beta = 2.0 / square;
  for (std::size_t i = 0; i < count; ++i) {
    Complex sum;
    for (std::size_t k = 0; k < count; ++k) sum += matrix[(first + i) * size + first + k] * v[k];
    p[i] = beta * sum;
  }
  Complex along;
  for (std::size_t i = 0; i < count; ++i) along += std::conj(v[i]) * p[i];
  for (std::size_t i = 0; i < count; ++i) p[i] -= 0.5 * beta * along * v[i];
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < count; ++k)
      matrix[(first + i) * size + first + k] -= v[i] * std::conj(p[k]) + p[i] * std::conj(v[k]);
  return energy;
}

// For the tridiagonal matrix T of the reference and step = s rate: ln det(I + step T), the last pivot of the
// elimination from the end, which is that of the first row, and its derivative with respect to s.
struct Determinant {
  double log_all = 0.0;
  double pivot = 1.0;
  double pivot_slope = 0.0;
};

Determinant determinant_of(const std::vector<double>& diagonal, const std::vector<double>& squares, double s,
                           double rate) {
  const double step = s * rate;
  Determinant d;
  for (std::size_t k = diagonal.size(); k-- > 0;) {
    double pivot = 1.0 + step * diagonal[k];
    double slope = rate * diagonal[k];
    if (k + 1 < diagonal.size()) {
      const double coupling = step * step * squares[k + 1] / d.pivot;
      pivot -= coupling;
      slope -= 2.0 * coupling / s - coupling * d.pivot_slope / d.pivot;
    }
    d.log_all += std::log(pivot);
    d.pivot = pivot;
    d.pivot_slope = slope;
  }
  return d;
}

// Columns of a factor L of a correlation matrix, R = L L^H to within 1/10000 of its trace, in the order of the largest
// pivots. The first cell is never a pivot: its row of L is its regression on the others.
std::vector<std::vector<Complex>> main_columns(const std::vector<Complex>& matrix, std::size_t size) {
  std::vector<std::vector<Complex>> columns;
  std::vector<double> left(size, 1.0);
  left[0] = 0.0;
  double rest = static_cast<double>(size - 1);
  while (columns.size() + 1 < size && rest > 1e-4 * static_cast<double>(size - 1)) {
    const auto at = static_cast<std::size_t>(std::ranges::max_element(left) - left.begin());
    const double root = std::sqrt(left[at]);
    std::vector<Complex> column(size);
    for (std::size_t i = 0; i < size; ++i) {
      Complex sum = matrix[i * size + at];
      for (const auto& before : columns) sum -= before[i] * std::conj(before[at]);
      column[i] = sum / root;
    }
    rest = 0.0;
    for (std::size_t i = 1; i < size; ++i) rest += left[i] = std::max(0.0, left[i] - std::norm(column[i]));
    left[at] = 0.0;
    columns.push_back(std::move(column));
  }
  return columns;
}

// The share of the cell's power that its reference does not predict.
double uncertain_power(const std::vector<std::vector<Complex>>& columns) {
  double uncertain = 1.0;
  for (const auto& column : columns) uncertain -= std::norm(column[0]);
  return std::max(uncertain, 1e-6);
}

// How much more often than they occur such draws are made as give false alarms: by exp(reference P + cell c), P the
// power of all reference cells and c that which they predict of the cell.
struct Tilt {
  double reference = 0.0;
  double cell = 0.0;
};

// By the law of cells whose power exceeds `factor` times the mean of their reference all but always.
Tilt tilt_of(double factor, std::size_t size, double uncertain) {
  constexpr double share = 0.95;  // of the tilt at which the law ceases to be one
  return {-share * factor / static_cast<double>(size - 1), share / (1.0 - share * uncertain)};
}

// The columns of a factor of the tilted correlation matrix; what their determinant changes.
struct TiltedColumns {
  std::vector<std::vector<Complex>> columns;
  double log_determinant = 0.0;
};

// With z of the tilted law, z^H (I - tilt) z = |w|^2 for w = C^H z, C C^H = I - tilt by Cholesky: L z = (L C^-H) w.
TiltedColumns tilted(const std::vector<std::vector<Complex>>& columns, std::size_t size, const Tilt& tilt) {
  const std::size_t count = columns.size();
  TiltedColumns made{columns, 0.0};
  std::vector<std::vector<Complex>> c(count, std::vector<Complex>(count));
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      Complex sum = a == b ? 1.0 : 0.0;
      for (std::size_t i = 0; i < size; ++i)
        sum -= (i == 0 ? tilt.cell : tilt.reference) * std::conj(columns[a][i]) * columns[b][i];
      for (std::size_t k = 0; k < b; ++k) sum -= c[a][k] * std::conj(c[b][k]);
      c[a][b] = a == b ? std::sqrt(std::max(sum.real(), 1e-12)) : sum / c[b][b];
    }
    made.log_determinant += 2.0 * std::log(c[a][a].real());
  }
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t a = 0; a < count; ++a) {
      Complex sum = columns[a][i];
      for (std::size_t k = 0; k < a; ++k) sum -= std::conj(c[a][k]) * made.columns[k][i];
      made.columns[a][i] = sum / c[a][a].real();
    }
  return made;
}

// A draw of the reference: its statistic and the power of the cell that it predicts, both over the power of the
// cell that stays unpredictable, and how often it occurs.
struct Draw {
  double statistic = 0.0;
  double known = 0.0;
  double weight = 1.0;
};

std::vector<Draw> draws_of(const std::vector<std::vector<Complex>>& columns, std::size_t size, std::size_t rank,
                           double factor) {
  const double uncertain = uncertain_power(columns);
  const Tilt tilt = tilt_of(factor, size, uncertain);
  const TiltedColumns drawn = tilted(columns, size, tilt);
  const std::size_t work = std::max<std::size_t>(size * columns.size(), 1);
  std::vector<Draw> draws(std::clamp<std::size_t>((std::size_t{1} << 25) / work, 4000, 65536));
  const core::RandomStream random(1, core::RandomKind::receiver_noise, core::name_key("cfar calibration"));
  std::vector<double> power(size);
  std::vector<Complex> cells(size);
  for (std::size_t d = 0; d < draws.size(); ++d) {
    std::ranges::fill(cells, Complex());
    for (std::size_t c = 0; c < drawn.columns.size(); ++c) {
      const auto [re, im] = random.normals(static_cast<std::int64_t>(d), static_cast<std::int64_t>(c));
      const Complex w = std::sqrt(0.5) * Complex(re, im);
      for (std::size_t i = 0; i < size; ++i) cells[i] += w * drawn.columns[c][i];
    }
    double reference = 0.0;
    for (std::size_t i = 0; i < size; ++i) reference += power[i] = std::norm(cells[i]);
    reference -= power[0];
    const auto at = power.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(power.begin() + 1, at, power.end());
    const double tilted_by = tilt.reference * reference + tilt.cell * power[0];
    draws[d] = {*at / uncertain, power[0] / uncertain, std::exp(-tilted_by - drawn.log_determinant)};
  }
  return draws;
}

// Probability that a complex normal number of variance 1 about one of the power m has a power above t: Marcum's
// function, the chance of J <= K for J and K Poisson of means t and m.
double exceedance(double t, double m) {
  constexpr double largest = 600.0;  // exp(-m) is a number
  if (m > largest) return m > t ? 1.0 : 0.0;
  double chance_of_k = std::exp(-m);
  double chance_of_j = std::exp(-t);
  double up_to_k = chance_of_j;
  double sum = chance_of_k * up_to_k;
  for (int k = 1; k < 2000; ++k) {
    chance_of_k *= m / k;
    chance_of_j *= t / k;
    up_to_k += chance_of_j;
    const double more = chance_of_k * up_to_k;
    sum += more;
    if (k > m && more < 1e-6 * sum) break;
  }
  return sum;
}

struct Place {
  std::ptrdiff_t row, column;
};

// The cell in the middle of a map, followed by its reference cells, as offsets from it.
std::vector<Place> places_of(const CfarOptions& options, std::size_t rows, std::size_t columns) {
  const auto on_map = [](std::ptrdiff_t off, std::size_t count) {
    const auto middle = static_cast<std::ptrdiff_t>(count / 2);
    return middle + off >= 0 && middle + off < static_cast<std::ptrdiff_t>(count);
  };
  const auto row_reach = static_cast<std::ptrdiff_t>(std::min(options.reference_rows, rows));
  const auto column_reach = static_cast<std::ptrdiff_t>(std::min(options.reference_columns, columns));
  std::vector<Place> places{{0, 0}};
  for (std::ptrdiff_t r = -row_reach; r <= row_reach; ++r)
    for (std::ptrdiff_t c = -column_reach; c <= column_reach; ++c) {
      const bool guarded = std::abs(r) <= static_cast<std::ptrdiff_t>(options.guard_rows) &&
                           std::abs(c) <= static_cast<std::ptrdiff_t>(options.guard_columns);
      if (!guarded && on_map(r, rows) && on_map(c, columns)) places.push_back({r, c});
    }
  return places;
}

Complex correlation_of(const NoiseCorrelation& correlation, const Place& a, const Place& b) {
  const std::ptrdiff_t off = a.column - b.column;
  const auto distance = static_cast<std::size_t>(std::abs(off));
  if (distance >= correlation.along_columns.size()) return {};
  const Complex along = correlation.along_columns[distance];
  const auto round = static_cast<std::ptrdiff_t>(correlation.along_rows.size());
  const std::ptrdiff_t turned = ((a.row - b.row) % round + round) % round;
  if (round == 1 && a.row != b.row) return {};
  return (off < 0 ? std::conj(along) : along) * correlation.along_rows[static_cast<std::size_t>(turned)];
}

std::vector<Complex> matrix_of(const NoiseCorrelation& correlation, std::span<const Place> places) {
  std::vector<Complex> matrix;
  matrix.reserve(places.size() * places.size());
  for (const Place& a : places)
    for (const Place& b : places) matrix.push_back(correlation_of(correlation, a, b));
  return matrix;
}

bool is_white(const std::vector<Complex>& matrix, std::size_t size) {
  for (std::size_t i = 0; i < matrix.size(); ++i)
    if (i % (size + 1) != 0 && std::norm(matrix[i]) > 1e-6) return false;
  return true;
}

}  // namespace

CorrelatedMean::CorrelatedMean(std::vector<Complex> matrix, std::size_t size) {
  CORE_EXPECT(size > 1 && matrix.size() == size * size);
  for (std::size_t k = 0; k + 1 < size; ++k) {
    squares_.push_back(reduce_column(matrix, size, k));
    diagonal_.push_back(matrix[(k + 1) * size + k + 1].real());
  }
}

// The eigenvalue: the root s >= 1 of f(s) = 1 - s + s^2 a/N b^2/pivot(s), which is convex and falls there; Newton's
// steps come to it from the left. The product without it is -s f'(s) times the determinant.
double CorrelatedMean::log_false_alarm(double factor) const {
  CORE_EXPECT(factor >= 0.0);
  const double rate = factor / static_cast<double>(diagonal_.size());
  double s = 1.0;
  for (int i = 0;; ++i) {
    const Determinant d = determinant_of(diagonal_, squares_, s, rate);
    const double share = rate * squares_[0] / d.pivot;
    const double value = 1.0 - s + s * s * share;
    const double slope = -1.0 + 2.0 * s * share - s * s * share * d.pivot_slope / d.pivot;
    const double step = slope < 0.0 ? -value / slope : 0.0;
    if (std::abs(step) <= 1e-12 * s || i == 100)
      return std::min(0.0, -d.log_all - std::log(std::max(-s * slope, 1e-300)));
    s += step;
  }
}

double CorrelatedMean::factor(double false_alarm) const {
  CORE_EXPECT(false_alarm > 0.0 && false_alarm < 1.0);
  return factor_where([&](double factor) { return log_false_alarm(factor); }, std::log(false_alarm), 1e-6);
}

double correlated_statistic_factor(const std::vector<Complex>& matrix, std::size_t size, std::size_t rank,
                                   double false_alarm) {
  CORE_EXPECT(size > 1 && matrix.size() == size * size);
  CORE_EXPECT(rank > 0 && rank < size);
  CORE_EXPECT(false_alarm > 0.0 && false_alarm < 1.0);
  double before = ordered_statistic_factor(size - 1, rank, false_alarm);
  const auto columns = main_columns(matrix, size);
  const std::vector<Draw> draws = draws_of(columns, size, rank, before);
  const auto off = [&](double factor) {
    double sum = 0.0;
    for (const Draw& draw : draws) sum += draw.weight * exceedance(factor * draw.statistic, draw.known);
    return std::log(sum / static_cast<double>(draws.size()) / false_alarm);
  };
  // Secants: ln P is smooth and falls.
  double factor = 1.1 * before;
  double off_before = off(before);
  for (int i = 0; i < 20; ++i) {
    const double here = off(factor);
    if (std::abs(here) < 1e-4 || here == off_before) break;
    const double next = factor - here * (factor - before) / (here - off_before);
    before = factor;
    off_before = here;
    factor = std::clamp(next, 0.5 * before, 2.0 * before);
  }
  return factor;
}

double cfar_calibration(const NoiseCorrelation& correlation, const CfarOptions& options, std::size_t rows,
                        std::size_t columns) {
  if (rows == 0 || columns == 0) return 1.0;
  if (reference_cells(options, rows, columns) > max_calibrated_cells) return 1.0;
  const std::vector<Place> places = places_of(options, rows, columns);
  const std::size_t cells = places.size() - 1;
  if (cells == 0) return 1.0;
  std::vector<Complex> matrix = matrix_of(correlation, places);
  if (is_white(matrix, places.size())) return 1.0;
  CfarOptions plain = options;
  plain.calibration = 1.0;
  const double independent = cfar_factor(cells, plain);
  const double factor = options.kind == CfarOptions::Kind::cell_averaging
                            ? CorrelatedMean(std::move(matrix), places.size()).factor(options.false_alarm)
                            : correlated_statistic_factor(matrix, places.size(), cfar_rank(cells, options.rank_share),
                                                          options.false_alarm);
  return factor / independent;
}

}  // namespace sarsim::signal
