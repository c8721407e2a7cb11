#pragma once

#include <cstddef>

namespace sarsim::raster {

/// Which samples of an image are wanted: row row0 + i row_step and column col0 + k col_step for i below rows and k
/// below cols.
struct ImageWindow {
  std::size_t row0 = 0;
  std::size_t rows = 0;  ///< Number of rows that are read, not their extent.
  std::size_t col0 = 0;
  std::size_t cols = 0;
  std::size_t row_step = 1;  ///< At least 1.
  std::size_t col_step = 1;

  [[nodiscard]] std::size_t row(std::size_t i) const { return row0 + i * row_step; }
  [[nodiscard]] std::size_t column(std::size_t k) const { return col0 + k * col_step; }
  [[nodiscard]] std::size_t samples() const { return rows * cols; }

  friend bool operator==(const ImageWindow&, const ImageWindow&) = default;
};

/// Whether `count` places from `first` on, `step` apart, lie below `size`.
[[nodiscard]] constexpr bool fits(std::size_t first, std::size_t count, std::size_t step, std::size_t size) {
  if (step == 0) return false;
  if (count == 0) return true;
  return first < size && (size - 1 - first) / step >= count - 1;
}

}  // namespace sarsim::raster
