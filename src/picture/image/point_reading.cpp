#include "picture/image/point_reading.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"

namespace sarsim::picture {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t chip = 32;
constexpr std::size_t finer = 16;
constexpr std::size_t cut_samples = 128;
constexpr double null_widths = 10.0;

// Samples of a plane around a place, 0 outside and for what is not a number.
struct Patch {
  std::size_t rows = 0;
  std::size_t cols = 0;
  std::vector<Complex> samples;

  [[nodiscard]] Complex& at(std::size_t row, std::size_t col) { return samples[row * cols + col]; }
  [[nodiscard]] const Complex& at(std::size_t row, std::size_t col) const { return samples[row * cols + col]; }
};

struct CutExtent {
  std::size_t first = 0;  // In the plane.
  std::size_t count = 0;
  std::size_t skipped = 0;  // Of the patch, before the plane begins.
};

CutExtent extent_of(std::size_t centre, std::size_t count, std::size_t size) {
  const std::size_t half = count / 2;
  const std::size_t skipped = half > centre ? half - centre : 0;
  const std::size_t first = centre - (half - skipped);
  return {first, std::min(count - skipped, size - first), skipped};
}

// Sample (row, column) of the plane is sample (rows / 2, cols / 2) of the patch.
Patch patch_of(const raster::Raster& plane, std::size_t row, std::size_t column, std::size_t rows, std::size_t cols) {
  Patch patch{rows, cols, std::vector<Complex>(rows * cols)};
  const CutExtent down = extent_of(row, rows, plane.rows());
  const CutExtent across = extent_of(column, cols, plane.columns());
  const raster::ImageWindow window{down.first, down.count, across.first, across.count};
  std::vector<std::complex<float>> read(window.samples());
  plane.read_window(window, read);
  for (std::size_t i = 0; i < down.count; ++i)
    for (std::size_t k = 0; k < across.count; ++k) {
      const Complex sample(read[i * across.count + k]);
      if (std::isfinite(sample.real()) && std::isfinite(sample.imag()))
        patch.at(down.skipped + i, across.skipped + k) = sample;
    }
  return patch;
}

// Radians from sample to sample at the centroid of the spectrum: the phase of the autocorrelation at lag 1.
struct Centroid {
  double down = 0.0;
  double across = 0.0;
};

Centroid centroid_of(const Patch& patch) {
  Complex down = 0.0;
  Complex across = 0.0;
  for (std::size_t i = 0; i < patch.rows; ++i)
    for (std::size_t k = 0; k < patch.cols; ++k) {
      if (i + 1 < patch.rows) down += patch.at(i + 1, k) * std::conj(patch.at(i, k));
      if (k + 1 < patch.cols) across += patch.at(i, k + 1) * std::conj(patch.at(i, k));
    }
  return {std::arg(down), std::arg(across)};
}

// Turns the spectrum's centroid to 0, with the phase of the patch's middle kept.
void remove(const Centroid& centroid, Patch& patch) {
  for (std::size_t i = 0; i < patch.rows; ++i)
    for (std::size_t k = 0; k < patch.cols; ++k) {
      const double y = static_cast<double>(i) - static_cast<double>(patch.rows / 2);
      const double x = static_cast<double>(k) - static_cast<double>(patch.cols / 2);
      patch.at(i, k) *= std::polar(1.0, -centroid.down * y - centroid.across * x);
    }
}

// A line with `finer` times as many samples: its spectrum padded with zeros, the middle bin shared by both sides.
std::vector<Complex> refined(std::vector<Complex> line, const core::Fft& coarse, const core::Fft& fine) {
  const std::size_t size = line.size();
  coarse.forward(line);
  std::vector<Complex> result(size * finer);
  const double scale = 1.0 / static_cast<double>(size);
  for (std::size_t k = 0; k < size / 2; ++k) result[k] = line[k] * scale;
  for (std::size_t k = size / 2 + 1; k < size; ++k) result[result.size() - size + k] = line[k] * scale;
  result[size / 2] = result[result.size() - size / 2] = 0.5 * scale * line[size / 2];
  fine.inverse(result);
  return result;
}

// Both directions of a square patch.
Patch refined(const Patch& patch) {
  const core::Fft coarse(patch.cols);
  const core::Fft fine(patch.cols * finer);
  Patch wide{patch.rows, patch.cols * finer, {}};
  for (std::size_t i = 0; i < patch.rows; ++i) {
    const auto line = std::span(patch.samples).subspan(i * patch.cols, patch.cols);
    const auto more = refined(std::vector<Complex>(line.begin(), line.end()), coarse, fine);
    wide.samples.insert(wide.samples.end(), more.begin(), more.end());
  }
  Patch result{patch.rows * finer, wide.cols, std::vector<Complex>(patch.rows * finer * wide.cols)};
  std::vector<Complex> line(patch.rows);
  for (std::size_t k = 0; k < wide.cols; ++k) {
    for (std::size_t i = 0; i < wide.rows; ++i) line[i] = wide.at(i, k);
    const auto more = refined(line, coarse, fine);
    for (std::size_t i = 0; i < result.rows; ++i) result.at(i, k) = more[i];
  }
  return result;
}

// Offset of a parabola's top from the middle one of three values, -1/2 to 1/2.
double top_of(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

struct ChipPlace {
  double row = 0.0;  // In samples of the patch.
  double col = 0.0;
};

// The largest interpolated value within a sample and a half of the middle.
ChipPlace peak_of(const Patch& fine) {
  const std::size_t middle = chip / 2 * finer;
  const std::size_t around = 3 * finer / 2;
  std::size_t row = middle;
  std::size_t col = middle;
  for (std::size_t i = middle - around; i <= middle + around; ++i)
    for (std::size_t k = middle - around; k <= middle + around; ++k)
      if (std::norm(fine.at(i, k)) > std::norm(fine.at(row, col))) {
        row = i;
        col = k;
      }
  const auto power = [&](std::size_t i, std::size_t k) { return std::norm(fine.at(i, k)); };
  const double down = top_of(power(row - 1, col), power(row, col), power(row + 1, col));
  const double across = top_of(power(row, col - 1), power(row, col), power(row, col + 1));
  return {(static_cast<double>(row) + down) / finer, (static_cast<double>(col) + across) / finer};
}

// Weights of `size` samples (even) for the value at a place between them: what padding with zeros gives there, the
// Dirichlet kernel sin(pi d)/(size tan(pi d/size)).
std::vector<double> weights_at(double place, std::size_t size) {
  std::vector<double> weights(size);
  for (std::size_t n = 0; n < size; ++n) {
    const double distance = place - static_cast<double>(n);
    const double tangent = std::tan(core::pi * distance / static_cast<double>(size));
    weights[n] =
        std::abs(tangent) < 1e-12 ? 1.0 : std::sin(core::pi * distance) / (static_cast<double>(size) * tangent);
  }
  return weights;
}

// Fine powers along a line and where its peak is.
struct Cut {
  std::vector<double> power;
  std::size_t peak = 0;
};

Cut cut_of(const std::vector<Complex>& line, double near) {
  const auto fine = refined(line, core::Fft(line.size()), core::Fft(line.size() * finer));
  Cut result;
  result.power.reserve(fine.size());
  for (const Complex& value : fine) result.power.push_back(std::norm(value));
  result.peak = static_cast<std::size_t>(std::lround(near * finer));
  const auto better = [&](std::size_t i) { return result.power[i] > result.power[result.peak]; };
  while (better(result.peak + 1)) ++result.peak;
  while (better(result.peak - 1)) --result.peak;
  return result;
}

// Steps from the peak to half its power, interpolated; `step` is +1 or -1.
std::optional<double> half_power(const Cut& line, int step) {
  const double half = 0.5 * line.power[line.peak];
  const auto at = [&](std::size_t i) {
    return line.power[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(line.peak) + step * static_cast<int>(i))];
  };
  const std::size_t most = cut_samples / 2 * finer - 2 * finer;
  for (std::size_t i = 1; i < most; ++i)
    if (at(i) <= half) return static_cast<double>(i - 1) + (at(i - 1) - half) / (at(i - 1) - at(i));
  return std::nullopt;
}

// Steps from the peak to the first minimum below half its power.
std::optional<std::size_t> first_minimum(const Cut& line, int step) {
  const auto at = [&](std::size_t i) {
    return line.power[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(line.peak) + step * static_cast<int>(i))];
  };
  const std::size_t most = cut_samples / 2 * finer - 2 * finer;
  for (std::size_t i = 1; i + 1 < most; ++i)
    if (at(i) < 0.5 * at(0) && at(i) <= at(i + 1)) return i;
  return std::nullopt;
}

