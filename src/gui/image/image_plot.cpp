#include "gui/image/image_plot.hpp"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "gui/common/palette_colours.hpp"
#include "gui/common/plot_frame.hpp"
#include "picture/figure/ticks.hpp"

namespace sarsim::gui {

namespace {

constexpr double smallest_zoom_px = 4.0;
constexpr double ring_px = 9.0;  // radius
constexpr double chosen_ring_px = 13.0;

}  // namespace

ImagePlot::ImagePlot(QWidget* parent) : GesturePlot(parent) {
  setObjectName("image_plot");
  setAccessibleName(tr("Image"));
  setAccessibleDescription(tr("Samples across, rows downwards. Arrows move, plus and minus zoom."));
}

void ImagePlot::set_size(std::size_t rows, std::size_t columns) {
  rows_ = std::max<std::size_t>(rows, 1);
  columns_ = std::max<std::size_t>(columns, 1);
  update();
}

void ImagePlot::set_places(std::optional<raster::FocusedPlaces> places) {
  places_ = std::move(places);
  update();
}

void ImagePlot::set_axes(bool numbers, bool equal_scale) {
  numbers_ = numbers;
  equal_scale_ = equal_scale;
  update();
}

void ImagePlot::set_draw_as(picture::DrawAs draw_as) {
  draw_as_ = draw_as;
  update();
}

std::vector<ImageSlice> ImagePlot::slices() const {
  if (!part_) return {};
  return slices_of(*part_, painted_.colours, draw_as_, view_, plot_rect().size());
}

bool ImagePlot::has_equal_scale() const {
  return equal_scale_ && places_ && places_->azimuth.unit == "m" && places_->range.unit == "m";
}

ImageView ImagePlot::shown_view(const ImageView& view) const {
  const ImageView within = mended_here(view);
  if (!has_equal_scale()) return within;
  return with_equal_scale(within, places_->azimuth.step, places_->range.step, plot_rect().size());
}

raster::FocusedPlaces ImagePlot::shown_places() const {
  if (places_ && !numbers_) return *places_;
  raster::FocusedPlaces numbers;
  numbers.azimuth.label = tr("Row").toStdString();
  numbers.range.label = tr("Sample").toStdString();
  return numbers;
}

void ImagePlot::set_view(const ImageView& view) {
  if (view == view_) return;
  view_ = view;
  update();
}

void ImagePlot::set_part(std::shared_ptr<const ImagePart> part, PaintedPart painted, const QString& unit) {
  part_ = std::move(part);
  painted_ = std::move(painted);
  unit_ = unit;
  const std::vector<raster::Rgb>& table = painted_.colours.table;
  bar_ = table.empty() ? QImage() : QImage(1, static_cast<int>(table.size()), QImage::Format_RGB32);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const raster::Rgb& c = table[table.size() - 1 - i];
    bar_.setPixel(0, static_cast<int>(i), qRgb(c.red, c.green, c.blue));
  }
  update();
}

void ImagePlot::set_coarse(const QImage& picture) {
  coarse_ = picture;
  update();
}

void ImagePlot::set_reading_tool(bool on) {
  reading_tool_ = on;
  set_idle_cursor(on ? Qt::PointingHandCursor : Qt::CrossCursor);
}

QRect ImagePlot::plot_rect() const {
  const QFontMetrics metrics = fontMetrics();
  return plot_within(*this, QStringLiteral("-00000.00"), room_without_axis(metrics), room_of_axis(metrics));
}

SamplePlace ImagePlot::place_at(QPointF pixel) const {
  const QRect plot = plot_rect();
  return {view_.column_first + (pixel.x() - plot.left()) / plot.width() * view_.columns(),
          view_.row_first + (pixel.y() - plot.top()) / plot.height() * view_.rows()};
}

QPointF ImagePlot::pixel_of(SamplePlace place) const {
  const QRect plot = plot_rect();
  return {plot.left() + (place.column - view_.column_first) / view_.columns() * plot.width(),
          plot.top() + (place.row - view_.row_first) / view_.rows() * plot.height()};
}

std::optional<SamplePlace> ImagePlot::pointer_place() const {
  if (!plot_rect().contains(pointer().toPoint())) return std::nullopt;
  return place_at(pointer());
}

void ImagePlot::set_cursor(std::size_t index, std::optional<SamplePlace> place) {
  cursors_.at(index) = place;
  update();
  emit cursors_changed();
}

void ImagePlot::set_selection(std::optional<raster::ImageWindow> selection) {
  if (selection && selection->samples() == 0) selection.reset();
  if (selection_ == selection) return;
  selection_ = selection;
  update();
  emit selection_changed();
}

