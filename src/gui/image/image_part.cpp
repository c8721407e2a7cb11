#include "gui/image/image_part.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace sarsim::gui {

namespace {

constexpr double min_span = 2.0;
constexpr double max_span = 4.0;  // times the image
constexpr double margin = 0.25;

QRgb pixel(raster::Rgb colour) { return qRgb(colour.red, colour.green, colour.blue); }

// Beginning, number and spacing of the samples of one direction.
struct Places {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t step = 1;
};

Places places(double from, double to, std::size_t pixels, std::size_t size, bool peak) {
  const double span = to - from;
  const double ratio = span / static_cast<double>(std::max<std::size_t>(pixels, 1));
  Places result;
  // More of them than pixels would not all be drawn; of peaks none may get lost.
  result.step = std::max<std::size_t>(1, static_cast<std::size_t>(peak ? std::ceil(ratio) : ratio));
  const auto step = static_cast<double>(result.step);
  const double low = std::max(0.0, std::floor((from - margin * span) / step));
  const double last = std::floor((static_cast<double>(size) - 1.0) / step);
  const double high = std::min(last, std::ceil((to + margin * span) / step));
  if (size == 0 || high < low) return result;
  result.first = static_cast<std::size_t>(low) * result.step;
  result.count = static_cast<std::size_t>(high - low) + 1;
  return result;
}

std::pair<double, double> mended_span(double from, double to, std::size_t size) {
  const auto length = static_cast<double>(std::max<std::size_t>(size, 1));
  if (!std::isfinite(from) || !std::isfinite(to)) return {-0.5, length - 0.5};
  if (to < from) std::swap(from, to);
  const double middle = std::clamp((from + to) / 2.0, -0.5, length - 0.5);
  const double half = std::clamp(to - from, std::min(min_span, length), std::max(max_span * length, min_span)) / 2.0;
  return {middle - half, middle + half};
}

// The samples that colours are made from: powers become magnitudes where decibels are wanted.
std::vector<std::complex<double>> shown_samples(const ImagePart& part, picture::DisplayQuantity quantity) {
  std::vector<std::complex<double>> samples = part.samples;
  if (part.value == raster::ImageValue::power && quantity == picture::DisplayQuantity::decibels)
    for (std::complex<double>& s : samples) s = std::sqrt(std::max(s.real(), 0.0));
  return samples;
}

// Rows and columns of a part that a view shows.
struct Seen {
  std::size_t row = 0, rows = 0, column = 0, columns = 0;
};

Seen seen_of(const raster::ImageWindow& window, const ImageView& view) {
  const auto span = [](double from, double to, std::size_t first, std::size_t step, std::size_t count,
                       std::size_t& begin, std::size_t& length) {
    const auto place = [&](double at) {
      return std::clamp(std::ceil((at - static_cast<double>(first)) / static_cast<double>(step)), 0.0,
                        static_cast<double>(count));
    };
    begin = static_cast<std::size_t>(place(from));
    length = static_cast<std::size_t>(place(to)) - begin;
  };
  Seen seen;
  span(view.row_first, view.row_last, window.row0, window.row_step, window.rows, seen.row, seen.rows);
  span(view.column_first, view.column_last, window.col0, window.col_step, window.cols, seen.column, seen.columns);
  if (seen.rows == 0 || seen.columns == 0) return {0, window.rows, 0, window.cols};
  return seen;
}

PartColours colours_of(const std::vector<std::complex<double>>& samples, const raster::ImageWindow& window,
                       const PartLook& look, const ImageView& view) {
  const Seen seen = seen_of(window, view);
  const auto row = [&](std::size_t i) {
    return std::span<const std::complex<double>>(samples).subspan((seen.row + i) * window.cols + seen.column,
                                                                  seen.columns);
  };
  picture::SampleStatistics statistics;
  for (std::size_t i = 0; i < seen.rows; ++i)
    statistics =
        i == 0 ? picture::statistics_of(row(i)) : picture::together(statistics, picture::statistics_of(row(i)));
  if (look.limits.percentile < 100.0)
    statistics.percentile_v = picture::magnitude_percentile(seen.rows, row, look.limits.percentile);
  PartColours colours;
  colours.quantity = look.quantity;
  colours.table = picture::colour_table(look.map, look.sliders, look.inverted);
  colours.reference_v = picture::reference_v(look.decibels, statistics);
  colours.limits = picture::colour_limits(look.quantity, look.limits, look.decibels, statistics);
  return colours;
}

}  // namespace

ImageView whole_view(std::size_t rows, std::size_t columns) {
  const auto end = [](std::size_t size) { return static_cast<double>(std::max<std::size_t>(size, 1)) - 0.5; };
  return {-0.5, end(columns), -0.5, end(rows)};
}

ImageView mended(const ImageView& view, std::size_t rows, std::size_t columns) {
  const auto [column_first, column_last] = mended_span(view.column_first, view.column_last, columns);
  const auto [row_first, row_last] = mended_span(view.row_first, view.row_last, rows);
  return {column_first, column_last, row_first, row_last};
}

ImageView scaled_about(const ImageView& view, double column, double row, double column_factor, double row_factor) {
  const auto scaled = [](double at, double about, double factor) { return about + (at - about) * factor; };
  return {scaled(view.column_first, column, column_factor), scaled(view.column_last, column, column_factor),
          scaled(view.row_first, row, row_factor), scaled(view.row_last, row, row_factor)};
}

