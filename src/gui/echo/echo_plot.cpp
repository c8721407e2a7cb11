#include "gui/echo/echo_plot.hpp"

#include <QPainter>

#include "gui/common/palette_colours.hpp"
#include "gui/common/plot_frame.hpp"

namespace sarsim::gui {

EchoPlot::EchoPlot(QWidget* parent) : GesturePlot(parent) {
  setObjectName("echo_plot");
  setAccessibleName(tr("Echoes"));
  setAccessibleDescription(tr("Slant range across, azimuth time upwards. Arrows move, plus and minus zoom."));
}

QRect EchoPlot::plot_rect() const {
  const int room = room_of_axis(fontMetrics());
  return plot_within(*this, QStringLiteral("-000.00"), room, room);
}

picture::PlotSize EchoPlot::plot_size() const {
  const QSize size = device_size();
  return {static_cast<std::size_t>(size.width()), static_cast<std::size_t>(size.height())};
}

void EchoPlot::set_window(const picture::EchoWindow& window, double light_speed_mps) {
  const bool same_look = window_ == window && light_speed_mps_ == light_speed_mps;
  window_ = window;
  light_speed_mps_ = light_speed_mps;
  if (!same_look) refresh_picture();
}

void EchoPlot::set_matrix(std::shared_ptr<const picture::EchoMatrix> matrix) {
  matrix_ = std::move(matrix);
  refresh_picture();
}

void EchoPlot::refresh_picture() {
  update();
  curves_ = {};
  if (!matrix_ || matrix_->ready_rows() == 0) {
    image_ = {};
    return;
  }
  colours_ = picture::colours_for(*matrix_, window_);
  drawn_as_ = picture::drawn_as(window_, *matrix_);
  if (drawn_as_ == picture::DrawAs::pixels) {
    picture::paint(*matrix_, colours_, window_.placing, 0, image_);
  } else {
    image_ = {};
    curves_ = drawn_as_ == picture::DrawAs::curves_per_pulse ? picture::curves_per_pulse(*matrix_, colours_)
                                                             : picture::curves_per_range(*matrix_, colours_);
  }
}

QPointF EchoPlot::device(QPointF pixel) const {
  const picture::PlotSize size = plot_size();
  const QRect plot = plot_rect();
  // Pixel k of the picture has its centre at coordinate k.
  return {(pixel.x() - plot.left()) * static_cast<double>(size.width_px) / plot.width() - 0.5,
          (pixel.y() - plot.top()) * static_cast<double>(size.height_px) / plot.height() - 0.5};
}

QPointF EchoPlot::pixel_of(const Cursor& cursor) const {
  const picture::PlotSize size = plot_size();
  const QRect plot = plot_rect();
  const double x = picture::x_of_range(view(), size, cursor.range_m);
  const double y = picture::y_of_time(view(), size, cursor.time_s);
  return {plot.left() + (x + 0.5) * plot.width() / static_cast<double>(size.width_px),
          plot.top() + (y + 0.5) * plot.height() / static_cast<double>(size.height_px)};
}

std::optional<picture::ReadOut> EchoPlot::read_out_at(QPointF pixel) const {
  if (!matrix_ || !plot_rect().contains(pixel.toPoint())) return std::nullopt;
  // The matrix may still be that of another view or size.
  const QPointF at = device(pixel);
  const picture::EchoView shown = picture::view_of(matrix_->window());
  const double x = picture::x_of_range(shown, matrix_->size(), picture::range_at(view(), plot_size(), at.x()));
  const double y = picture::y_of_time(shown, matrix_->size(), picture::time_at(view(), plot_size(), at.y()));
  return picture::read_out(*matrix_, colours_, x, y);
}

std::optional<picture::ReadOut> EchoPlot::read_out_at_cursor(std::size_t cursor) const {
  return cursors_.at(cursor) ? read_out_at(pixel_of(*cursors_.at(cursor))) : std::nullopt;
}

void EchoPlot::set_cursor(std::size_t index, std::optional<Cursor> place) {
  cursors_.at(index) = place;
  update();
  emit cursors_changed();
}

// Where the picture that there is belongs in the view that is wanted.
QRectF EchoPlot::place_of_picture() const {
  const QRect plot = plot_rect();
  const picture::EchoView shown = picture::view_of(matrix_->window());
  if (shown == view()) return plot;
  const QPointF low = pixel_of({shown.range_start_m, shown.time_start_s});
  const QPointF high = pixel_of({shown.range_end_m, shown.time_end_s});
  return QRectF(QPointF(low.x(), high.y()), QPointF(high.x(), low.y()));
}

void EchoPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  paint_plot(painter);
  painter.setPen(palette().color(QPalette::WindowText));
  paint_axes(painter);
  if (drawn_as_ == picture::DrawAs::pixels && !image_.pixel.empty()) paint_colour_bar(painter);
  paint_cursors(painter);
  paint_rectangle(painter, Qt::SolidLine);
}

void EchoPlot::paint_plot(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.save();
  painter.setClipRect(plot);
  painter.fillRect(plot, empty_ground(palette()));
  if (matrix_ && !image_.pixel.empty()) {
    const QImage picture(reinterpret_cast<const uchar*>(image_.pixel.data()), static_cast<int>(image_.width_px),
                         static_cast<int>(image_.height_px), static_cast<qsizetype>(image_.width_px) * 4,
                         QImage::Format_ARGB32_Premultiplied);
    painter.drawImage(place_of_picture(), picture);
  }
  if (matrix_ && !curves_.curves.empty()) paint_curves(painter);
  painter.restore();
}

