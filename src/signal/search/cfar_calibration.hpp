#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "signal/search/cfar.hpp"

namespace sarsim::signal {

/// Correlation of the complex noise of a map's cells, normalised to power 1: the product of that along a row and that
/// across rows.
struct NoiseCorrelation {
  std::vector<std::complex<double>> along_columns{1.0};  ///< At distances 0, 1 ... to the right; 0 beyond.
  /// At distances 0, 1 ... all the way round; 1 alone for references in the cell's own row.
  std::vector<std::complex<double>> along_rows{1.0};
};

/// Probability that a cell of noise exceeds `factor` times the mean of its reference cells, exact for complex normal
/// noise of any correlation, also between the cell and its reference. With z the cell and its N reference cells of
/// correlation matrix R, and A = diag(1, -a/N, ... -a/N), it is the probability of z^H A z > 0. R A has one positive
/// eigenvalue, 1/s; the others are l[k] < 0, and
///
///     P = product over k of 1/(1 - s l[k]),
///
/// for cells that are independent of their reference 1/det(I + a/N R), the distribution of a sum of exponential numbers
/// whose means are the eigenvalues of R. R is brought to three diagonals once.
class CorrelatedMean {
 public:
  /// @param matrix  R by rows, the cell itself first; Hermitian, 1 on its diagonal
  explicit CorrelatedMean(std::vector<std::complex<double>> matrix, std::size_t size);

  /// ln P for a factor of at least 0.
  [[nodiscard]] double log_false_alarm(double factor) const;
  /// The factor for a P between 0 and 1, to a relative 1e-6.
  [[nodiscard]] double factor(double false_alarm) const;

 private:
  std::vector<double> diagonal_;  // of the reference alone
  std::vector<double> squares_;   // |off-diagonal|^2, the first between the cell and its reference
};

/// Factor on the `rank`-th smallest of correlated reference cells for a P between 0 and 1: that at which the mean of
/// the probability given the reference is P. The mean is over draws of the reference from fixed random numbers, made by
/// a law under which false alarms are common, and weighted by how common the draws truly are (importance sampling).
/// Right to about 2 %.
/// @param matrix  R by rows, the cell itself first; Hermitian, 1 on its diagonal
[[nodiscard]] double correlated_statistic_factor(const std::vector<std::complex<double>>& matrix, std::size_t size,
                                                 std::size_t rank, double false_alarm);

/// What the factors of independent cells are to be multiplied by, for `CfarOptions::calibration`: the factor for a cell
/// in the middle of a map with its correlated reference over that of `cfar_factor`. 1 for white noise, for references
/// without cells and for those of more than 400, whose mean is all but that of independent ones.
[[nodiscard]] double cfar_calibration(const NoiseCorrelation& correlation, const CfarOptions& options, std::size_t rows,
                                      std::size_t columns);

}  // namespace sarsim::signal
