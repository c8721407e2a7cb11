#pragma once

#include <cstddef>
#include <vector>

#include "core/task/parallel.hpp"
#include "signal/sar/back_projection.hpp"
#include "signal/sar/back_projection_kernel.hpp"
#include "signal/sar/sar_echoes.hpp"

namespace sarsim::signal {

/// The rectangles in which a grid is computed, in bands of whole rows of the grid. The columns of a tile run along
/// those of the grid or, if distances from the antenna change less that way, along its rows. On a curved surface the
/// points of each stretch of a tile follow from a bicubic polynomial within 1e-4 of a wavelength of the surface; where
/// no stretch is accurate enough, as directly below a track, each point is computed by itself.
class ProjectionTiles {
 public:
  static constexpr std::size_t points = ProjectionTile::rows * ProjectionTile::columns;

  /// Keeps a reference to the grid.
  /// @throw  Interrupted
  ProjectionTiles(const PointGrid& grid, const SarEchoes& echoes, const core::WorkControl& control);

  [[nodiscard]] std::size_t count() const { return across_ * down_; }
  [[nodiscard]] std::size_t first_row(std::size_t tile) const { return tile / across_ * high_; }
  [[nodiscard]] std::size_t first_column(std::size_t tile) const { return tile % across_ * wide_; }
  /// Rows of the grid in a tile.
  [[nodiscard]] std::size_t rows(std::size_t tile) const;
  /// Columns of the grid in a tile.
  [[nodiscard]] std::size_t columns(std::size_t tile) const;
  [[nodiscard]] std::size_t tiles_of_band() const { return across_; }
  /// Index in a tile of the point of a row and a column of the grid, counted from the tile's first ones.
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const {
    return turned_ ? column * ProjectionTile::columns + row : row * ProjectionTile::columns + column;
  }
  [[nodiscard]] Stretch stretch(std::size_t tile) const { return plans_[tile].stretch; }

  /// Gives a tile its points.
  /// @param points_m  storage for points that are computed one by one; must outlive the tile
  void place(std::size_t index, ProjectionTile& tile, std::vector<core::Vec3>& points_m) const;

 private:
  struct Plan {
    Stretch stretch = Stretch::by_point;
    std::vector<StretchSurface> surface;
  };

  // The place of a row and a column of a tile, in between too.
  [[nodiscard]] core::Vec3 point_m(std::size_t index, double row, double column) const;
  // The longest stretch that the antenna's nearest approach to a tile allows.
  [[nodiscard]] Stretch longest_stretch(std::size_t index, const SarEchoes& echoes, double wavelength_m) const;
  [[nodiscard]] Plan plan_of(std::size_t index, const SarEchoes& echoes, double wavelength_m) const;

  const PointGrid* grid_;
  bool turned_;
  std::size_t high_, wide_;  // in rows and columns of the grid
  std::size_t across_;
  std::size_t down_;
  std::vector<Plan> plans_;
};

}  // namespace sarsim::signal
