#include "signal/sar/back_projection.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/turns.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/back_projection_kernel.hpp"
#include "signal/sar/echo_records.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

namespace {

// Records of the pulses that are projected together; more than one core's cache is no use.
constexpr std::size_t block_bytes = std::size_t{4} << 20;
constexpr std::size_t longest_block = 64;

void expect_sound(const SarEchoes& echoes, const BackProjectionOptions& options) {
  core::expect(echoes.volts.size() == echoes.track.size() * echoes.samples,
               "back-projection: the number of samples is not pulses times samples of a pulse");
  core::expect(echoes.carriers_hz.empty() || echoes.carriers_hz.size() == echoes.track.size(),
               "back-projection: the number of carriers is not that of the pulses");
  core::expect(echoes.waveform.sample_rate_hz > 0.0, "back-projection: the sampling rate is not above 0");
  core::expect(echoes.waveform.light_speed_mps > 0.0, "back-projection: the speed of light is not above 0");
  core::expect(echoes.waveform.carrier_hz > 0.0, "back-projection: the carrier is not above 0");
  core::expect(!options.range_window || echoes.waveform.bandwidth_hz != 0.0,
               "back-projection: a range window needs a bandwidth");
  using Aperture = BackProjectionOptions::Aperture;
  core::expect(options.aperture != Aperture::beam || options.beam_rad > 0.0,
               "back-projection: the beam is not above 0");
  core::expect(options.aperture != Aperture::time || options.time_s > 0.0, "back-projection: the time is not above 0");
  const double heading = core::norm(options.heading);
  core::expect(heading == 0.0 || std::abs(heading - 1.0) < 1e-6, "back-projection: the heading's length is not 1");
  core::expect(std::abs(options.squint_rad) < 0.5 * core::pi, "back-projection: the squint is a right angle or more");
}

ProjectionConstants constants_of(const SarEchoes& echoes, const BackProjectionOptions& options) {
  const SarWaveform& wave = echoes.waveform;
  ProjectionConstants constants;
  constants.carrier_hz = wave.carrier_hz;
  constants.light_speed_mps = wave.light_speed_mps;
  constants.first_delay_s = echoes.first_delay_s;
  constants.records_per_s = static_cast<double>(EchoRecords::factor) * wave.sample_rate_hz;
  constants.doppler_delay_s2 = wave.bandwidth_hz != 0.0 ? wave.pulse_width_s / wave.bandwidth_hz : 0.0;
  constants.moving = !options.start_stop;
  return constants;
}

ProjectionAperture aperture_of(const BackProjectionOptions& options) {
  using Aperture = BackProjectionOptions::Aperture;
  using Kind = ProjectionAperture::Kind;
  ProjectionAperture aperture;
  if (options.aperture == Aperture::all) return aperture;
  aperture.kind = options.aperture == Aperture::beam ? Kind::angle : Kind::time;
  aperture.heading = options.heading;
  aperture.squint_rad = options.squint_rad;
  aperture.extent = options.aperture == Aperture::beam ? options.beam_rad : options.time_s;
  aperture.uniform = !options.azimuth_window;
  if (aperture.uniform) return aperture;
  constexpr std::size_t pieces = ProjectionAperture::pieces;
  for (std::size_t i = 0; i <= pieces; ++i)
    aperture.weights.push_back(
        static_cast<float>(options.azimuth_window(static_cast<double>(i) / static_cast<double>(pieces))));
  aperture.weights.push_back(aperture.weights.back());
  return aperture;
}

// Fits a tile to a curved grid, by a cubic over columns and a line over rows; puts it into the plane of the grid if the
// fit is off by more than 1 in 50 000 of a column, as straight below a track, where the surface bends sharply.
void bend_tile(const PointGrid& grid, double row, double column, ProjectionTile& tile) {
  constexpr double third = static_cast<double>(ProjectionTile::columns - 1) / 3.0;
  constexpr double last_row = static_cast<double>(ProjectionTile::rows - 1);
  const auto at = [&](double i, double j) { return grid.curved(row + i, column + j); };
  const double middle = 0.5 * last_row;
  const core::Vec3 p0 = at(middle, 0.0);
  const core::Vec3 p1 = at(middle, third);
  const core::Vec3 p2 = at(middle, 2.0 * third);
  const core::Vec3 p3 = at(middle, 3.0 * third);
  const core::Vec3 d1 = p1 - p0;
  const core::Vec3 d2 = p2 - 2.0 * p1 + p0;
  const core::Vec3 d3 = p3 - 3.0 * p2 + 3.0 * p1 - p0;
  tile.row_step_m = (1.0 / last_row) * (at(last_row, 1.5 * third) - at(0.0, 1.5 * third));
  tile.column_step_m = (1.0 / third) * (d1 - 0.5 * d2 + (1.0 / 3.0) * d3);
  tile.column_bend_m = (1.0 / (third * third)) * (d2 - d3);
  tile.column_twist_m = (1.0 / (third * third * third)) * d3;
  tile.corner_m = p0 - middle * tile.row_step_m;
  double missed_m = 0.0;
  for (const double i : {0.0, last_row})
    for (const double j : {0.0, 0.5 * third, 1.5 * third, 2.5 * third, 3.0 * third})
      missed_m = std::max(missed_m, core::norm(tile.point_m(i, j) - at(i, j)));
  if (missed_m < 2e-5 * core::norm(grid.column_step_m)) return;
  tile.row_step_m = grid.row_step_m;
  tile.column_step_m = grid.column_step_m;
  tile.column_bend_m = tile.column_twist_m = {};
  tile.corner_m = grid.origin_m + row * grid.row_step_m + column * grid.column_step_m;
}

// The rectangles a grid is computed in.
class Tiles {
 public:
  explicit Tiles(const PointGrid& grid)
      : grid_(&grid),
        across_((grid.columns + ProjectionTile::columns - 1) / ProjectionTile::columns),
        down_((grid.rows + ProjectionTile::rows - 1) / ProjectionTile::rows) {}

