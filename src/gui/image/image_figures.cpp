#include "gui/image/image_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gui/image/image_slices.hpp"
#include "picture/facts/display_text.hpp"

namespace sarsim::gui {

namespace {

constexpr std::size_t bars = 128;
constexpr std::size_t coarse_side = 512;  // cells of the coarse picture of the whole image

// Bars of a histogram, wide enough to be seen, from the smallest value that is there to the largest.
picture::FigureCurve bars_of(const picture::QuantityStatistics& statistics) {
  const picture::Histogram& histogram = statistics.histogram;
  picture::FigureCurve curve;
  curve.bars = true;
  if (histogram.bins.empty() || statistics.count == 0) return curve;
  const auto bin = [&](double value) {
    const double at = (value - histogram.low) / histogram.bin_width();
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(histogram.bins.size() - 1)));
  };
  const std::size_t first = bin(statistics.minimum);
  const std::size_t last = bin(statistics.maximum);
  const std::size_t together = std::max<std::size_t>(1, (last - first + bars) / bars);
  for (std::size_t begin = first; begin <= last; begin += together) {
    std::uint64_t count = 0;
    const std::size_t end = std::min(begin + together, last + 1);
    for (std::size_t i = begin; i < end; ++i) count += histogram.bins[i];
    const double middle = static_cast<double>(begin) + 0.5 * static_cast<double>(together);
    curve.x.push_back(histogram.low + middle * histogram.bin_width());
    curve.y.push_back(static_cast<double>(count));
  }
  return curve;
}

// The span of numbers, never empty.
void set_span(picture::FigureAxis& axis, const std::vector<double>& values) {
  axis.first = std::numeric_limits<double>::infinity();
  axis.last = -axis.first;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    axis.first = std::min(axis.first, value);
    axis.last = std::max(axis.last, value);
  }
  if (axis.first > axis.last) axis.first = axis.last = 0.0;
  const double more = axis.last > axis.first ? 0.05 * (axis.last - axis.first) : 0.5;
  axis.first -= more;
  axis.last += more;
}

unsigned coarser_log2(unsigned base, std::size_t samples) {
  unsigned log2 = base;
  while ((samples >> log2) > coarse_side) ++log2;
  return log2;
}

}  // namespace

std::optional<ImageCuts> cuts_of(const ImagePlot& plot, const ImageWords& words) {
  const auto& part = plot.part();
  if (!part || part->samples.empty()) return std::nullopt;
  const ImageView& view = plot.view();
  const SamplePlace at = plot.cursor(0).value_or(
      SamplePlace{(view.column_first + view.column_last) / 2.0, (view.row_first + view.row_last) / 2.0});
  const auto index = part->nearest(at.column, at.row);
  if (!index) return std::nullopt;
  const std::size_t row = *index / part->window.cols;
  const std::size_t column = *index % part->window.cols;
  const PartColours& colours = plot.painted().colours;
  const auto value = [&](std::size_t i, std::size_t k) {
    const double v =
        shown_value(part->value, words.look.quantity, part->samples[i * part->window.cols + k], colours.reference_v);
    // The floor of what is drawn; silence would make the rest flat.
    return words.look.quantity == picture::DisplayQuantity::decibels ? std::max(v, colours.limits.low) : v;
  };
  const raster::FocusedPlaces places = plot.shown_places();
  const auto place = [](const raster::ImagePlaces& axis, double number) { return axis.first + axis.step * number; };
  picture::FigureCurve along;
  for (std::size_t k = 0; k < part->window.cols; ++k) {
    along.x.push_back(place(places.range, static_cast<double>(part->window.column(k))));
    along.y.push_back(value(row, k));
  }
  picture::FigureCurve across;
  across.role = picture::Role::curve_2;
  for (std::size_t i = 0; i < part->window.rows; ++i) {
    across.x.push_back(place(places.azimuth, static_cast<double>(part->window.row(i))));
    across.y.push_back(value(i, column));
  }
  const auto figure_of_cut = [&](picture::FigureCurve curve, std::size_t marked, const raster::ImagePlaces& axis,
                                 const QString& title, double from, double to) {
    picture::FigurePanel panel;
    panel.title = title.toStdString();
    panel.x = {axis.label, axis.unit, place(axis, from), place(axis, to), {}};
    panel.y = {std::string(picture::axis_title_of(words.look.quantity)), words.unit().toStdString(), 0.0, 1.0, {}};
    set_span(panel.y, curve.y);
    if (std::isfinite(curve.y[marked]))
      panel.marks.push_back({curve.x[marked], curve.y[marked],
                             picture::read_out_text(number_text(curve.y[marked], words.unit()).toStdString())});
    panel.curves.push_back(std::move(curve));
    picture::Figure figure;
    figure.panels.push_back(std::move(panel));
    return figure;
  };
  return ImageCuts{
      figure_of_cut(std::move(along), column, places.range, ImageWords::tr("Row %1").arg(part->window.row(row)),
                    view.column_first, view.column_last),
      figure_of_cut(std::move(across), row, places.azimuth,
                    ImageWords::tr("Sample %1").arg(part->window.column(column)), view.row_first, view.row_last)};
}

