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
#include "signal/sar/projection_tiles.hpp"
#include "signal/sar/reference_track.hpp"

namespace sarsim::signal {

namespace {

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
