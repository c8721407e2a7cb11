#pragma once

#include <cstddef>
#include <stdexcept>

namespace sarsim::raster {

/// Watches that the rows of a product arrive in order and completely.
class RowOrder {
 public:
  explicit RowOrder(std::size_t rows) : rows_(rows) {}

  /// Checks the next rows without taking them; std::logic_error where they are not the next ones or too many.
  void expect(std::size_t first_row, std::size_t rows) const {
    if (first_row != next_ || rows > rows_ - next_) throw std::logic_error("rows appended out of order");
  }
  void take(std::size_t rows) { next_ += rows; }
  /// std::logic_error where rows are missing.
  void expect_all() const {
    if (next_ != rows_) throw std::logic_error("a recording finished before all its rows were appended");
  }

 private:
  std::size_t rows_;
  std::size_t next_ = 0;
};

}  // namespace sarsim::raster
