#include "picture/image/image_figure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::picture {

namespace {

using Samples = std::vector<std::complex<double>>;

struct Extent {
  std::size_t first;
  std::size_t count;
  std::size_t step;
  std::size_t shown;
};

// Every so many rows or columns that at most `most` are shown.
Extent extent_of(std::size_t first, std::size_t wanted, std::size_t all, std::size_t most, const char* what) {
  if (first >= all || wanted > all - first)
    throw std::invalid_argument(std::string("the part has ") + what + " beyond the " + std::to_string(all) +
                                " of the file");
  const std::size_t count = wanted > 0 ? wanted : all - first;
  const std::size_t step = (count + most - 1) / std::max<std::size_t>(most, 1);
  return {first, count, std::max<std::size_t>(step, 1),
          (count + std::max<std::size_t>(step, 1) - 1) / std::max<std::size_t>(step, 1)};
}

// Where rows or columns are: the name and unit of their places, and the places themselves as index -> place.
struct Places {
  std::string label;
  std::string unit;
  double first = 0.0;  // of row or column 0
  double step = 1.0;
};

Places places_of(const Extent& extent, const std::optional<raster::ImagePlaces>& wanted,
                 const std::vector<double>* places, Places file, const char* counted) {
  if (wanted) return {wanted->label, wanted->unit, wanted->first, wanted->step};
  if (places == nullptr || places->size() < extent.first + extent.count || extent.count < 2) return {counted, "", 0, 1};
  const double begin = (*places)[extent.first];
  file.step = ((*places)[extent.first + extent.count - 1] - begin) / static_cast<double>(extent.count - 1);
  if (!(std::abs(file.step) > 0.0)) return {counted, "", 0, 1};
  file.first = begin - file.step * static_cast<double>(extent.first);
  return file;
}

// Half a cell before the first place and half behind the last.
FigureAxis axis_of(const Extent& extent, const Places& places) {
  const double begin = static_cast<double>(extent.first) - 0.5;
  const double end = begin + static_cast<double>(extent.shown * extent.step);
  return {places.label, places.unit, places.first + places.step * begin, places.first + places.step * end, {}};
}

double place_of(const Extent& extent, const Places& places, std::size_t shown) {
  return places.first + places.step * static_cast<double>(extent.first + shown * extent.step);
}

// Samples that nothing can be drawn of, among those that are looked at.
struct NotFinite {
  std::size_t count = 0;
  std::size_t row = 0;  // of the first of them, in the file
  std::size_t column = 0;

  void look_at(const std::complex<float>& sample, std::size_t at_row, std::size_t at_column) {
    if (std::isfinite(sample.real()) && std::isfinite(sample.imag())) return;
    if (count++ > 0) return;
    row = at_row;
    column = at_column;
  }
};

Samples read_subset(const raster::Raster& source, const Extent& across, const Extent& up,
                    const core::WorkControl& control, NotFinite& not_finite) {
  std::vector<std::complex<float>> read(across.shown * up.shown);
  source.read_window({up.first, up.shown, across.first, across.shown, up.step, across.step}, read, control);
  for (std::size_t i = 0; i < read.size(); ++i)
    not_finite.look_at(read[i], up.first + i / across.shown * up.step, across.first + i % across.shown * across.step);
  return {read.begin(), read.end()};
}

// The largest sample of each cell of up.step rows and across.step columns.
Samples read_peaks(const raster::Raster& source, const Extent& across, const Extent& up,
                   const core::WorkControl& control, NotFinite& not_finite) {
  Samples peaks(across.shown * up.shown);
  std::vector<std::complex<float>> read(across.count * up.step);
  for (std::size_t r = 0; r < up.shown; ++r) {
    const std::size_t rows = std::min(up.step, up.count - r * up.step);
    const auto part = std::span(read).first(rows * across.count);
    source.read_window({up.first + r * up.step, rows, across.first, across.count, 1, 1}, part, control);
    for (std::size_t i = 0; i < part.size(); ++i) {
      not_finite.look_at(part[i], up.first + r * up.step + i / across.count, across.first + i % across.count);
      std::complex<double>& peak = peaks[r * across.shown + i % across.count / across.step];
      if (const std::complex<double> sample(part[i]); std::norm(sample) > std::norm(peak)) peak = sample;
    }
  }
  return peaks;
}

// The values of a picture and what they are measured by.
struct ShownSamples {
  Samples samples;
  SampleStatistics statistics;
  double zero_db_v = 1.0;
  ColourLimits limits;