void ImagePlot::set_rings(std::vector<Ring> rings, std::optional<std::size_t> chosen) {
  rings_ = std::move(rings);
  chosen_ring_ = chosen;
  update();
}

// The nearest whose ring is touched.
std::optional<std::size_t> ImagePlot::ring_at(QPointF pixel) const {
  std::optional<std::size_t> nearest;
  double least = ring_px + 2.0;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const QPointF way = pixel_of(rings_[i].at) - pixel;
    const double distance = std::hypot(way.x(), way.y());
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void ImagePlot::paint_rings(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const QPointF at = pixel_of(rings_[i].at);
    if (!plot_rect().adjusted(-20, -20, 20, 20).contains(at.toPoint())) continue;
    const bool chosen = chosen_ring_ == i;
    const double radius = chosen ? chosen_ring_px : ring_px;
    // Light on dark, so that it is seen on any colour.
    painter.setPen(QPen(Qt::black, chosen ? 5.0 : 3.0));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(chosen ? QColor(255, 210, 60) : QColor(Qt::white), chosen ? 2.5 : 1.3,
                        rings_[i].found ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(at, radius, radius);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

QRectF ImagePlot::rect_of(const QRectF& samples) const {
  return QRectF(pixel_of({samples.left(), samples.top()}), pixel_of({samples.right(), samples.bottom()}));
}

void ImagePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  paint_plot(painter);
  painter.setPen(palette().color(QPalette::WindowText));
  paint_axes(painter);
  if (!bar_.isNull() && draw_as_ == picture::DrawAs::pixels) paint_colour_bar(painter);
  paint_marks(painter);
  paint_rectangle(painter, rectangle_with_shift() ? Qt::DashLine : Qt::SolidLine);
}

void ImagePlot::paint_plot(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.save();
  painter.setClipRect(plot);
  painter.fillRect(plot, empty_ground(palette()));
  if (draw_as_ != picture::DrawAs::pixels && part_ && part_->colours.empty()) {
    paint_slices(painter);
    painter.restore();
    return;
  }
  // No smoothing: no colour that no sample has.
  if (!coarse_.isNull())
    painter.drawImage(rect_of(QRectF(-0.5, -0.5, static_cast<double>(columns_), static_cast<double>(rows_))), coarse_);
  if (part_ && !painted_.image.isNull()) painter.drawImage(rect_of(extent_of(part_->window)), painted_.image);
  painter.restore();
}

void ImagePlot::paint_slices(QPainter& painter) const {
  const QRect plot = plot_rect();
  const bool across = draw_as_ == picture::DrawAs::curves_per_pulse;
  painter.fillRect(plot, colour_of(picture::Role::background, palette()));
  painter.setRenderHint(QPainter::Antialiasing);
  const std::vector<ImageSlice> slices = this->slices();
  painter.setPen(QPen(colour_of(picture::Role::faint, palette()), 1.0));
  for (const ImageSlice& slice : slices) {
    const QPointF base = pixel_of({slice.base, slice.base});
    if (across)
      painter.drawLine(QPointF(plot.left(), base.y()), QPointF(plot.right(), base.y()));
    else
      painter.drawLine(QPointF(base.x(), plot.top()), QPointF(base.x(), plot.bottom()));
  }
  painter.setPen(QPen(colour_of(picture::Role::curve, palette()), 1.2));
  QPolygonF line;
  for (const ImageSlice& slice : slices) {
    line.clear();
    for (const QPointF& point : slice.points) line.append(pixel_of({point.x(), point.y()}));
    painter.drawPolyline(line);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void ImagePlot::paint_axes(QPainter& painter) const {
  const QRect plot = plot_rect();
  draw_frame(painter, plot);
  const raster::FocusedPlaces places = shown_places();
  const auto axis_of = [](const raster::ImagePlaces& along, double first, double last, double length, double spacing,
                          const auto& pixel) {
    const auto place = [&](double number) { return along.first + along.step * number; };
    const picture::Ticks ticks = picture::axis_ticks(place(first), place(last), length, spacing, along.unit);
    FrameAxis axis{QString::fromStdString(along.label), {}};
    if (!ticks.unit.empty()) axis.title += QStringLiteral(" (%1)").arg(QString::fromStdString(ticks.unit));
    for (const picture::Tick& tick : ticks.ticks)
      axis.marks.push_back({pixel((tick.value - along.first) / along.step), QString::fromStdString(tick.label)});
    return axis;
  };
  const double widest = fontMetrics().horizontalAdvance(QStringLiteral("0000000000"));
  draw_axis_across(painter, plot,
                   axis_of(places.range, view_.column_first, view_.column_last, plot.width(), widest,
                           [this](double column) {
                             return pixel_of({column, 0.0}).x();
                           }),
                   widest, false);
  const double lines = 2.5 * fontMetrics().height();
  draw_axis_upwards(painter, plot,
                    axis_of(places.azimuth, view_.row_first, view_.row_last, plot.height(), lines, [this](double row) {
                      return pixel_of({0.0, row}).y();
                    }));
}

void ImagePlot::paint_colour_bar(QPainter& painter) const {
  const QRect plot = plot_rect();
  const picture::ColourLimits& limits = painted_.colours.limits;
  const double lines = 2.5 * fontMetrics().height();
  draw_colour_bar(painter, plot, width(),
                  {bar_, painted_.colours.quantity, limits,
                   picture::axis_ticks(limits.low, limits.high, plot.height(), lines, unit_.toStdString())});
}

void ImagePlot::paint_marks(QPainter& painter) const {
  painter.save();
  painter.setClipRect(plot_rect());
  if (selection_) {
    // Light on dark, so that it is seen on any colour.
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3.0));
    painter.drawRect(rect_of(extent_of(*selection_)));
    painter.setPen(QPen(Qt::white, 1.0, Qt::DashLine));
    painter.drawRect(rect_of(extent_of(*selection_)));
  }
  paint_rings(painter);
  for (std::size_t i = 0; i < cursors_.size(); ++i)
    if (cursors_[i]) draw_cursor(painter, plot_rect(), pixel_of(*cursors_[i]), i);
  painter.restore();
}

ImageView ImagePlot::moved(const ImageView& view, double right, double down) const {
  const double columns = right * view.columns();
  const double rows = down * view.rows();
  return shown_view(
      {view.column_first + columns, view.column_last + columns, view.row_first + rows, view.row_last + rows});
}

void ImagePlot::scale_about_pixel(QPointF pixel, double across, double upwards) {
  const SamplePlace at = place_at(pixel);
  emit view_wanted(shown_view(scaled_about(view_, at.column, at.row, across, upwards)));
}

void ImagePlot::drag(QPointF by) {
  emit view_dragged(moved(dragged_view_, -by.x() / plot_rect().width(), -by.y() / plot_rect().height()));
}

void ImagePlot::step(double right, double up) { emit view_wanted(moved(view_, right, -up)); }

void ImagePlot::show_twice(QPointF middle) {
  const SamplePlace at = place_at(middle);
  emit view_wanted(shown_view(
      {at.column - view_.columns(), at.column + view_.columns(), at.row - view_.rows(), at.row + view_.rows()}));
}

void ImagePlot::take_rectangle(QPointF from, QPointF to) {
  const QRectF drawn = QRectF(from, to).normalized() & QRectF(plot_rect());
  const SamplePlace low = place_at(drawn.topLeft());
  const SamplePlace high = place_at(drawn.bottomRight());
  const ImageView wanted{low.column, high.column, low.row, high.row};
  if (rectangle_with_shift())
    set_selection(samples_in(wanted, rows_, columns_));
  else if (drawn.width() >= smallest_zoom_px && drawn.height() >= smallest_zoom_px)
    emit view_wanted(shown_view(wanted));
}

void ImagePlot::click(QPointF pixel, Qt::KeyboardModifiers keys) {
  const SamplePlace at = place_at(pixel);
  const double column = std::round(at.column);
  const double row = std::round(at.row);
  if (column < 0.0 || row < 0.0 || column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return;
  if (const auto ring = ring_at(pixel); ring && !reading_tool_) emit ring_clicked(*ring);
  if (reading_tool_)
    emit reading_wanted(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
  else
    set_cursor(keys.testFlag(Qt::ShiftModifier) ? 1 : 0, SamplePlace{column, row});
}

void ImagePlot::drop_marks() {
  set_selection(std::nullopt);
  cursors_ = {};
  emit cursors_changed();
}

std::optional<QPointF> ImagePlot::mark(std::size_t index) const {
  if (reading_tool_ || !cursors_.at(index)) return std::nullopt;
  return pixel_of(*cursors_.at(index));
}

void ImagePlot::move_mark(std::size_t index, QPointF to) {
  const SamplePlace at = place_at(to);
  const auto within = [](double number, std::size_t count) {
    return std::clamp(std::round(number), 0.0, static_cast<double>(count - 1));
  };
  set_cursor(index, SamplePlace{within(at.column, columns_), within(at.row, rows_)});
}

}  // namespace sarsim::gui
