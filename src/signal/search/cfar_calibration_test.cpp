#include "signal/search/cfar_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "core/maths/constants.hpp"

namespace sarsim::signal {
namespace cfar_calibration_test {

using Complex = std::complex<double>;
using Kind = CfarOptions::Kind;

// The matched filter of a chirp of 32 cycles of bandwidth times duration at so many samples for each.
NoiseCorrelation chirp_noise(double samples_per_cell) {
  constexpr double product = 32.0;
  const int taps = static_cast<int>(std::lround(product * samples_per_cell));
  std::vector<Complex> filter;
  for (int i = 0; i < taps; ++i) {
    const double u = (i + 0.5) / taps - 0.5;
    filter.push_back(std::polar(1.0, core::pi * product * u * u));
  }
  return {noise_correlation(filter), {1.0}};
}

CfarOptions options_of(Kind kind, double false_alarm) {
  CfarOptions options;
  options.kind = kind;
  options.false_alarm = false_alarm;
  return options;
}

// The cells within 16 of a cell but not within two, in one row, 28; the cell itself stands last.
std::vector<int> usual_places() {
  std::vector<int> places;
  for (int i = -16; i <= 16; ++i)
    if (std::abs(i) > 2) places.push_back(i);
  places.push_back(0);
  return places;
}

// Probability that a complex normal number of mean |m| and variance v exceeds a power: a Poisson sum.
double exceeds(double mean_power, double variance, double power) {
  const double s = mean_power / variance, t = power / variance;
  double poisson = std::exp(-s), term = std::exp(-t), tail = term, sum = poisson * tail;
  for (int k = 1; k < 400 && (k < s || poisson > 1e-6 * sum); ++k) {
    poisson *= s / k;
    term *= t / k;
    tail += term;
    sum += poisson * tail;
  }
  return sum;
}

// False alarms by drawing the reference cells and adding up how likely the cell exceeds the threshold they make: the
// cell, given them, is a normal number, whose mean and variance the last row of Cholesky's factor says.
class Drawn {
 public:
  Drawn(const NoiseCorrelation& noise, int draws) {
    const std::vector<int> places = usual_places();
    const std::size_t size = places.size();
    std::vector<std::vector<Complex>> factor(size, std::vector<Complex>(size));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k <= i; ++k) {
        Complex sum = rho(noise, places[i] - places[k]);
        for (std::size_t j = 0; j < k; ++j) sum -= factor[i][j] * std::conj(factor[k][j]);
        if (i == k)
          factor[i][i] = std::sqrt(std::max(1e-9, sum.real()));
        else
          factor[i][k] = sum / factor[k][k];
      }
    variance_ = std::norm(factor.back().back());
    std::mt19937_64 random(77);
    std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
    // In plain numbers, since tests are compiled without optimisation: real and imaginary parts in turn.
    std::vector<double> rows;
    for (const auto& row : factor)
      for (const Complex& value : row) rows.insert(rows.end(), {value.real(), value.imag()});
    std::vector<double> white(2 * (size - 1));
    for (int d = 0; d < draws; ++d) {
      for (double& w : white) w = normal(random);
      std::vector<double> power(size);
      for (std::size_t i = 0; i < size; ++i) {
        double real = 0.0, imaginary = 0.0;
        const double* row = &rows[2 * size * i];
        const double* w = white.data();
        for (std::size_t k = std::min(i + 1, size - 1); k > 0; --k, row += 2, w += 2) {
          real += row[0] * w[0] - row[1] * w[1];
          imaginary += row[0] * w[1] + row[1] * w[0];
        }
        power[i] = real * real + imaginary * imaginary;
      }
      mean_power_.push_back(power.back());
      power.pop_back();
      double mean = 0.0;
      for (const double p : power) mean += p / static_cast<double>(power.size());
      means_.push_back(mean);
      std::ranges::nth_element(power, power.begin() + 20);
      statistics_.push_back(power[20]);
    }
  }

  // Their probability and its standard deviation.
  [[nodiscard]] std::pair<double, double> false_alarms(Kind kind, double factor) const {
    const std::vector<double>& noise = kind == Kind::cell_averaging ? means_ : statistics_;
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < noise.size(); ++i) {
      const double p = exceeds(mean_power_[i], variance_, factor * noise[i]);
      sum += p;
      squares += p * p;
    }
    const auto draws = static_cast<double>(noise.size());
    return {sum / draws, std::sqrt(squares) / draws};
  }

 private:
  static Complex rho(const NoiseCorrelation& noise, int off) {
    const auto at = static_cast<std::size_t>(std::abs(off));
    if (at >= noise.along_columns.size()) return {};
    return off < 0 ? std::conj(noise.along_columns[at]) : noise.along_columns[at];
  }

  double variance_ = 1.0;
  std::vector<double> mean_power_, means_, statistics_;
};

// The factor a detector takes: that of as many independent cells as its reference is worth, calibrated.
double factor_taken(const NoiseCorrelation& noise, CfarOptions options) {
  std::vector<double> powers;
  for (const Complex& rho : noise.along_columns) powers.push_back(std::norm(rho));
  options.independence = independence(powers, std::vector<double>{1.0}, options);
  options.calibration = cfar_calibration(noise, options, 1, 400);
  return cfar_factor(28, options);
}