  [[nodiscard]] double value(const ImageLook& look, std::size_t i) const {
    return value_of(look.quantity, samples[i], zero_db_v);
  }
};

ShownSamples shown(Samples samples, const Extent& across, const Extent& up, const ImageLook& look) {
  ShownSamples out{std::move(samples), {}, 1.0, {}};
  out.statistics = statistics_of(out.samples);
  if (look.limits.percentile < 100.0)
    out.statistics.percentile_v = magnitude_percentile(
        up.shown, [&](std::size_t row) { return std::span(out.samples).subspan(row * across.shown, across.shown); },
        look.limits.percentile);
  out.zero_db_v = reference_v(look.decibels, out.statistics);
  out.limits = colour_limits(look.quantity, look.limits, look.decibels, out.statistics);
  return out;
}

// Files that others made, and pictures, do not say what their numbers are.
std::string unit_for(const raster::Raster& source, const ImageLook& look) {
  if (look.unit) return *look.unit;
  const raster::RasterInfo& info = source.info();
  const bool unknown = info.counts || (info.format != nullptr && (info.format->by_hand || info.format->picture));
  return unknown ? "" : "V";
}

std::string largest_text(double largest, const std::string& unit, bool counts) {
  if (unit == "V") return "Highest magnitude: " + core::with_prefix(largest, unit);
  return fmt::format("Highest magnitude: {:.6g}{}", largest, counts ? " counts" : "");
}

void add_pixels(FigurePanel& panel, const ShownSamples& seen, const Extent& across, const Extent& up,
                const ImageLook& look, const std::string& volts) {
  const std::vector<raster::Rgb> colours = colour_table(look.map, look.sliders, look.inverted);
  const ColourMapKind kind = kind_for(look.quantity);
  const bool cyclic = kind == ColourMapKind::cyclic;
  FigureImage& image = panel.image.emplace();
  image = {across.shown, up.shown, panel.x.first, panel.x.last, panel.y.first, panel.y.last, {}};
  image.cells.reserve(seen.samples.size());
  for (std::size_t i = 0; i < seen.samples.size(); ++i)
    image.cells.push_back(colours[colour_index(seen.value(look, i), seen.limits, colours.size(), cyclic)]);
  const std::string_view unit = unit_of(look.quantity);
  panel.colour_bar = FigureColourBar{std::string(axis_title_of(look.quantity)),
                                     unit == "V" ? volts : std::string(unit),
                                     seen.limits.low,
                                     seen.limits.high,
                                     colours,
                                     kind};
}

// Decibels of the outermost curve may reach beyond half of the distance to the next one.
void make_room_above(FigurePanel& panel) {
  for (const FigureCurve& curve : panel.curves)
    for (const double y : curve.y) panel.y.last = std::max(panel.y.last, y);
}
void make_room_aside(FigurePanel& panel) {
  for (const FigureCurve& curve : panel.curves)
    for (const double x : curve.x) panel.x.last = std::max(panel.x.last, x);
}

// Larger places above: the first row of a map is its northern one.
void turn_upright(FigurePanel& panel) {
  if (panel.y.first <= panel.y.last) return;
  std::swap(panel.y.first, panel.y.last);
  if (!panel.image) return;
  FigureImage& image = *panel.image;
  std::swap(image.y_first, image.y_last);
  for (std::size_t low = 0, high = image.height - 1; low < high; ++low, --high)
    std::swap_ranges(image.cells.begin() + static_cast<std::ptrdiff_t>(low * image.width),
                     image.cells.begin() + static_cast<std::ptrdiff_t>((low + 1) * image.width),
                     image.cells.begin() + static_cast<std::ptrdiff_t>(high * image.width));
}

void add_curves(FigurePanel& panel, const ShownSamples& seen, const Extent& across, const Extent& up,
                const Places& columns, const Places& rows, const ImageLook& look) {
  const auto reach = curve_reach(look.quantity, seen.limits, seen.statistics.largest_v);
  const bool per_row = look.draw_as == DrawAs::curves_per_pulse;
  const double spacing =
      per_row ? rows.step * static_cast<double>(up.step) : columns.step * static_cast<double>(across.step);
  for (std::size_t i = 0; i < (per_row ? up : across).shown; ++i) {
    FigureCurve& curve = panel.curves.emplace_back();
    for (std::size_t k = 0; k < (per_row ? across : up).shown; ++k) {
      const std::size_t row = per_row ? i : k;
      const std::size_t column = per_row ? k : i;
      const double aside = std::abs(spacing) * reach(seen.value(look, row * across.shown + column));
      curve.x.push_back(place_of(across, columns, column) + (per_row ? 0.0 : aside));
      curve.y.push_back(place_of(up, rows, row) + (per_row ? aside : 0.0));
    }
  }
}

core::Problem remark_on(const NotFinite& samples, const raster::Raster& source) {
  return core::warning(fmt::format("{} of the samples are not finite; nothing is drawn of them", samples.count))
      .found(fmt::format("row {}, sample {} (from 0){}", samples.row, samples.column,
                         samples.count > 1 ? ", the first of them" : ""))
      .expected("finite numbers")
      .hint("sarsim info --statistics counts such samples")
      .in(source.info().path.string());
}

std::size_t curves_in(std::size_t pixels) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(pixels) / nearest_curves_px));
}

}  // namespace