std::optional<CutReading> measure(const Cut& line) {
  const auto left_half = half_power(line, -1);
  const auto right_half = half_power(line, 1);
  const auto left = first_minimum(line, -1);
  const auto right = first_minimum(line, 1);
  if (!left_half || !right_half || !left || !right) return std::nullopt;
  CutReading reading;
  reading.width = (*left_half + *right_half) / finer;
  reading.null = 0.5 * static_cast<double>(*left + *right) / finer;
  const double edge = cut_samples / 2.0 - 2.0;  // What is nearer to the ends is spoilt by the cut itself.
  reading.reach = std::min(null_widths * reading.null, edge);
  const auto reach = static_cast<std::ptrdiff_t>(std::lround(reading.reach * finer));
  double inside = 0.0;
  double outside = 0.0;
  double highest = 0.0;
  for (std::ptrdiff_t i = -reach; i <= reach; ++i) {
    const double power = line.power[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(line.peak) + i)];
    if (i >= -static_cast<std::ptrdiff_t>(*left) && i <= static_cast<std::ptrdiff_t>(*right)) {
      inside += power;
      continue;
    }
    outside += power;
    highest = std::max(highest, power);
  }
  // A response without any sidelobe has a ratio of minus infinity; a finite floor is kinder to tables.
  constexpr double floor = 1e-30;
  reading.pslr_db = 10.0 * std::log10(std::max(highest / line.power[line.peak], floor));
  reading.islr_db = 10.0 * std::log10(std::max(outside / inside, floor));
  return reading;
}

