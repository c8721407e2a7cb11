#include "signal/sar/projection_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/maths/constants.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

// Whether distances from the antenna change less along a column of the grid than along a row: then the points of a
// vector, which are on a line, share most of their records.
bool changes_less_along_columns(const PointGrid& grid, const SarEchoes& echoes) {
  constexpr std::size_t looks = 16;
  double down_m = 0.0;
  double right_m = 0.0;
  for (std::size_t look = 0; look < looks; ++look) {
    const TrackPoint& antenna = echoes.track[look * (echoes.track.size() - 1) / (looks - 1)];
    for (const double row : {0.0, 0.5, 1.0})
      for (const double column : {0.0, 0.5, 1.0}) {
        const double i = row * static_cast<double>(grid.rows);
        const double j = column * static_cast<double>(grid.columns);
        const core::Vec3 point_m = grid.at(i, j);
        const core::Vec3 r = point_m - antenna.position_m;
        const double distance_m = std::max(core::norm(r), 1e-300);
        down_m += std::abs(core::dot(r, grid.at(i + 1.0, j) - point_m)) / distance_m;
        right_m += std::abs(core::dot(r, grid.at(i, j + 1.0) - point_m)) / distance_m;
      }
  }
  return down_m < right_m;
}

using Four = std::array<core::Vec3, 4>;

// Where a polynomial of degree 3 is fitted to a function from -half to half: the zeros of Chebyshev's of degree 4.
std::array<double, 4> nodes_within(double middle, double half) {
  std::array<double, 4> nodes{};
  for (std::size_t k = 0; k < 4; ++k)
    nodes[k] = middle - half * std::cos((2.0 * static_cast<double>(k) + 1.0) * core::pi / 8.0);
  return nodes;
}

// The powers of the cubic through four values, by divided differences.
Four cubic_through(const std::array<double, 4>& x, Four values) {
  for (std::size_t order = 1; order < 4; ++order)
    for (std::size_t k = 3; k >= order; --k) values[k] = (1.0 / (x[k] - x[k - order])) * (values[k] - values[k - 1]);
  Four powers{values[3], {}, {}, {}};
  for (std::size_t k = 3; k-- > 0;) {
    for (std::size_t power = 3; power > 0; --power) powers[power] = powers[power - 1] - x[k] * powers[power];
    powers[0] = values[k] - x[k] * powers[0];
  }
  return powers;
}

// The rows of a tile, from their middle, and the columns of a stretch from its own.
constexpr double half_rows = StretchSurface::middle_row;
constexpr double middle_of_columns = -0.5;
double half_columns(std::size_t stretch) { return 0.5 * (static_cast<double>(stretch) - 1.0); }

// @param point_at  place of a row of the tile and a column from the middle of the stretch
template <class PointAt>
StretchSurface fitted_surface(std::size_t stretch, const PointAt& point_at) {
  const std::array<double, 4> i = nodes_within(0.0, half_rows);
  const std::array<double, 4> j = nodes_within(middle_of_columns, half_columns(stretch));
  std::array<Four, 4> along_columns;
  for (std::size_t a = 0; a < 4; ++a) {
    Four values;
    for (std::size_t b = 0; b < 4; ++b) values[b] = point_at(i[a] + half_rows, j[b]);
    along_columns[a] = cubic_through(j, values);
  }
  StretchSurface surface;
  for (std::size_t b = 0; b < 4; ++b) {
    const Four powers =
        cubic_through(i, {along_columns[0][b], along_columns[1][b], along_columns[2][b], along_columns[3][b]});
    for (std::size_t a = 0; a < 4; ++a) surface.terms[a][b] = powers[a];
  }
  return surface;
}

// The largest distance of the cubic from the surface, where the remainder of degree 4 is largest.
template <class PointAt>
double misfit_m(const StretchSurface& surface, std::size_t stretch, const PointAt& point_at) {
  double max_m = 0.0;
  for (std::size_t a = 0; a <= 4; ++a)
    for (std::size_t b = 0; b <= 4; ++b) {
      const double row = half_rows * (1.0 - std::cos(0.25 * core::pi * static_cast<double>(a)));
      const double j = middle_of_columns - half_columns(stretch) * std::cos(0.25 * core::pi * static_cast<double>(b));
      max_m = std::max(max_m, core::norm(surface.point_m(row, j) - point_at(row, j)));
    }
  return max_m;
}

// The term of degree 4 of the distances along the stretch, which its polynomial leaves out, at its ends.
double neglected_m(const StretchSurface& surface, std::size_t stretch, const core::Vec3& antenna_m) {
  const double quarter = 0.25 * static_cast<double>(stretch);
  double max_m = 0.0;
  for (const double row : {0.0, 2.0 * half_rows}) {
    const auto distance_m = [&](double k) { return core::norm(surface.point_m(row, k * quarter) - antenna_m); };
    const double fourth =
        distance_m(-2.0) - 4.0 * distance_m(-1.0) + 6.0 * distance_m(0.0) - 4.0 * distance_m(1.0) + distance_m(2.0);
    max_m = std::max(max_m, std::abs(fourth) * 16.0 / 24.0);
  }
  return max_m;
}

}  // namespace