std::function<double(double)> curve_reach(DisplayQuantity quantity, const ColourLimits& limits, double largest) {
  if (quantity == DisplayQuantity::decibels)
    return [limits](double value) {
      return 0.9 * (std::max(value, limits.low) - limits.low) / (limits.high - limits.low);
    };
  if (quantity == DisplayQuantity::phase) largest = 180.0;
  return [largest](double value) { return std::isfinite(value) && largest > 0.0 ? 0.375 * value / largest : 0.0; };
}

Figure image_figure(const raster::Raster& source, const ImageLook& wanted, const PlotSize& size,
                    const core::WorkControl& control, core::Problems* remarks) {
  ImageLook look = wanted;
  const std::size_t seen_rows = look.rows > 0 ? look.rows : source.rows();
  if (look.draw_as == DrawAs::automatic)
    look.draw_as = seen_rows <= curves_in(size.height_px) ? DrawAs::curves_per_pulse : DrawAs::pixels;
  const bool per_row = look.draw_as == DrawAs::curves_per_pulse;
  const bool per_column = look.draw_as == DrawAs::curves_per_range;
  const Extent across = extent_of(look.first_column, look.columns, source.columns(),
                                  per_column ? curves_in(size.width_px) : size.width_px, "columns");
  const Extent up =
      extent_of(look.first_row, look.rows, source.rows(), per_row ? curves_in(size.height_px) : size.height_px, "rows");
  const bool peaks = look.pixel_rule == PixelRule::peak && !per_row && !per_column;
  NotFinite not_finite;
  const ShownSamples seen = shown(peaks ? read_peaks(source, across, up, control, not_finite)
                                        : read_subset(source, across, up, control, not_finite),
                                  across, up, look);
  if (remarks != nullptr && not_finite.count > 0) remarks->push_back(remark_on(not_finite, source));

  Figure figure;
  const std::string unit = unit_for(source, look);
  figure.note = largest_text(seen.statistics.largest_v, unit, source.info().counts);
  FigurePanel& panel = figure.panels.emplace_back();
  const auto axes = source.axes();
  const Places columns =
      places_of(across, look.column_places, axes ? &axes->column_range_m : nullptr, {"Slant range", "m"}, "Sample");
  const Places rows =
      places_of(up, look.row_places, axes ? &axes->row_time_s : nullptr, {"Azimuth time", "s"}, "Pulse");
  panel.x = axis_of(across, columns);
  panel.y = axis_of(up, rows);
  if (per_row || per_column)
    add_curves(panel, seen, across, up, columns, rows, look);
  else
    add_pixels(panel, seen, across, up, look, unit);
  turn_upright(panel);
  if (per_row) make_room_above(panel);
  if (per_column) make_room_aside(panel);
  return figure;
}

}  // namespace sarsim::picture