struct SamplePlace {
  std::size_t row = 0;
  std::size_t column = 0;

  friend bool operator==(const SamplePlace&, const SamplePlace&) = default;
};

// The largest sample so far around a place; nothing where there are zeros alone.
std::optional<SamplePlace> largest_around(const raster::Raster& plane, SamplePlace at, std::size_t rows,
                                          std::size_t columns) {
  const std::size_t down = 2 * rows + 1;
  const std::size_t across = 2 * columns + 1;
  const Patch near = patch_of(plane, at.row, at.column, down, across);
  const auto largest = std::ranges::max_element(near.samples, {}, [](const Complex& z) { return std::norm(z); });
  if (std::norm(*largest) == 0.0) return std::nullopt;
  const auto index = static_cast<std::size_t>(largest - near.samples.begin());
  return SamplePlace{at.row + index / across - rows, at.column + index % across - columns};
}

// The largest sample at the edge of what is searched may stand on the slope of a larger one.
std::optional<SamplePlace> summit_near(const raster::Raster& plane, SamplePlace at, const PointOptions& options) {
  constexpr std::size_t most = 1024;
  constexpr int max_steps = 256;
  auto summit = largest_around(plane, at, std::min(options.search_rows, most), std::min(options.search_columns, most));
  for (int step = 0; summit && step < max_steps; ++step) {
    const auto higher = largest_around(plane, *summit, 1, 1);
    if (higher == summit) break;
    summit = higher;
  }
  return summit;
}

core::Problem no_point(const std::string& message, std::size_t row, std::size_t column, const std::string& hint = {}) {
  return core::error(message).found(fmt::format("row {}, column {}", row, column)).hint(hint);
}

}  // namespace

std::variant<PointReading, core::Problem> read_point(const raster::Raster& plane, std::size_t row, std::size_t column,
                                                     const PointOptions& options) {
  if (row >= plane.rows() || column >= plane.columns()) return no_point("the point is outside the image", row, column);
  const auto found = summit_near(plane, {row, column}, options);
  if (!found) return no_point("all samples there are zero", row, column);
  const std::size_t peak_row = found->row;
  const std::size_t peak_col = found->column;

  Patch centred = patch_of(plane, peak_row, peak_col, chip, chip);
  const Centroid centroid = centroid_of(centred);
  remove(centroid, centred);
  const ChipPlace peak = peak_of(refined(centred));
  const std::vector<double> down = weights_at(peak.row, chip);
  const std::vector<double> across = weights_at(peak.col, chip);
  PointReading reading;
  for (std::size_t i = 0; i < chip; ++i)
    for (std::size_t k = 0; k < chip; ++k) reading.value += down[i] * across[k] * centred.at(i, k);
  const double off_row = peak.row - chip / 2.0;
  const double off_col = peak.col - chip / 2.0;
  reading.value *= std::polar(1.0, centroid.down * off_row + centroid.across * off_col);
  reading.row = static_cast<double>(peak_row) + off_row;
  reading.column = static_cast<double>(peak_col) + off_col;

  Patch wide = patch_of(plane, peak_row, peak_col, chip, cut_samples);
  Patch tall = patch_of(plane, peak_row, peak_col, cut_samples, chip);
  remove(centroid, wide);
  remove(centroid, tall);
  std::vector<Complex> along_row(cut_samples);
  std::vector<Complex> along_column(cut_samples);
  for (std::size_t i = 0; i < chip; ++i)
    for (std::size_t k = 0; k < cut_samples; ++k) {
      along_row[k] += down[i] * wide.at(i, k);
      along_column[k] += across[i] * tall.at(k, i);
    }
  const auto row_cut = measure(cut_of(along_row, cut_samples / 2.0 + off_col));
  const auto column_cut = measure(cut_of(along_column, cut_samples / 2.0 + off_row));
  if (!row_cut || !column_cut)
    return no_point("the response has no main lobe with a minimum on both sides", peak_row, peak_col,
                    "choose an isolated point");
  reading.along_row = *row_cut;
  reading.along_column = *column_cut;
  return reading;
}

}  // namespace sarsim::picture
