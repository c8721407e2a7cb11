#include "picture/live/live_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "picture/colour/decibel_levels.hpp"
#include "picture/colour/display_quantity.hpp"

namespace sarsim::picture {

namespace {

constexpr float silence_db = -400.0F;

LiveAxis axis_of(const raster::ImagePlaces& places, std::size_t samples, std::size_t pixels) {
  const double end = places.first + places.step * (static_cast<double>(samples) - 0.5);
  return {places.label, places.unit, places.first - 0.5 * places.step, end, std::min(samples, pixels)};
}

// First sample of a pixel.
std::size_t begin_of(std::size_t pixel, std::size_t samples, std::size_t pixels) { return pixel * samples / pixels; }

// Largest powers of the samples of each pixel of a row.
void raise(std::span<const std::complex<float>> samples, std::span<float> pixels) {
  std::size_t k = 0;
  for (std::size_t p = 0; p < pixels.size(); ++p) {
    float largest = pixels[p];
    for (const std::size_t end = begin_of(p + 1, samples.size(), pixels.size()); k < end; ++k) {
      const float i = samples[k].real();
      const float q = samples[k].imag();
      largest = std::max(largest, i * i + q * q);
    }
    pixels[p] = largest;
  }
}

float decibels(float magnitude_v, float reference_v) {
  return magnitude_v > 0.0F && reference_v > 0.0F ? 20.0F * std::log10(magnitude_v / reference_v) : silence_db;
}

FigureAxis figure_axis(const LiveAxis& axis) {
  FigureAxis shown;
  shown.label = axis.label;
  shown.unit = axis.unit;
  shown.first = std::min(axis.first, axis.last);
  shown.last = std::max(axis.first, axis.last);
  return shown;
}

// The axes, and colours of values, in decibels.
// @param level  of a pixel in the table
template <class LevelOf>
FigurePanel panel_of(const LiveImage& image, const LevelOf& level, const char* meaning, const ColourLimits& limits,
                     ColourMap map, const std::vector<raster::Rgb>& table) {
  FigurePanel panel;
  panel.x = figure_axis(image.columns);
  panel.y = figure_axis(image.rows);
  if (image.columns.unit == "m" && image.rows.unit == "m") panel.y_per_x = 1.0;
  FigureImage cells{image.columns.count,
                    image.rows.count,
                    image.columns.first,
                    image.columns.last,
                    image.rows.first,
                    image.rows.last,
                    {}};
  cells.cells.reserve(image.magnitude_v.size());
  for (std::size_t i = 0; i < image.magnitude_v.size(); ++i) cells.cells.push_back(table[level(i)]);
  panel.image = std::move(cells);
  panel.colour_bar = FigureColourBar{meaning, "dB", limits.low, limits.high, table, info_of(map).kind};
  return panel;
}

FigurePanel curve_of(const LiveImage& image, std::span<const float> values, double span_db) {
  FigurePanel panel;
  panel.x = figure_axis(image.columns);
  panel.y.label = "Power";
  panel.y.unit = "dB";
  panel.y.first = -span_db;
  panel.y.last = 0.0;
  FigureCurve curve;
  const double step = (image.columns.last - image.columns.first) / static_cast<double>(image.columns.count);
  for (std::size_t k = 0; k < values.size(); ++k) {
    curve.x.push_back(image.columns.first + (static_cast<double>(k) + 0.5) * step);
    curve.y.push_back(std::max(static_cast<double>(values[k]), -span_db));
  }
  panel.curves.push_back(std::move(curve));
  return panel;
}

// Pixel of an axis at a place; nothing outside.
std::optional<std::size_t> pixel_at(const LiveAxis& axis, double place) {
  const double share = (place - axis.first) / (axis.last - axis.first);
  if (!(share >= 0.0 && share < 1.0)) return std::nullopt;
  return std::min(static_cast<std::size_t>(share * static_cast<double>(axis.count)), axis.count - 1);
}

double place_of(const LiveAxis& axis, std::size_t pixel) {
  return axis.first + (axis.last - axis.first) * (static_cast<double>(pixel) + 0.5) / static_cast<double>(axis.count);
}

}  // namespace

LiveImage live_image(const core::SampleRows<float>& samples, const raster::FocusedPlaces& places, const PlotSize& size,
                     const core::WorkControl& control) {
  LiveImage image;
  image.rows = axis_of(places.azimuth, samples.rows, std::max<std::size_t>(size.height_px, 1));
  image.columns = axis_of(places.range, samples.columns, std::max<std::size_t>(size.width_px, 1));
  const std::size_t height = image.rows.count;
  const std::size_t width = image.columns.count;
  image.magnitude_v.assign(height * width, 0.0F);
  constexpr std::size_t grain = 8;
  core::parallel_ranges(height, grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<float>> row(samples.columns);
    for (std::size_t p = begin; p < end; ++p) {
      const auto pixels = std::span(image.magnitude_v).subspan(p * width, width);
      for (std::size_t r = begin_of(p, samples.rows, height); r < begin_of(p + 1, samples.rows, height); ++r) {
        samples.read(r, row);
        raise(row, pixels);
      }
      for (float& pixel : pixels) pixel = std::sqrt(pixel);
    }
  });
  if (!image.magnitude_v.empty()) image.largest_v = *std::ranges::max_element(image.magnitude_v);
  return image;
}