  [[nodiscard]] std::size_t count() const { return across_ * down_; }
  [[nodiscard]] std::size_t first_row(std::size_t tile) const { return tile / across_ * ProjectionTile::rows; }
  [[nodiscard]] std::size_t first_column(std::size_t tile) const { return tile % across_ * ProjectionTile::columns; }

  void place(std::size_t index, ProjectionTile& tile) const {
    tile.used_rows = std::min(ProjectionTile::rows, grid_->rows - first_row(index));
    tile.used_columns = std::min(ProjectionTile::columns, grid_->columns - first_column(index));
    if (grid_->curved) {
      bend_tile(*grid_, static_cast<double>(first_row(index)), static_cast<double>(first_column(index)), tile);
      return;
    }
    tile.row_step_m = grid_->row_step_m;
    tile.column_step_m = grid_->column_step_m;
    tile.corner_m = grid_->origin_m + static_cast<double>(first_row(index)) * grid_->row_step_m +
                    static_cast<double>(first_column(index)) * grid_->column_step_m;
  }

 private:
  const PointGrid* grid_;
  std::size_t across_;
  std::size_t down_;
};

// The stretches that the antenna's nearest approach to each tile allows.
std::vector<Stretch> stretches_of(const Tiles& tiles, const SarEchoes& echoes, const core::WorkControl& control) {
  const double wavelength_m = radar::wavelength_of(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  std::vector<Stretch> stretches(tiles.count());
  core::parallel_ranges(tiles.count(), 16, control, [&](std::size_t begin, std::size_t end) {
    ProjectionTile tile;
    for (std::size_t index = begin; index < end; ++index) {
      tiles.place(index, tile);
      // Stretches reach to the end of the tile even where it is not used.
      const core::Vec3 down = 0.5 * static_cast<double>(ProjectionTile::rows) * tile.row_step_m;
      const core::Vec3 right = 0.5 * static_cast<double>(ProjectionTile::columns) * tile.column_step_m;
      const core::Vec3 middle = tile.corner_m + down + right;
      double nearest_m = 1e300;
      for (const TrackPoint& point : echoes.track)
        nearest_m = std::min(nearest_m, core::norm(middle - point.position_m));
      nearest_m -= core::norm(down) + core::norm(right);
      stretches[index] = stretch_for(nearest_m, core::norm(tile.column_step_m), wavelength_m);
    }
  });
  return stretches;
}

// Sums of all points while the pulses are worked through.
struct Sums {
  std::vector<std::complex<float>> values;
  std::vector<float> weights;  // empty where all pulses count
};

void load(const Sums& sums, const Tiles& tiles, std::size_t index, std::size_t columns, ProjectionTile& tile) {
  for (std::size_t row = 0; row < tile.used_rows; ++row)
    for (std::size_t column = 0; column < tile.used_columns; ++column) {
      const std::size_t from = (tiles.first_row(index) + row) * columns + tiles.first_column(index) + column;
      const std::size_t to = row * ProjectionTile::columns + column;
      tile.re[to] = sums.values[from].real();
      tile.im[to] = sums.values[from].imag();
      if (!sums.weights.empty()) tile.weight[to] = sums.weights[from];
    }
}

void store(const ProjectionTile& tile, const Tiles& tiles, std::size_t index, std::size_t columns, Sums& sums) {
  for (std::size_t row = 0; row < tile.used_rows; ++row)
    for (std::size_t column = 0; column < tile.used_columns; ++column) {
      const std::size_t to = (tiles.first_row(index) + row) * columns + tiles.first_column(index) + column;
      const std::size_t from = row * ProjectionTile::columns + column;
      sums.values[to] = {tile.re[from], tile.im[from]};
      if (!sums.weights.empty()) sums.weights[to] = tile.weight[from];
    }
}

void normalize(Sums& sums, std::size_t pulses) {
  const float share = pulses > 0 ? 1.0F / static_cast<float>(pulses) : 0.0F;
  for (std::size_t i = 0; i < sums.values.size(); ++i) {
    if (sums.weights.empty())
      sums.values[i] *= share;
    else
      sums.values[i] = sums.weights[i] != 0.0F ? sums.values[i] / sums.weights[i] : 0.0F;
  }
}

}  // namespace

PointGrid points_of(const ImageFrame& frame, const ImageAxis& azimuth, const ImageAxis& range,
                    std::optional<double> ground_m) {
  CORE_EXPECT(frame.plane == ImagePlane::slant_range || azimuth.count == 0 || azimuth.step_m != 0.0);
  PointGrid grid;
  grid.origin_m = frame.origin_m + azimuth.first_m * frame.along + range.first_m * frame.across;
  grid.row_step_m = azimuth.step_m * frame.along;
  grid.column_step_m = range.step_m * frame.across;
  grid.rows = azimuth.count;
  grid.columns = range.count;
  if (!ground_m || frame.plane != ImagePlane::slant_range) return grid;
  core::Vec3 scene_m = frame.origin_m + range.at(0.5 * static_cast<double>(range.count)) * frame.across;
  scene_m.z = *ground_m;
  const GroundSight sight({0.0, frame.origin_m, frame.along}, scene_m, 0.0);
  grid.curved = [frame, azimuth, range, sight](double row, double column) {
    return sight.point_at(frame.origin_m + azimuth.at(row) * frame.along, range.at(column));
  };
  return grid;
}

std::vector<std::complex<float>> back_project(const SarEchoes& echoes, const PointGrid& grid,
                                              const BackProjectionOptions& options, const core::WorkControl& control,
                                              const core::ProgressReport& progress) {
  expect_sound(echoes, options);
  Sums sums;
  sums.values.resize(grid.rows * grid.columns);
  if (options.aperture != BackProjectionOptions::Aperture::all) sums.weights.resize(sums.values.size());
  if (sums.values.empty() || echoes.volts.empty()) return sums.values;

  const std::size_t pulses = echoes.track.size();
  const std::size_t pulse_bytes = EchoRecords::factor * EchoRecords::floats * sizeof(float) * echoes.samples;
  const std::size_t block = std::min(pulses, std::clamp<std::size_t>(block_bytes / pulse_bytes, 4, longest_block));
  EchoRecords records(echoes, options.range_window, block);
  ProjectionConstants constants = constants_of(echoes, options);
  constants.record_count = records.count();
  const ProjectionAperture aperture = aperture_of(options);
  const Tiles tiles(grid);
  const std::vector<Stretch> stretches = stretches_of(tiles, echoes, control);

  std::vector<ProjectionPulse> together;
  for (std::size_t first = 0; first < pulses; first += block) {
    const std::size_t count = std::min(block, pulses - first);
    records.fill(first, count, control);
    together.clear();
    for (std::size_t i = 0; i < count; ++i)
      together.push_back({echoes.track[first + i].position_m, echoes.track[first + i].velocity_mps, records.at(i),
                          echoes.carriers_hz.empty() ? 0.0 : echoes.carriers_hz[first + i]});
    core::parallel_ranges(tiles.count(), 1, control, [&](std::size_t begin, std::size_t end) {
      const auto tile = std::make_unique<ProjectionTile>();
      for (std::size_t index = begin; index < end; ++index) {
        tiles.place(index, *tile);
        load(sums, tiles, index, grid.columns, *tile);
        project(together, constants, aperture, stretches[index], *tile);
        store(*tile, tiles, index, grid.columns, sums);
      }
    });
    if (progress) progress({first + count, pulses, sums.values.size()});
  }
  normalize(sums, pulses);
  return std::move(sums.values);
}

FocusedImage back_project(const SarEchoes& echoes, const ImageFrame& frame, const ImageAxis& azimuth,
                          const ImageAxis& range, const BackProjectionOptions& options,
                          const core::WorkControl& control, const core::ProgressReport& progress) {
  const PointGrid grid = points_of(frame, azimuth, range, options.ground_m);
  FocusedImage image;
  image.frame = frame;
  image.azimuth = azimuth;
  image.range = range;
  image.carrier_hz = echoes.waveform.carrier_hz;
  image.light_speed_mps = echoes.waveform.light_speed_mps;
  image.values = back_project(echoes, grid, options, control, progress);
  ReferenceTrack line = fitted_track(echoes.track);
  if (frame.plane == ImagePlane::slant_range) line = {0.0, frame.origin_m, frame.along};
  const double turns_per_m = radar::turns_per_m(echoes.waveform.carrier_hz, echoes.waveform.light_speed_mps);
  core::parallel_ranges(grid.rows, 16, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < grid.columns; ++column) {
        const core::Vec3 point_m = grid.at(static_cast<double>(row), static_cast<double>(column));
        const double turns = turns_per_m * distance_from(line, point_m);
        image.values[row * grid.columns + column] *= std::complex<float>(core::turned_exactly(-turns));
      }
  });
  return image;
}

}  // namespace sarsim::signal
