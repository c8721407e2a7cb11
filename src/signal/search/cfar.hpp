#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/task/parallel.hpp"

namespace sarsim::signal {

/// Detection with a constant rate of false alarms: a cell is reported where its power exceeds a factor times what the
/// cells around it say about the noise. Factors are exact for independent cells of exponentially distributed power: a
/// square-law detector in complex normal noise (Finn and Johnson, RCA Review 29, 1968; Rohling, IEEE Trans. AES 19,
/// 1983).
struct CfarOptions {
  enum class Kind {
    cell_averaging,     ///< Noise: the mean of the reference cells.
    ordered_statistic,  ///< Noise: the `rank`-th smallest of them, the first being 1; other targets among them do not
                        ///< matter.
  };
  Kind kind = Kind::cell_averaging;
  double false_alarm = 1e-6;  ///< Probability for a cell, between 0 and 1.
  /// Reference cells: within so many rows and columns of the cell, but not within the guard.
  std::size_t reference_rows = 0;
  std::size_t reference_columns = 16;
  std::size_t guard_rows = 0;
  std::size_t guard_columns = 2;
  double rank_share = 0.75;  ///< Kind::ordered_statistic: the rank over the number of reference cells, rounded up.
  /// Independent cells that a reference cell is worth, above 0: 1 in white noise, less where neighbours are correlated
  /// (see `independence`). The factors are then those for so many cells fewer: exact no more, but a mean's variance is
  /// right.
  double independence = 1.0;
  /// Multiplies those factors, above 0: makes them exact where neighbours are correlated (`cfar_calibration`).
  double calibration = 1.0;
};

/// A cell that stands out.
struct CfarDetection {
  std::size_t row = 0;
  std::size_t column = 0;
  double power = 0.0;
  double noise = 0.0;      ///< Mean, or statistic, of the reference cells.
  double threshold = 0.0;  ///< Factor times `noise`.
  std::size_t reference_cells = 0;
};

/// Mean power of the noise by a cell's reference: the mean itself, or the statistic over what it is on the average in
/// noise of power 1, the sum over i = 0 ... rank - 1 of 1/(N - i).
[[nodiscard]] double noise_power(const CfarDetection& detection, const CfarOptions& options);

/// Rank that `CfarOptions::rank_share` means among so many cells.
[[nodiscard]] std::size_t cfar_rank(std::size_t cells, double share);

/// Reference cells of a cell in the middle of a map: as many as any has.
[[nodiscard]] std::size_t reference_cells(const CfarOptions& options, std::size_t rows, std::size_t columns);

/// Whether any cell of a map has reference cells: at its corners the guard covers least.
[[nodiscard]] bool has_reference_cells(const CfarOptions& options, std::size_t rows, std::size_t columns);

/// Factor on the noise for a cell with so many reference cells.
[[nodiscard]] double cfar_factor(std::size_t cells, const CfarOptions& options);

/// rho[m], m = 0 ... taps - 1: the correlation of white noise that passed a filter, rho[0] = 1. {1} for a filter
/// without energy.
[[nodiscard]] std::vector<std::complex<double>> noise_correlation(std::span<const std::complex<double>> filter);

/// |rho[m]|^2, m = 0, 1 ..., rho being the correlation of white noise that passed a filter.
[[nodiscard]] std::vector<double> power_correlation(std::span<const std::complex<double>> filter);

/// Independent cells that one of many is worth for the noise that a detector finds, by the correlation of their complex
/// numbers; for `CfarOptions::independence`. It is 1 over the sum of the correlations of what is averaged: of powers,
/// |rho|^2, for the mean; for the statistic of whether they exceed its quantile, q = -ln(1 - share) in noise of power
/// 1,
///
///     sum over n >= 1 of |rho|^2n (L[n](q) - L[n - 1](q))^2 exp(-q)/(1 - exp(-q)),
///
/// L being Laguerre's polynomials (the bivariate exponential distribution: W. F. Kibble, Sankhya 5, 1941).
/// @param along_columns  |rho|^2 at distances 0, 1 ... to either side
/// @param along_rows     at distances 0, 1 ... all the way round; 1 alone for references in the cell's own row
[[nodiscard]] double independence(std::span<const double> along_columns, std::span<const double> along_rows,
                                  const CfarOptions& options);

/// Looks at every cell of a map; at its edges the cells that there are count, with the factor for their number. Cells
/// without reference cells are passed over.
/// @param power  rows of `columns` values, in units that do not matter
/// @return       in the order of the cells, the same for any number of threads
/// @throw        std::invalid_argument where sizes or options make no sense; Interrupted
[[nodiscard]] std::vector<CfarDetection> detect_cfar(std::span<const float> power, std::size_t columns,
                                                     const CfarOptions& options, const core::WorkControl& control);

/// Factor on the mean of `cells` cells: N (P^(-1/N) - 1).
[[nodiscard]] double cell_averaging_factor(std::size_t cells, double false_alarm);
/// Probability of a target of exponentially distributed power (Swerling 1; noise alone where the ratio is 0), one
/// pulse, to exceed the mean's multiple: (1 + factor/(N (1 + snr)))^(-N).
[[nodiscard]] double cell_averaging_probability(std::size_t cells, double factor, double snr);

/// Factor on the `rank`-th smallest of `cells` cells, from the probability below.
[[nodiscard]] double ordered_statistic_factor(std::size_t cells, std::size_t rank, double false_alarm);
/// The same for the statistic: product over i = 0 ... rank - 1 of (N - i)/(N - i + factor/(1 + snr)).
[[nodiscard]] double ordered_statistic_probability(std::size_t cells, std::size_t rank, double factor, double snr);

}  // namespace sarsim::signal
