#include "view/image_figure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/number_text.hpp"

namespace sarsim {

namespace {

struct Extent {
  std::size_t first;
  std::size_t count;
  std::size_t step;
  std::size_t shown;
};

Extent extent_of(std::size_t first, std::size_t wanted, std::size_t all, std::size_t pixels, const char* what) {
  if (first >= all || wanted > all - first)
    throw std::invalid_argument(std::string("the part has ") + what + " beyond the " + std::to_string(all) +
                                " of the file");
  const std::size_t count = wanted > 0 ? wanted : all - first;
  const std::size_t step = (count + pixels - 1) / std::max<std::size_t>(pixels, 1);
  return {first, count, std::max<std::size_t>(step, 1),
          (count + std::max<std::size_t>(step, 1) - 1) / std::max<std::size_t>(step, 1)};
}

// Half a cell before the first place and half behind the last.
FigureAxis axis_of(const Extent& extent, const std::vector<double>* places, const char* label, const char* unit,
                   const char* counted) {
  const double last = static_cast<double>(extent.first + extent.shown * extent.step) - 0.5;
  FigureAxis axis{counted, "", static_cast<double>(extent.first) - 0.5, last, std::nullopt};
  if (places == nullptr || places->size() < extent.first + extent.count || extent.count < 2) return axis;
  const double begin = (*places)[extent.first];
  const double end = (*places)[extent.first + extent.count - 1];
  const double cell = (end - begin) / static_cast<double>(extent.count - 1);
  if (!(std::abs(cell) > 0.0)) return axis;
  return {label, unit, begin - 0.5 * cell, begin - 0.5 * cell + cell * static_cast<double>(extent.shown * extent.step),
          std::nullopt};
}

}  // namespace

Figure image_figure(const ImageSource& source, const ImageLook& look, const PlotSize& size,
                    const WorkControl& control) {
  const Extent across = extent_of(look.first_column, look.columns, source.columns(), size.width_px, "columns");
  const Extent up = extent_of(look.first_row, look.rows, source.rows(), size.height_px, "rows");
  std::vector<std::complex<float>> read(across.shown * up.shown);
  source.read_window({up.first, up.shown, across.first, across.shown, up.step, across.step}, read, control);
  const std::vector<std::complex<double>> samples(read.begin(), read.end());
  SampleStatistics statistics = statistics_of(samples);
  if (look.limits.percentile < 100.0)
    statistics.percentile_v = magnitude_percentile(
        up.shown, [&](std::size_t row) { return std::span(samples).subspan(row * across.shown, across.shown); },
        look.limits.percentile);
  const double zero_db_v = reference_v(look.decibels, statistics);
  const ColourLimits limits = colour_limits(look.quantity, look.limits, look.decibels, statistics);
  const std::vector<Rgb> colours = colour_table(look.map, look.sliders, look.inverted);
  const bool cyclic = kind_for(look.quantity) == ColourMapKind::cyclic;

  Figure figure;
  figure.note = "largest value shown: " + format_number(statistics.largest_v) + (source.info().counts ? " counts" : "");
  FigurePanel& panel = figure.panels.emplace_back();
  const auto axes = source.axes();
  panel.x = axis_of(across, axes ? &axes->column_range_m : nullptr, "Slant range", "m", "Sample");
  panel.y = axis_of(up, axes ? &axes->row_time_s : nullptr, "Azimuth time", "s", "Pulse");
  FigureImage& image = panel.image.emplace();
  image = {across.shown, up.shown, panel.x.first, panel.x.last, panel.y.first, panel.y.last, {}};
  image.cells.reserve(samples.size());
  for (const std::complex<double>& sample : samples)
    image.cells.push_back(
        colours[colour_index(value_of(look.quantity, sample, zero_db_v), limits, colours.size(), cyclic)]);
  const bool volts = !source.info().counts && unit_of(look.quantity) == "V";
  panel.colour_bar = FigureColourBar{std::string(title_of(look.quantity)),
                                     volts || unit_of(look.quantity) != "V" ? std::string(unit_of(look.quantity)) : "",
                                     limits.low, limits.high, colours};
  return figure;
}

}  // namespace sarsim