void EchoPlot::paint_curves(QPainter& painter) const {
  const QRectF place = place_of_picture();
  const picture::PlotSize& size = matrix_->size();
  painter.fillRect(plot_rect(), colour_of(picture::Role::background, palette()));
  painter.setRenderHint(QPainter::Antialiasing);
  const auto at = [&](const picture::EchoCurve::Point& point) {
    return QPointF(place.left() + (point.x_px + 0.5) * place.width() / static_cast<double>(size.width_px),
                   place.top() + (point.y_px + 0.5) * place.height() / static_cast<double>(size.height_px));
  };
  painter.setPen(QPen(colour_of(picture::Role::faint, palette()), 1.0));
  for (const picture::EchoCurve& curve : curves_.curves) painter.drawLine(at(curve.base_from), at(curve.base_to));
  painter.setPen(QPen(colour_of(picture::Role::curve, palette()), 1.2));
  QPolygonF line;
  for (const picture::EchoCurve& curve : curves_.curves) {
    line.clear();
    for (const picture::EchoCurve::Point& point : curve.points) line.append(at(point));
    painter.drawPolyline(line);
  }
}

void EchoPlot::paint_axes(QPainter& painter) const {
  const QRect plot = plot_rect();
  const double ratio = static_cast<double>(plot_size().width_px) / plot.width();
  const double widest = fontMetrics().horizontalAdvance(QStringLiteral("00000.000"));
  const picture::PlotAxes axes = picture::plot_axes(view(), plot_size(), light_speed_mps_, widest * ratio);
  const auto placed = [&](const picture::PlotAxis& axis, int begin) {
    FrameAxis frame{QString::fromStdString(axis.title), {}};
    for (const picture::PlotAxis::Mark& mark : axis.marks)
      frame.marks.push_back({begin + (mark.px + 0.5) / ratio, QString::fromStdString(mark.label)});
    return frame;
  };
  draw_frame(painter, plot);
  draw_axis_across(painter, plot, placed(axes.range, plot.left()), widest, false);
  draw_axis_across(painter, plot, placed(axes.delay, plot.left()), widest, true);
  draw_axis_upwards(painter, plot, placed(axes.time, plot.top()));
}

void EchoPlot::paint_colour_bar(QPainter& painter) const {
  const QRect plot = plot_rect();
  const double ratio = static_cast<double>(plot_size().height_px) / plot.height();
  const picture::ColourBar bar =
      picture::colour_bar(colours_, plot_size().height_px, 2.5 * fontMetrics().height() * ratio);
  const QImage picture(reinterpret_cast<const uchar*>(bar.pixel.data()), 1, static_cast<int>(bar.pixel.size()), 4,
                       QImage::Format_ARGB32_Premultiplied);
  draw_colour_bar(painter, plot, width(), {picture, colours_.quantity, colours_.limits, bar.ticks});
}

void EchoPlot::paint_cursors(QPainter& painter) const {
  painter.setClipRect(plot_rect());
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (std::size_t i = 0; i < cursors_.size(); ++i)
    if (cursors_[i]) draw_cursor(painter, plot_rect(), pixel_of(*cursors_[i]), i);
}

void EchoPlot::scale_about_pixel(QPointF pixel, double across, double upwards) {
  const QPointF at = device(pixel);
  emit view_wanted(picture::scaled_about(view(), plot_size(), at.x(), at.y(), across, upwards));
}

void EchoPlot::drag(QPointF by) {
  const QPointF moved = device(by) - device({});
  emit view_dragged(picture::panned(dragged_view_, plot_size(), moved.x(), moved.y()));
}

void EchoPlot::step(double right, double up) {
  const picture::PlotSize size = plot_size();
  emit view_wanted(picture::panned(view(), size, -right * static_cast<double>(size.width_px),
                                   up * static_cast<double>(size.height_px)));
}

void EchoPlot::show_twice(QPointF middle) {
  const QPointF at = device(middle);
  emit view_wanted(picture::zoomed_out(view(), plot_size(), at.x(), at.y()));
}

void EchoPlot::take_rectangle(QPointF from, QPointF to) {
  const QPointF a = device(from);
  const QPointF b = device(to);
  if (const auto zoomed = picture::zoomed_to(view(), plot_size(), a.x(), a.y(), b.x(), b.y()))
    emit view_wanted(*zoomed);
}

void EchoPlot::click(QPointF pixel, Qt::KeyboardModifiers keys) {
  set_cursor(keys.testFlag(Qt::ShiftModifier) ? 1 : 0, place_at(pixel));
}

EchoPlot::Cursor EchoPlot::place_at(QPointF pixel) const {
  const QPointF at = device(pixel);
  return {picture::range_at(view(), plot_size(), at.x()), picture::time_at(view(), plot_size(), at.y())};
}

std::optional<QPointF> EchoPlot::mark(std::size_t index) const {
  if (!cursors_.at(index)) return std::nullopt;
  return pixel_of(*cursors_.at(index));
}

void EchoPlot::move_mark(std::size_t index, QPointF to) {
  const QRectF plot = plot_rect();
  set_cursor(index,
             place_at({std::clamp(to.x(), plot.left(), plot.right()), std::clamp(to.y(), plot.top(), plot.bottom())}));
}

void EchoPlot::drop_marks() {
  cursors_ = {};
  emit cursors_changed();
}

}  // namespace sarsim::gui
