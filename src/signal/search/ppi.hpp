#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sarsim::signal {

/// The pixels of a plan position indicator: squares on the ground, north (+y) up, east (+x) to the right. Row 0 is the
/// northernmost.
struct PpiGrid {
  double first_x_m = 0.0;  ///< World x of the middle of the first column.
  double first_y_m = 0.0;  ///< World y of the middle of the first row.
  double pixel_m = 1.0;    ///< Side of a pixel, above 0.
  std::size_t columns = 0;
  std::size_t rows = 0;

  [[nodiscard]] double x_m(std::size_t column) const { return first_x_m + static_cast<double>(column) * pixel_m; }
  [[nodiscard]] double y_m(std::size_t row) const { return first_y_m - static_cast<double>(row) * pixel_m; }
};

/// A square grid that reaches `extent_m` to every side of a point, which is the middle of a pixel.
/// @throw  std::invalid_argument where the pixels are not above 0
[[nodiscard]] PpiGrid ppi_grid(double x_m, double y_m, double extent_m, double pixel_m);

/// What a beam sees while it points into a sector: the strength of each cell of range.
struct PpiLine {
  double x_m = 0.0;  ///< World position of the antenna.
  double y_m = 0.0;
  double begin_rad = 0.0;  ///< Sector, azimuths from +y clockwise; end after begin, at most a whole turn.
  double end_rad = 0.0;
  std::span<const double> edges_m;   ///< Ground ranges of the ends of the cells, ascending: one more than cells.
  std::span<const float> strengths;  ///< 0 or above.
};

/// The picture of a rotating antenna: polar lines, converted to pixels as they come. A pixel holds the largest of what
/// was painted on it; a cell of a line is painted on the pixels whose middle it holds and on the one that its own
/// middle is in, so that no cell is lost, however small. Sectors that share an edge leave neither gap nor overlap. The
/// order of the lines does not matter.
class PpiPicture {
 public:
  /// A picture that shows nothing yet.
  explicit PpiPicture(const PpiGrid& grid);

  /// Paints a sector over what was painted before.
  void paint(const PpiLine& line);

  [[nodiscard]] const PpiGrid& grid() const { return grid_; }
  /// grid().rows rows of grid().columns; 0 where nothing was painted.
  [[nodiscard]] const std::vector<float>& values() const { return values_; }

 private:
  struct Sector;
  struct Indices {
    std::size_t begin, end;
  };
  struct Patch {
    Indices rows, columns;
  };
  [[nodiscard]] Patch patch_of(const PpiLine& line, const Sector& sector, double near_m, double far_m) const;
  template <class StrengthAt>
  void paint_patch(const PpiLine& line, const Sector& sector, const Patch& patch, StrengthAt&& strength_at);
  void paint_cells(const PpiLine& line, const Sector& sector);
  void paint_pixels(const PpiLine& line, const Sector& sector);
  void paint_middle(const PpiLine& line, const Sector& sector, double range_m, float strength);

  PpiGrid grid_;
  std::vector<float> values_;
};

}  // namespace sarsim::signal
