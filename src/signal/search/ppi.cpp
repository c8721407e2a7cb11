#include "signal/search/ppi.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::signal {

namespace {

struct Direction {
  double x, y;
};

// Unit vector of an azimuth.
Direction towards(double azimuth_rad) { return {std::sin(azimuth_rad), std::cos(azimuth_rad)}; }

// Above 0 where (x, y) lies clockwise of a direction, by less than half a turn.
double clockwise_of(const Direction& d, double x, double y) { return d.y * x - d.x * y; }

struct Box {
  double low_x, high_x, low_y, high_y;

  void take(double x, double y) {
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_y = std::min(low_y, y);
    high_y = std::max(high_y, y);
  }
};

// Indices from `low` to `high` in units of pixels; empty where there are none.
template <class Indices>
Indices indices_in(double low, double high, std::size_t count) {
  const double first = std::max(0.0, std::ceil(low));
  const double last = std::min(std::floor(high), static_cast<double>(count) - 1.0);
  if (!(last >= first)) return {0, 0};
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last) + 1};
}

}  // namespace

// At most a quarter of a turn.
struct PpiPicture::Sector {
  Sector(double begin_rad, double end_rad)
      : begin(towards(begin_rad)), end(towards(end_rad)), middle(towards(0.5 * (begin_rad + end_rad))) {
    // Where an arc crosses an axis it reaches farthest.
    const double axis = std::ceil(begin_rad / (0.5 * core::pi));
    crosses = axis * 0.5 * core::pi < end_rad;
    if (crosses) crossing = towards(axis * 0.5 * core::pi);
  }
  Direction begin, end, middle;
  Direction crossing{};
  bool crosses = false;
};

PpiGrid ppi_grid(double x_m, double y_m, double extent_m, double pixel_m) {
  if (!(pixel_m > 0.0) || !(extent_m >= 0.0)) throw std::invalid_argument("picture: pixels must be above 0");
  const auto reach = static_cast<std::size_t>(std::ceil(extent_m / pixel_m));
  PpiGrid grid;
  grid.pixel_m = pixel_m;
  grid.rows = grid.columns = 2 * reach + 1;
  grid.first_x_m = x_m - static_cast<double>(reach) * pixel_m;
  grid.first_y_m = y_m + static_cast<double>(reach) * pixel_m;
  return grid;
}

PpiPicture::PpiPicture(const PpiGrid& grid) : grid_(grid), values_(grid.rows * grid.columns) {
  CORE_EXPECT(grid.pixel_m > 0.0);
}

void PpiPicture::paint(const PpiLine& line) {
  if (line.edges_m.size() != line.strengths.size() + 1)
    throw std::invalid_argument("picture: a line needs one more edge than cells");
  const double turn = line.end_rad - line.begin_rad;
  if (!(turn > 0.0) || turn > 2.0 * core::pi + 1e-9) throw std::invalid_argument("picture: no sector to paint");
  const auto parts = static_cast<std::size_t>(std::ceil(turn / (0.5 * core::pi) - 1e-9));
  for (std::size_t part = 0; part < parts; ++part) {
    const auto edge = [&](std::size_t i) {
      return i == parts ? line.end_rad : line.begin_rad + turn * static_cast<double>(i) / static_cast<double>(parts);
    };
    const Sector sector(edge(part), edge(part + 1));
    constexpr double wide_rad = 0.25;
    if (turn > wide_rad)
      paint_pixels(line, sector);
    else
      paint_cells(line, sector);
    for (std::size_t i = 0; i < line.strengths.size(); ++i)
      if (line.edges_m[i + 1] > line.edges_m[i] && line.strengths[i] > 0.0F)
        paint_middle(line, sector, 0.5 * (line.edges_m[i] + line.edges_m[i + 1]), line.strengths[i]);
  }
}

