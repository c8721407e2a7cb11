#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace sarsim::radar {

/// A span of heights, m.
struct HeightSpan {
  double low_m = 0.0;
  double high_m = 0.0;
};

/// A function of the height of a point and of the sine w of an elevation there that falls as 1/w to the zenith: the
/// integral of something over the straight way from the point to space. Cells are even in height and in w/(b + w),
/// where b = 0.1 + 2 |lowest w|; each holds a polynomial, of degree 3 in height and 5 in the other, for (b + w) times
/// the function. Neighbouring cells meet.
class SlantTable {
 public:
  /// How a table is cut.
  struct Grid {
    HeightSpan heights;
    double height_step_m = 1000.0;  ///< Largest height of a cell.
    double lowest_sine = 0.0;       ///< At most 0. The highest one is `highest_sine`.
    double sine_step = 0.003;       ///< Largest width of a cell at the horizon.
  };
  using Function = std::function<double(double height_m, double sine)>;

  /// Somewhat above 1: heights over an ellipsoid may be farther apart than the ends of a path.
  static constexpr double highest_sine = 1.02;

  /// Holds nothing.
  SlantTable() = default;
  /// Calls the function 24 times for each cell.
  SlantTable(const Grid& grid, const Function& function);

  /// True where `at` may be asked.
  [[nodiscard]] bool holds(double height_m, double sine) const {
    return height_m >= heights_.low_m && height_m <= heights_.high_m && sine >= lowest_sine_ && sine <= highest_sine;
  }
  /// The function; only where `holds` is true.
  [[nodiscard]] double at(double height_m, double sine) const;

 private:
  static constexpr std::size_t sine_terms = 6;
  static constexpr std::size_t height_terms = 4;
  using Row = std::array<double, height_terms>;  // powers of height's variable
  using Cell = std::array<Row, sine_terms>;      // by power of the sine's variable

  [[nodiscard]] Cell cell(int height_cell, int sine_cell, const Function& function) const;

  HeightSpan heights_{0.0, -1.0};
  double lowest_sine_ = 0.0;
  double offset_ = 0.1;          // b
  double first_variable_ = 0.0;  // of w/(b + w)
  double height_rate_ = 1.0;     // cells for each m
  double variable_rate_ = 1.0;   // cells for each unit of w/(b + w)
  int height_cells_ = 0;
  int sine_cells_ = 0;
  std::vector<Cell> cells_;  // by height, then sine
};

inline double SlantTable::at(double height_m, double sine) const {
  const double scale = 1.0 / (offset_ + sine);
  const double x = (height_m - heights_.low_m) * height_rate_;
  const double y = (sine * scale - first_variable_) * variable_rate_;
  const int i = std::min(static_cast<int>(x), height_cells_ - 1);
  const int j = std::min(static_cast<int>(y), sine_cells_ - 1);
  const double u = 2.0 * (x - i) - 1.0, v = 2.0 * (y - j) - 1.0;
  const Cell& cell = cells_[static_cast<std::size_t>(i * sine_cells_ + j)];
  Row row = cell[sine_terms - 1];
  for (std::size_t k = sine_terms - 1; k-- > 0;)
    for (std::size_t l = 0; l < height_terms; ++l) row[l] = row[l] * v + cell[k][l];
  const double value = row[0] + u * (row[1] + u * (row[2] + u * row[3]));
  return value * scale;
}

}  // namespace sarsim::radar
