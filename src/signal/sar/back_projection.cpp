#include "signal/sar/back_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/row/smooth_row.hpp"
#include "signal/sar/back_projection_kernel.hpp"
#include "signal/sar/echo_records.hpp"
#include "signal/sar/ground_sight.hpp"
#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

namespace {

// The rectangles in which a grid is computed, in bands of whole rows of the grid. The columns of a tile run along
// those of the grid or, if distances from the antenna change less that way, along its rows. On a curved surface the
// points of each stretch of a tile follow from a bicubic polynomial within 1e-4 of a wavelength of the surface; where
// no stretch is accurate enough, as directly below a track, each point is computed by itself.
class ProjectionTiles {
 public:
  static constexpr std::size_t points = ProjectionTile::rows * ProjectionTile::columns;

  // Keeps a reference to the grid.
  // @throw  Interrupted
  ProjectionTiles(const PointGrid& grid, const SarEchoes& echoes, const core::WorkControl& control);

  [[nodiscard]] std::size_t count() const { return across_ * down_; }
  [[nodiscard]] std::size_t first_row(std::size_t tile) const { return tile / across_ * high_; }
  [[nodiscard]] std::size_t first_column(std::size_t tile) const { return tile % across_ * wide_; }
  // Rows of the grid in a tile.
  [[nodiscard]] std::size_t rows(std::size_t tile) const;
  // Columns of the grid in a tile.
  [[nodiscard]] std::size_t columns(std::size_t tile) const;
  [[nodiscard]] std::size_t tiles_of_band() const { return across_; }
  // Index in a tile of the point of a row and a column of the grid, counted from the tile's first ones.
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const {
    return turned_ ? column * ProjectionTile::columns + row : row * ProjectionTile::columns + column;
  }
  [[nodiscard]] Stretch stretch(std::size_t tile) const { return plans_[tile].stretch; }