// The pixels that may lie between two ranges of a sector.
PpiPicture::Patch PpiPicture::patch_of(const PpiLine& line, const Sector& sector, double near_m, double far_m) const {
  Box box{far_m * sector.begin.x, far_m * sector.begin.x, far_m * sector.begin.y, far_m * sector.begin.y};
  box.take(far_m * sector.end.x, far_m * sector.end.y);
  box.take(near_m * sector.begin.x, near_m * sector.begin.y);
  box.take(near_m * sector.end.x, near_m * sector.end.y);
  if (sector.crosses) box.take(far_m * sector.crossing.x, far_m * sector.crossing.y);
  const double left = line.x_m - grid_.first_x_m;
  const double top = grid_.first_y_m - line.y_m;
  return {indices_in<Indices>((top - box.high_y) / grid_.pixel_m, (top - box.low_y) / grid_.pixel_m, grid_.rows),
          indices_in<Indices>((left + box.low_x) / grid_.pixel_m, (left + box.high_x) / grid_.pixel_m, grid_.columns)};
}

// Paints those pixels of a patch that lie in the sector: by what the function says of the square of their range.
template <class StrengthAt>
void PpiPicture::paint_patch(const PpiLine& line, const Sector& sector, const Patch& patch, StrengthAt&& strength_at) {
  for (std::size_t row = patch.rows.begin; row < patch.rows.end; ++row) {
    const double y = grid_.y_m(row) - line.y_m;
    for (std::size_t column = patch.columns.begin; column < patch.columns.end; ++column) {
      const double x = grid_.x_m(column) - line.x_m;
      if (clockwise_of(sector.begin, x, y) < 0.0 || clockwise_of(sector.end, x, y) >= 0.0) continue;
      float& pixel = values_[row * grid_.columns + column];
      pixel = std::max(pixel, strength_at(x * x + y * y));
    }
  }
}

// Cell by cell: of a narrow sector each lies in a few pixels.
void PpiPicture::paint_cells(const PpiLine& line, const Sector& sector) {
  for (std::size_t i = 0; i < line.strengths.size(); ++i) {
    const double near_m = line.edges_m[i];
    const double far_m = line.edges_m[i + 1];
    const float strength = line.strengths[i];
    if (!(far_m > near_m && strength > 0.0F)) continue;
    paint_patch(line, sector, patch_of(line, sector, near_m, far_m),
                [&](double square) { return square >= near_m * near_m && square < far_m * far_m ? strength : 0.0F; });
  }
}

// Pixel by pixel: of a wide one each cell would look at all pixels within its range.
void PpiPicture::paint_pixels(const PpiLine& line, const Sector& sector) {
  std::vector<double> squares(line.edges_m.size());
  std::ranges::transform(line.edges_m, squares.begin(), [](double edge_m) { return edge_m * edge_m; });
  paint_patch(line, sector, patch_of(line, sector, line.edges_m.front(), line.edges_m.back()), [&](double square) {
    const auto behind = std::ranges::upper_bound(squares, square);
    if (behind == squares.begin() || behind == squares.end()) return 0.0F;
    return line.strengths[static_cast<std::size_t>(behind - squares.begin()) - 1];
  });
}

void PpiPicture::paint_middle(const PpiLine& line, const Sector& sector, double range_m, float strength) {
  const double x_m = line.x_m + range_m * sector.middle.x;
  const double y_m = line.y_m + range_m * sector.middle.y;
  const double column = std::floor((x_m - grid_.first_x_m) / grid_.pixel_m + 0.5);
  const double row = std::floor((grid_.first_y_m - y_m) / grid_.pixel_m + 0.5);
  if (!(column >= 0.0 && row >= 0.0 && column < static_cast<double>(grid_.columns) &&
        row < static_cast<double>(grid_.rows)))
    return;
  float& pixel = values_[static_cast<std::size_t>(row) * grid_.columns + static_cast<std::size_t>(column)];
  pixel = std::max(pixel, strength);
}

}  // namespace sarsim::signal