ImageView with_equal_scale(const ImageView& view, double row_step_m, double column_step_m, QSize plot_px) {
  constexpr double longest_strip = 6.0;
  const double row_m = std::abs(row_step_m);
  const double column_m = std::abs(column_step_m);
  const double down_m = row_m * view.rows();
  const double across_m = column_m * view.columns();
  if (!(down_m > 0.0) || !(across_m > 0.0) || !std::isfinite(down_m * across_m) || plot_px.isEmpty()) return view;
  if (std::max(across_m, down_m) > longest_strip * std::min(across_m, down_m)) return view;
  const double m_per_px = std::max(view.columns() * column_m / plot_px.width(), view.rows() * row_m / plot_px.height());
  const double columns_seen = m_per_px * plot_px.width() / column_m;
  const double rows_seen = m_per_px * plot_px.height() / row_m;
  const double column = 0.5 * (view.column_first + view.column_last);
  const double row = 0.5 * (view.row_first + view.row_last);
  return {column - 0.5 * columns_seen, column + 0.5 * columns_seen, row - 0.5 * rows_seen, row + 0.5 * rows_seen};
}

raster::ImageWindow window_for(const ImageView& view, std::size_t width_px, std::size_t height_px, std::size_t rows,
                               std::size_t columns, bool peak) {
  const Places down = places(view.row_first, view.row_last, height_px, rows, peak);
  const Places across = places(view.column_first, view.column_last, width_px, columns, peak);
  if (down.count == 0 || across.count == 0) return {};
  return {down.first, down.count, across.first, across.count, down.step, across.step};
}

raster::ImageWindow samples_in(const ImageView& view, std::size_t rows, std::size_t columns) {
  const auto span = [](double from, double to, std::size_t size, std::size_t& first, std::size_t& count) {
    const double low = std::clamp(std::ceil(from), 0.0, static_cast<double>(size));
    const double high = std::clamp(std::floor(to) + 1.0, low, static_cast<double>(size));
    first = static_cast<std::size_t>(low);
    count = static_cast<std::size_t>(high - low);
  };
  raster::ImageWindow window;
  span(view.row_first, view.row_last, rows, window.row0, window.rows);
  span(view.column_first, view.column_last, columns, window.col0, window.cols);
  return window;
}

PartLook look_for(raster::ImageValue value, bool picture) {
  PartLook look;
  if (!picture && value != raster::ImageValue::rgb) {
    look.quantity =
        value == raster::ImageValue::real ? picture::DisplayQuantity::real : picture::DisplayQuantity::decibels;
    look.map = value == raster::ImageValue::real ? picture::ColourMap::balance_dark : picture::ColourMap::ocean;
    return look;
  }
  look.quantity = picture::DisplayQuantity::real;
  look.map = picture::ColourMap::grey;
  look.limits.kind = picture::LimitRule::Kind::extremes;
  return look;
}

bool has_quantity(raster::ImageValue value, picture::DisplayQuantity quantity) {
  if (value == raster::ImageValue::complex) return true;
  if (value == raster::ImageValue::rgb) return false;
  if (quantity == picture::DisplayQuantity::real) return value == raster::ImageValue::real;
  return quantity == picture::DisplayQuantity::magnitude || quantity == picture::DisplayQuantity::decibels;
}

std::optional<std::size_t> ImagePart::nearest(double column, double row) const {
  if (samples.empty() || !extent_of(window).contains(QPointF(column, row))) return std::nullopt;
  const auto place = [](double at, std::size_t first, std::size_t step, std::size_t count) {
    const double index = std::round((at - static_cast<double>(first)) / static_cast<double>(step));
    return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
  };
  return place(row, window.row0, window.row_step, window.rows) * window.cols +
         place(column, window.col0, window.col_step, window.cols);
}

QRectF extent_of(const raster::ImageWindow& window) {
  const auto number = [](std::size_t n) { return static_cast<double>(n); };
  return {number(window.col0) - 0.5 * number(window.col_step), number(window.row0) - 0.5 * number(window.row_step),
          number(window.cols) * number(window.col_step), number(window.rows) * number(window.row_step)};
}

PaintedPart paint(const ImagePart& part, const PartLook& look, const ImageView& seen) {
  PaintedPart painted;
  painted.image = QImage(static_cast<int>(part.window.cols), static_cast<int>(part.window.rows), QImage::Format_RGB32);
  if (painted.image.isNull()) return painted;
  const auto paint_with = [&](const auto& colour) {
    for (std::size_t i = 0; i < part.window.rows; ++i) {
      auto* const line = reinterpret_cast<QRgb*>(painted.image.scanLine(static_cast<int>(i)));
      for (std::size_t k = 0; k < part.window.cols; ++k) line[k] = colour(i * part.window.cols + k);
    }
  };
  if (!part.colours.empty()) {
    paint_with([&](std::size_t index) { return pixel(part.colours[index]); });
    return painted;
  }
  const std::vector<std::complex<double>> samples = shown_samples(part, look.quantity);
  painted.colours = colours_of(samples, part.window, look, seen);
  const PartColours& colours = painted.colours;
  std::vector<QRgb> pixels;
  for (const raster::Rgb& colour : colours.table) pixels.push_back(pixel(colour));
  const bool cyclic = look.quantity == picture::DisplayQuantity::phase;
  paint_with([&](std::size_t index) {
    const double value = picture::value_of(look.quantity, samples[index], colours.reference_v);
    return pixels[picture::colour_index(value, colours.limits, pixels.size(), cyclic)];
  });
  return painted;
}

double shown_value(raster::ImageValue value, picture::DisplayQuantity quantity, std::complex<double> sample,
                   double reference_v) {
  if (value == raster::ImageValue::power && quantity == picture::DisplayQuantity::decibels)
    sample = std::sqrt(std::max(sample.real(), 0.0));
  return picture::value_of(quantity, sample, reference_v);
}

}  // namespace sarsim::gui
