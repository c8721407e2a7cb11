#include "radar/atmosphere/slant_table.hpp"

#include <cmath>

#include "core/report/expect.hpp"
#include "radar/atmosphere/polynomial_nodes.hpp"

namespace sarsim::radar {

SlantTable::SlantTable(const Grid& grid, const Function& function)
    : heights_(grid.heights), lowest_sine_(grid.lowest_sine), offset_(0.1 - 2.0 * grid.lowest_sine) {
  CORE_EXPECT(grid.heights.low_m < grid.heights.high_m && grid.lowest_sine <= 0.0);
  const auto variable = [&](double sine) { return sine / (offset_ + sine); };
  const double height_m = heights_.high_m - heights_.low_m;
  first_variable_ = variable(lowest_sine_);
  const double width = variable(highest_sine) - first_variable_;
  height_cells_ = static_cast<int>(std::ceil(height_m / grid.height_step_m));
  sine_cells_ = static_cast<int>(std::ceil(width * offset_ / grid.sine_step));
  height_rate_ = height_cells_ / height_m;
  variable_rate_ = sine_cells_ / width;
  for (int i = 0; i < height_cells_; ++i)
    for (int j = 0; j < sine_cells_; ++j) cells_.push_back(cell(i, j, function));
}

SlantTable::Cell SlantTable::cell(int height_cell, int sine_cell, const Function& function) const {
  const auto& height_nodes = polynomial_nodes<height_terms>().y;
  const auto& sine_nodes = polynomial_nodes<sine_terms>().y;
  std::array<std::array<double, sine_terms>, height_terms> columns{};  // by power of height, at each node of the sine
  for (std::size_t j = 0; j < sine_terms; ++j) {
    const double variable = first_variable_ + (sine_cell + 0.5 * (sine_nodes[j] + 1.0)) / variable_rate_;
    const double sine = offset_ * variable / (1.0 - variable);
    Row values{};
    for (std::size_t i = 0; i < height_terms; ++i) {
      const double height_m = heights_.low_m + (height_cell + 0.5 * (height_nodes[i] + 1.0)) / height_rate_;
      values[i] = (offset_ + sine) * function(height_m, sine);
    }
    const Row powers = powers_through(values);
    for (std::size_t l = 0; l < height_terms; ++l) columns[l][j] = powers[l];
  }
  Cell cell{};
  for (std::size_t l = 0; l < height_terms; ++l) {
    const auto powers = powers_through(columns[l]);
    for (std::size_t k = 0; k < sine_terms; ++k) cell[k][l] = powers[k];
  }
  return cell;
}

}  // namespace sarsim::radar
