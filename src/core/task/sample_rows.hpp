#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace sarsim::core {

/// Rows of complex samples that need not be in memory: computed, or read from a file, when they are asked for. The one
/// way in which echoes, recordings and images are handed from step to step; what its rows and columns are, the types
/// that hold it say.
template <class Real>
struct SampleRows {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// Copies a row into `columns` samples; called from many threads at once. Asked through `read`.
  std::function<void(std::size_t row, std::span<std::complex<Real>> out)> copy;

  /// Copies a row; may be called from many threads at once.
  /// @param row  below `rows`
  /// @param out  `columns` samples
  void read(std::size_t row, std::span<std::complex<Real>> out) const;
};

extern template struct SampleRows<float>;
extern template struct SampleRows<double>;

/// Rows of samples in memory, one row after the other, which are kept as long as these rows.
[[nodiscard]] SampleRows<float> rows_in_memory(std::shared_ptr<const std::vector<std::complex<float>>> values,
                                               std::size_t rows, std::size_t columns);
[[nodiscard]] SampleRows<double> rows_in_memory(std::shared_ptr<const std::vector<std::complex<double>>> values,
                                                std::size_t rows, std::size_t columns);
/// The same of samples that somebody else keeps.
[[nodiscard]] SampleRows<float> rows_in_memory(std::span<const std::complex<float>> values, std::size_t rows,
                                               std::size_t columns);
[[nodiscard]] SampleRows<double> rows_in_memory(std::span<const std::complex<double>> values, std::size_t rows,
                                                std::size_t columns);

}  // namespace sarsim::core