  // Gives a tile its points.
  // @param points_m  storage for points that are computed one by one; must outlive the tile
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

// Records of the pulses that are projected together; more than one core's cache is no use.
constexpr std::size_t block_bytes = std::size_t{4} << 20;
constexpr std::size_t longest_block = 128;

void expect_sound(const SarEchoes& echoes, const BackProjectionOptions& options) {
  core::expect(echoes.volts.size() == echoes.track.size() * echoes.samples,
               "back-projection: the number of samples is not pulses times samples of a pulse");
  core::expect(echoes.carriers_hz.empty() || echoes.carriers_hz.size() == echoes.track.size(),
               "back-projection: the number of carriers is not that of the pulses");
  const std::size_t pulses = echoes.track.size();
  core::expect(echoes.later_s.empty() || echoes.later_s.size() == pulses,
               "back-projection: the number of first samples is not that of the pulses");
  core::expect(echoes.receivers_m.empty() || echoes.receivers_m.size() == pulses,
               "back-projection: the number of receivers is not that of the pulses");
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

ProjectionPulse pulse_of(const SarEchoes& echoes, std::size_t number, const float* records) {
  ProjectionPulse pulse{echoes.track[number].position_m, echoes.track[number].velocity_mps, records};
  if (!echoes.carriers_hz.empty()) pulse.carrier_hz = echoes.carriers_hz[number];
  if (!echoes.later_s.empty()) pulse.later_s = echoes.later_s[number];
  pulse.bistatic = !echoes.receivers_m.empty();
  if (pulse.bistatic) pulse.receiver_m = echoes.receivers_m[number];
  return pulse;
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

core::Vec3 middle_of(const PointGrid& grid) {
  const double row = 0.5 * static_cast<double>(grid.rows - 1);
  const double column = 0.5 * static_cast<double>(grid.columns - 1);
  if (grid.curved) return grid.curved(row, column);
  return grid.origin_m + row * grid.row_step_m + column * grid.column_step_m;
}

// Over what compression keeps of a chirp from the middle of the grid, pulse by pulse.
std::vector<float> gains_of(const SarEchoes& echoes, const PointGrid& grid, const BackProjectionOptions& options) {
  std::vector<float> gains;
  const SarWaveform& wave = echoes.waveform;
  if (options.start_stop || !(wave.pulse_width_s > 0.0) || wave.bandwidth_hz == 0.0) return gains;
  const core::Vec3 middle_m = middle_of(grid);
  gains.reserve(echoes.track.size());
  for (std::size_t p = 0; p < echoes.track.size(); ++p) {
    const core::Vec3 sight_m = middle_m - echoes.track[p].position_m;
    const double closing_mps = core::dot(sight_m, echoes.track[p].velocity_mps) / std::max(core::norm(sight_m), 1e-9);
    const double carrier_hz = echoes.carriers_hz.empty() ? wave.carrier_hz : echoes.carriers_hz[p];
    const double doppler_hz = radar::turns_of(closing_mps, carrier_hz, wave.light_speed_mps);
    gains.push_back(static_cast<float>(1.0 / overlap_of(wave, doppler_hz)));
  }
  return gains;
}

// Sums of all points while the pulses are worked through: those of a tile stand together, real parts first.
struct Sums {
  std::vector<std::complex<float>> values;
  std::vector<float> weights;  // empty where all pulses count

  void load(std::size_t index, ProjectionTile& tile) const {
    const auto* from = reinterpret_cast<const float*>(values.data() + index * ProjectionTiles::points);
    std::copy_n(from, ProjectionTiles::points, tile.re.begin());
    std::copy_n(from + ProjectionTiles::points, ProjectionTiles::points, tile.im.begin());
    if (!weights.empty())
      std::copy_n(weights.data() + index * ProjectionTiles::points, ProjectionTiles::points, tile.weight.begin());
  }
  void store(const ProjectionTile& tile, std::size_t index) {
    auto* to = reinterpret_cast<float*>(values.data() + index * ProjectionTiles::points);
    std::ranges::copy(tile.re, to);
    std::ranges::copy(tile.im, to + ProjectionTiles::points);
    if (!weights.empty()) std::ranges::copy(tile.weight, weights.data() + index * ProjectionTiles::points);
  }
};

// The mean values of the points of a tile, among those of the rows of its band.
void normalize(const ProjectionTile& tile, const ProjectionTiles& tiles, std::size_t index, std::size_t columns,
               std::optional<float> share, std::span<std::complex<float>> band) {
  for (std::size_t row = 0; row < tiles.rows(index); ++row) {
    std::complex<float>* out = band.data() + row * columns + tiles.first_column(index);
    for (std::size_t column = 0; column < tiles.columns(index); ++column) {
      const std::size_t at = tiles.at(row, column);
      const float by = share ? *share : tile.weight[at] != 0.0F ? 1.0F / tile.weight[at] : 0.0F;
      out[column] = {by * tile.re[at], by * tile.im[at]};
    }
  }
}

// The mean values of all points, in the order of the grid. Rows take no more room than their tiles, so that those of a
// band can be written over what has been read.
std::vector<std::complex<float>> mean_values(Sums sums, const ProjectionTiles& tiles, const PointGrid& grid,
                                             std::size_t pulses) {
  std::optional<float> share;
  if (sums.weights.empty()) share = 1.0F / static_cast<float>(pulses);
  const auto tile = std::make_unique<ProjectionTile>();
  std::vector<std::complex<float>> band;
  auto out = sums.values.begin();
  for (std::size_t first = 0; first < tiles.count(); first += tiles.tiles_of_band()) {
    band.resize(tiles.rows(first) * grid.columns);
    for (std::size_t index = first; index < first + tiles.tiles_of_band(); ++index) {
      sums.load(index, *tile);
      normalize(*tile, tiles, index, grid.columns, share, band);
    }
    out = std::ranges::copy(band, out).out;
  }
  sums.values.resize(grid.rows * grid.columns);
  return std::move(sums.values);
}

// No point is at a distance of 0 or less from the line.
void clear_before_line(FocusedImage& image) {
  for (std::size_t column = 0; column < image.range.count; ++column) {
    if (image.range.at(static_cast<double>(column)) > 0.0) continue;
    for (std::size_t row = 0; row < image.azimuth.count; ++row) image.values[row * image.range.count + column] = {};
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
  const std::size_t points = grid.rows * grid.columns;
  if (points == 0 || echoes.volts.empty()) return std::vector<std::complex<float>>(points);
  const ProjectionTiles tiles(grid, echoes, control);
  Sums sums{std::vector<std::complex<float>>(tiles.count() * ProjectionTiles::points), {}};
  if (options.aperture != BackProjectionOptions::Aperture::all) sums.weights.resize(sums.values.size());
  const std::size_t pulses = echoes.track.size();
  const std::size_t pulse_bytes = EchoRecords::factor * EchoRecords::floats * sizeof(float) * echoes.samples;
  const std::size_t block = std::min(pulses, std::clamp<std::size_t>(block_bytes / pulse_bytes, 4, longest_block));
  EchoRecords records(echoes, options.range_window, block, gains_of(echoes, grid, options));
  ProjectionConstants constants = constants_of(echoes, options);
  constants.record_count = records.count();
  const ProjectionAperture aperture = aperture_of(options);

  std::vector<ProjectionPulse> together;
  for (std::size_t first = 0; first < pulses; first += block) {
    const std::size_t count = std::min(block, pulses - first);
    records.fill(first, count, control);
    together.clear();
    for (std::size_t i = 0; i < count; ++i) together.push_back(pulse_of(echoes, first + i, records.at(i)));
    core::parallel_ranges(tiles.count(), 1, control, [&](std::size_t begin, std::size_t end) {
      const auto tile = std::make_unique<ProjectionTile>();
      std::vector<core::Vec3> points_m;
      for (std::size_t index = begin; index < end; ++index) {
        tiles.place(index, *tile, points_m);
        sums.load(index, *tile);
        project(together, constants, aperture, tiles.stretch(index), *tile);
        sums.store(*tile, index);
      }
    });
    if (progress) progress({first + count, pulses, points});
  }
  return mean_values(std::move(sums), tiles, grid, pulses);
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
  turn_to_baseband(image, grid, line, control);
  if (frame.plane == ImagePlane::slant_range) clear_before_line(image);
  return image;
}

void turn_to_baseband(FocusedImage& image, const PointGrid& grid, const ReferenceTrack& line,
                      const core::WorkControl& control) {
  CORE_EXPECT(image.values.size() == grid.rows * grid.columns);
  const double turns_per_m = radar::turns_per_m(image.carrier_hz, image.light_speed_mps);
  core::parallel_ranges(grid.rows, 16, control, [&](std::size_t begin, std::size_t end) {
    std::vector<float> turns(grid.columns);
    for (std::size_t row = begin; row < end; ++row) {
      const auto turns_at = [&](double column) {
        return -turns_per_m * distance_from(line, grid.at(static_cast<double>(row), column));
      };
      sample_turns(knots_of(grid.columns, turns_at), turns_at, turns);
      turn_row(std::span(image.values).subspan(row * grid.columns, grid.columns), turns);
    }
  });
}

}  // namespace sarsim::signal