ProjectionTiles::ProjectionTiles(const PointGrid& grid, const SarEchoes& echoes, const core::WorkControl& control)
    : grid_(&grid),
      turned_(changes_less_along_columns(grid, echoes)),
      high_(turned_ ? ProjectionTile::columns : ProjectionTile::rows),
      wide_(turned_ ? ProjectionTile::rows : ProjectionTile::columns),
      across_((grid.columns + wide_ - 1) / wide_),
      down_((grid.rows + high_ - 1) / high_),
      plans_(across_ * down_) {
  const double wavelength_m = radar::wavelength_of(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  core::parallel_ranges(count(), 16, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index) plans_[index] = plan_of(index, echoes, wavelength_m);
  });
}

std::size_t ProjectionTiles::rows(std::size_t tile) const { return std::min(high_, grid_->rows - first_row(tile)); }

std::size_t ProjectionTiles::columns(std::size_t tile) const {
  return std::min(wide_, grid_->columns - first_column(tile));
}

core::Vec3 ProjectionTiles::point_m(std::size_t index, double row, double column) const {
  const double down = static_cast<double>(first_row(index)) + (turned_ ? column : row);
  const double right = static_cast<double>(first_column(index)) + (turned_ ? row : column);
  return grid_->at(down, right);
}

Stretch ProjectionTiles::longest_stretch(std::size_t index, const SarEchoes& echoes, double wavelength_m) const {
  // Stretches reach to the end of the tile even where it is not used.
  constexpr auto rows = static_cast<double>(ProjectionTile::rows);
  constexpr auto columns = static_cast<double>(ProjectionTile::columns);
  const core::Vec3 middle_m = point_m(index, 0.5 * rows, 0.5 * columns);
  double reach_m = 0.0;
  double step_m = 0.0;
  for (const double row : {0.0, rows})
    for (const double column : {0.0, columns}) {
      const core::Vec3 corner_m = point_m(index, row, column);
      reach_m = std::max(reach_m, core::norm(corner_m - middle_m));
      step_m = std::max(step_m, core::norm(point_m(index, row, column + 1.0) - corner_m));
    }
  double nearest_m = 1e300;
  for (const TrackPoint& point : echoes.track) nearest_m = std::min(nearest_m, core::norm(middle_m - point.position_m));
  for (const core::Vec3& receiver_m : echoes.receivers_m)
    nearest_m = std::min(nearest_m, core::norm(middle_m - receiver_m));
  return stretch_for(nearest_m - reach_m, step_m, wavelength_m);
}

ProjectionTiles::Plan ProjectionTiles::plan_of(std::size_t index, const SarEchoes& echoes, double wavelength_m) const {
  constexpr double max_misfit = 1e-4;       // of a wavelength
  constexpr double max_neglected = 0.5e-5;  // of a wavelength: 1e-5 cycles
  const Stretch longest = longest_stretch(index, echoes, wavelength_m);
  if (!grid_->curved) return {longest, {}};
  const std::size_t last = echoes.track.size() - 1;
  for (const Stretch stretch : {Stretch::of_64, Stretch::of_32, Stretch::of_16}) {
    if (stretch > longest) continue;
    const auto length = static_cast<std::size_t>(stretch);
    Plan plan{stretch, {}};
    bool fits = true;
    for (std::size_t first = 0; fits && first < ProjectionTile::columns; first += length) {
      const auto point_at = [&](double row, double j) {
        return point_m(index, row, static_cast<double>(first) + 0.5 * static_cast<double>(length) + j);
      };
      plan.surface.push_back(fitted_surface(length, point_at));
      const StretchSurface& piece = plan.surface.back();
      fits = misfit_m(piece, length, point_at) < max_misfit * wavelength_m;
      for (const std::size_t pulse : {std::size_t{0}, last / 2, last})
        fits = fits && neglected_m(piece, length, echoes.track[pulse].position_m) < max_neglected * wavelength_m;
    }
    if (fits) return plan;
  }
  return {Stretch::by_point, {}};
}

void ProjectionTiles::place(std::size_t index, ProjectionTile& tile, std::vector<core::Vec3>& points_m) const {
  const Plan& plan = plans_[index];
  tile.used_rows = turned_ ? columns(index) : rows(index);
  tile.used_columns = turned_ ? rows(index) : columns(index);
  tile.surface = plan.surface;
  tile.points_m = {};
  if (!grid_->curved) {
    tile.corner_m = grid_->at(static_cast<double>(first_row(index)), static_cast<double>(first_column(index)));
    tile.row_step_m = turned_ ? grid_->column_step_m : grid_->row_step_m;
    tile.column_step_m = turned_ ? grid_->row_step_m : grid_->column_step_m;
    return;
  }
  if (!plan.surface.empty()) return;
  points_m.resize(points);
  for (std::size_t row = 0; row < ProjectionTile::rows; ++row)
    for (std::size_t column = 0; column < ProjectionTile::columns; ++column)
      points_m[row * ProjectionTile::columns + column] =
          point_m(index, static_cast<double>(row), static_cast<double>(column));
  tile.points_m = points_m;
}

}  // namespace sarsim::signal