TEST(CfarCalibration, KeepsFalseAlarmsWithinFivePercentHoweverFinelyItIsSampled) {
  for (const double samples_per_cell : {1.0, 1.25, 2.0, 4.0}) {
    const NoiseCorrelation noise = chirp_noise(samples_per_cell);
    const Drawn drawn(noise, samples_per_cell < 3.0 ? 60'000 : 300'000);
    for (const Kind kind : {Kind::cell_averaging, Kind::ordered_statistic})
      for (const double asked : {1e-3, 1e-4}) {
        const auto [found, sigma] = drawn.false_alarms(kind, factor_taken(noise, options_of(kind, asked)));
        EXPECT_NEAR(found / asked, 1.0, 0.05 + 2.0 * sigma / asked)
            << samples_per_cell << ' ' << static_cast<int>(kind) << ' ' << asked;
        // Enough draws to tell; at four samples few of them make most of the false alarms.
        EXPECT_LT(sigma / asked, samples_per_cell < 3.0 ? 0.05 : 0.12);
      }
  }
}

// Four samples to a cell: few draws of the reference make most of the false alarms. The factors are those of a sum over
// 120 000 draws of another program, made where false alarms are and weighted by their density (standard deviations of
// P: 0.8, 1.2 and 2.2 %). P falls by 5 to 7 % where a factor grows by 1 %.
TEST(CfarCalibration, KnowsTheFactorOfOrderedStatisticsOfFineSamples) {
  const NoiseCorrelation noise = chirp_noise(4.0);
  for (const auto& [asked, factor] : {std::pair{1e-3, 7.70}, {1e-4, 11.75}, {1e-5, 16.90}})
    EXPECT_NEAR(factor_taken(noise, options_of(Kind::ordered_statistic, asked)) / factor, 1.0, 0.008) << asked;
}

// Two reference cells of correlation r and a cell without: eigenvalues 1 + r and 1 - r.
TEST(CorrelatedMean, IsTheProductOverTheEigenvalues) {
  const Complex r = std::polar(0.6, 1.1);
  const CorrelatedMean mean({1.0, 0.0, 0.0, 0.0, 1.0, r, 0.0, std::conj(r), 1.0}, 3);
  for (const double a : {0.5, 3.0, 40.0})
    EXPECT_NEAR(mean.log_false_alarm(a), -std::log((1.0 + 0.8 * a) * (1.0 + 0.2 * a)), 1e-12);
  EXPECT_NEAR(mean.log_false_alarm(mean.factor(1e-4)), std::log(1e-4), 1e-5);
}

// One reference cell of correlation r: |z|^2 > a |y|^2 with the positive eigenvalue of {{1, -a r}, {r*, -a}}.
TEST(CorrelatedMean, KnowsWhatTheCellHasInCommonWithItsReference) {
  const double r2 = 0.49;
  for (const double a : {0.5, 3.0, 40.0}) {
    const double half = 0.5 * (1.0 - a);
    const double root = std::sqrt(half * half + a * (1.0 - r2));
    const CorrelatedMean mean({1.0, Complex(0.0, 0.7), Complex(0.0, -0.7), 1.0}, 2);
    EXPECT_NEAR(std::exp(mean.log_false_alarm(a)), (half + root) / (2.0 * root), 1e-12);
  }
}

TEST(CorrelatedMean, OfIndependentCellsIsTheClosedForm) {
  constexpr std::size_t size = 17;
  std::vector<Complex> matrix(size * size);
  for (std::size_t i = 0; i < size; ++i) matrix[i * size + i] = 1.0;
  EXPECT_NEAR(CorrelatedMean(matrix, size).factor(1e-6) / cell_averaging_factor(16, 1e-6), 1.0, 1e-6);
  const double statistic = correlated_statistic_factor(matrix, size, 12, 1e-4);
  EXPECT_NEAR(ordered_statistic_probability(16, 12, statistic, 0.0) / 1e-4, 1.0, 0.05);
}

TEST(CfarCalibration, LeavesWhiteNoiseAndMapsWithoutReferenceAlone) {
  const CfarOptions options;
  EXPECT_EQ(cfar_calibration({}, options, 8, 100), 1.0);
  EXPECT_EQ(cfar_calibration(chirp_noise(2.0), options, 0, 0), 1.0);
  EXPECT_EQ(cfar_calibration(chirp_noise(2.0), options, 1, 3), 1.0);
  CfarOptions wide = options;
  wide.reference_columns = 300;
  EXPECT_EQ(cfar_calibration(chirp_noise(2.0), wide, 8, 1000), 1.0);
}

// Doppler rows under Hann's window: neighbours are correlated by -2/3, the next by 1/6, whatever the columns are.
TEST(CfarCalibration, CountsCorrelatedRows) {
  NoiseCorrelation noise;
  noise.along_rows.assign(16, 0.0);
  noise.along_rows[0] = 1.0;
  noise.along_rows[1] = noise.along_rows[15] = -2.0 / 3.0;
  noise.along_rows[2] = noise.along_rows[14] = 1.0 / 6.0;
  CfarOptions options;
  options.reference_columns = 4;
  options.reference_rows = 2;
  options.guard_rows = 2;
  options.false_alarm = 1e-4;
  // Columns are independent: 4 of 5 cells each, of eigenvalues l; P = product of (1 + a l/20)^-4.
  options.guard_columns = 2;
  const double asked = cfar_factor(20, options) * cfar_calibration(noise, options, 16, 100);
  std::vector<Complex> column(36);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t off = i > k ? i - k : k - i;
      column[i * 6 + k] = i == k ? 1.0 : (i == 0 || k == 0 || off > 2 ? 0.0 : (off == 1 ? -2.0 / 3.0 : 1.0 / 6.0));
    }
  EXPECT_NEAR(4.0 * CorrelatedMean(column, 6).log_false_alarm(asked / 4.0), std::log(1e-4), 1e-4);
}

}  // namespace cfar_calibration_test
}  // namespace sarsim::signal