picture::Figure histogram_of(const picture::SelectionStatistics& statistics, const ImageWords& words) {
  const picture::QuantityStatistics& of = statistics[words.measured_quantity()];
  picture::FigurePanel panel;
  picture::FigureCurve curve = bars_of(of);
  for (double& x : curve.x) x *= words.measured_scale();
  panel.title = ImageWords::tr("How often").toStdString();
  panel.x = {std::string(picture::title_of(words.look.quantity)), words.measured_unit().toStdString(), 0.0, 1.0, {}};
  set_span(panel.x, curve.x);
  panel.y = {ImageWords::tr("Samples").toStdString(), "", 0.0, 1.0, {}};
  for (const double y : curve.y) panel.y.last = std::max(panel.y.last, 1.05 * y);
  panel.curves.push_back(std::move(curve));
  picture::Figure figure;
  figure.panels.push_back(std::move(panel));
  return figure;
}

picture::Figure figure_of(const ImagePlot& plot, const ImageWords& words) {
  picture::Figure figure;
  const auto& part = plot.part();
  if (!part || plot.painted().image.isNull()) return figure;
  const ImageView& view = plot.view();
  const QImage& picture = plot.painted().image;
  picture::FigurePanel panel;
  const raster::FocusedPlaces places = plot.shown_places();
  const auto across = [&](double column) { return places.range.first + places.range.step * column; };
  const auto down = [&](double row) { return places.azimuth.first + places.azimuth.step * row; };
  panel.x = {places.range.label, places.range.unit, across(view.column_first), across(view.column_last), {}};
  panel.y = {places.azimuth.label, places.azimuth.unit, down(view.row_last), down(view.row_first), {}};
  if (words.look.equal_scale && places.range.unit == "m" && places.azimuth.unit == "m") panel.y_per_x = 1.0;
  if (words.look.draw_as != picture::DrawAs::pixels && part->colours.empty()) {
    for (const ImageSlice& slice : plot.slices()) {
      picture::FigureCurve& curve = panel.curves.emplace_back();
      for (const QPointF& point : slice.points) {
        curve.x.push_back(across(point.x()));
        curve.y.push_back(down(point.y()));
      }
    }
    figure.panels.push_back(std::move(panel));
    return figure;
  }
  const QRectF place = extent_of(part->window);
  picture::FigureImage image;
  image.width = part->window.cols;
  image.height = part->window.rows;
  image.x_first = across(place.left());
  image.x_last = across(place.right());
  image.y_first = down(place.top());
  image.y_last = down(place.bottom());
  image.cells.reserve(part->window.samples());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb c = picture.pixel(x, y);
      image.cells.push_back({static_cast<std::uint8_t>(qRed(c)), static_cast<std::uint8_t>(qGreen(c)),
                             static_cast<std::uint8_t>(qBlue(c))});
    }
  panel.image = std::move(image);
  const PartColours& colours = plot.painted().colours;
  if (colours.table.size() > 1)
    panel.colour_bar = picture::FigureColourBar{std::string(picture::axis_title_of(colours.quantity)),
                                                words.unit().toStdString(),
                                                colours.limits.low,
                                                colours.limits.high,
                                                colours.table,
                                                picture::kind_for(colours.quantity)};
  figure.panels.push_back(std::move(panel));
  return figure;
}

CoarsePicture coarse_picture(const picture::Overview& overview, const raster::Raster& source, std::size_t rows,
                             const PartLook& wanted) {
  const unsigned row_log2 = coarser_log2(overview.base().row_log2, rows);
  const unsigned col_log2 = coarser_log2(overview.base().col_log2, source.columns());
  const picture::OverviewLevel level = overview.level(row_log2, col_log2);
  std::vector<float> cells(level.rows * level.columns);
  overview.read(row_log2, col_log2, 0, level.rows, 0, level.columns, cells);
  ImagePart part;
  part.window = {0, level.rows, 0, level.columns, std::size_t{1} << row_log2, std::size_t{1} << col_log2};
  part.value = source.info().value;
  part.samples.assign(cells.begin(), cells.end());
  PartLook look = wanted;
  const bool same_quantity =
      look.quantity == picture::DisplayQuantity::magnitude || look.quantity == picture::DisplayQuantity::decibels;
  const bool grey = part.value == raster::ImageValue::rgb ||
                    (part.value == raster::ImageValue::real && look.map == picture::ColourMap::grey);
  if (!same_quantity) {
    look.quantity = grey ? picture::DisplayQuantity::magnitude : picture::DisplayQuantity::decibels;
    if (picture::kind_for(picture::DisplayQuantity::decibels) != picture::info_of(look.map).kind)
      look.map = picture::ColourMap::grey;
    look.limits = {};
  }
  const ImageView all = whole_view(part.window.rows * part.window.row_step, part.window.cols * part.window.col_step);
  return {paint(part, look, all).image, same_quantity};
}

}  // namespace sarsim::gui
