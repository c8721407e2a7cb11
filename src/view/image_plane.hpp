#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>

namespace sarsim {

/// Which samples of a plane are wanted: row row0 + i row_step and column col0 + k col_step for i below rows and k below
/// cols.
struct PlaneWindow {
  std::size_t row0 = 0;
  std::size_t rows = 0;  ///< Number of rows that are read, not their extent.
  std::size_t col0 = 0;
  std::size_t cols = 0;
  std::size_t row_step = 1;  ///< At least 1.
  std::size_t col_step = 1;

  [[nodiscard]] std::size_t samples() const { return rows * cols; }
  friend bool operator==(const PlaneWindow&, const PlaneWindow&) = default;
};

/// A table of complex samples, of whatever size and from wherever: a file, a product that was computed.
struct ImagePlane {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// Reads a window row by row into window.samples() places. Called from several threads at once; what it throws comes
  /// out of whatever asked for the samples.
  std::function<void(const PlaneWindow&, std::span<std::complex<float>>)> read;
};

}  // namespace sarsim