Figure live_figure(const LiveImage& image, const LiveLook& look) { return live_figure(image, look, image.largest_v); }

Figure live_figure(const LiveImage& image, const LiveLook& look, float reference_v) {
  Figure figure;
  if (image.rows.count == 1) {
    std::vector<float> values(image.magnitude_v.size());
    std::ranges::transform(image.magnitude_v, values.begin(), [&](float v) { return decibels(v, reference_v); });
    figure.panels.push_back(curve_of(image, values, look.span_db));
  } else {
    const ColourLimits limits{-look.span_db, 0.0};
    const std::vector<raster::Rgb> table = colour_table(look.map);
    const DecibelLevels levels(reference_v, limits, table.size());
    const auto level = [&](std::size_t i) { return levels(image.magnitude_v[i]); };
    figure.panels.push_back(panel_of(image, level, "Below the largest", limits, look.map, table));
  }
  add_rings(figure, image.targets);
  return figure;
}

void add_rings(Figure& figure, const std::vector<LiveImage::TargetPlace>& places) {
  for (const LiveImage::TargetPlace& place : places)
    figure.panels.front().marks.push_back({place.column, place.row, {}, true});
}

std::vector<float> difference_db(const LiveImage& before, const LiveImage& after, double span_db) {
  const float reference_v = std::max(before.largest_v, after.largest_v);
  const auto floor_db = static_cast<float>(-span_db);
  const auto floor_v = static_cast<float>(static_cast<double>(reference_v) * std::pow(10.0, -span_db / 20.0));
  const auto level_db = [&](float v) { return v > floor_v ? std::max(decibels(v, reference_v), floor_db) : floor_db; };
  std::vector<std::optional<std::size_t>> columns;
  for (std::size_t k = 0; k < after.columns.count; ++k)
    columns.push_back(pixel_at(before.columns, place_of(after.columns, k)));
  std::vector<float> difference;
  difference.reserve(after.magnitude_v.size());
  for (std::size_t r = 0; r < after.rows.count; ++r) {
    const auto row = pixel_at(before.rows, place_of(after.rows, r));
    for (std::size_t k = 0; k < after.columns.count; ++k) {
      const float old_v = row && columns[k] ? before.magnitude_v[*row * before.columns.count + *columns[k]] : 0.0F;
      const float new_v = after.magnitude_v[r * after.columns.count + k];
      difference.push_back(level_db(new_v) - level_db(old_v));
    }
  }
  return difference;
}

Figure difference_figure(const LiveImage& before, const LiveImage& after, const LiveLook& look) {
  const std::vector<float> values = difference_db(before, after, look.span_db);
  const double max_db = 0.5 * look.span_db;
  Figure figure;
  if (after.rows.count == 1) {
    figure.panels.push_back(curve_of(after, values, look.span_db));
    figure.panels.back().y.label = "Difference";
    figure.panels.back().y.last = look.span_db;
  } else {
    const ColourLimits limits{-max_db, max_db};
    const std::vector<raster::Rgb> table = colour_table(ColourMap::balance);
    const auto level = [&](std::size_t i) {
      return colour_index(static_cast<double>(values[i]), limits, table.size());
    };
    figure.panels.push_back(panel_of(after, level, "Change", limits, ColourMap::balance, table));
  }
  return figure;
}

}  // namespace sarsim::picture
