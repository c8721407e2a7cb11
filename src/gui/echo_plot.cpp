#include "gui/echo_plot.hpp"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "gui/palette_colours.hpp"

namespace sarsim {

namespace {

constexpr int bar_width = 14;
constexpr int tick_length = 4;
constexpr int gap = 6;

QRgb empty_ground(bool dark) { return dark ? qRgb(38, 40, 44) : qRgb(214, 216, 220); }

}  // namespace

EchoPlot::EchoPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("echo_plot");
  setAccessibleName(tr("Echoes"));
  setAccessibleDescription(tr("Slant range across, azimuth time upwards. Arrows move, plus and minus zoom."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
}

QRect EchoPlot::plot_rect() const {
  const QFontMetrics metrics = fontMetrics();
  const int numbers = metrics.horizontalAdvance(QStringLiteral("-000.00"));
  const int line = metrics.height();
  const int left = numbers + line + 2 * gap + tick_length;
  const int right = numbers + line + bar_width + 3 * gap + tick_length;
  const int above = 2 * line + gap + tick_length;
  return QRect(left, above, std::max(width() - left - right, 1), std::max(height() - 2 * above, 1));
}

PlotSize EchoPlot::plot_size() const {
  const QRect plot = plot_rect();
  const auto pixels = [this](int length) {
    return static_cast<std::size_t>(std::max(1.0, std::round(length * devicePixelRatioF())));
  };
  return {pixels(plot.width()), pixels(plot.height())};
}

void EchoPlot::set_window(const EchoWindow& window, double light_speed_mps) {
  const bool same_look = window_ == window && light_speed_mps_ == light_speed_mps;
  window_ = window;
  light_speed_mps_ = light_speed_mps;
  if (!same_look) refresh_picture();
}

void EchoPlot::set_matrix(std::shared_ptr<const EchoMatrix> matrix) {
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
  colours_ = colours_for(*matrix_, window_);
  drawn_as_ = drawn_as(window_, *matrix_);
  if (drawn_as_ == DrawAs::pixels) {
    paint(*matrix_, colours_, window_.placing, 0, image_);
  } else {
    image_ = {};
    curves_ = drawn_as_ == DrawAs::curves_per_pulse ? curves_per_pulse(*matrix_, colours_)
                                                    : curves_per_range(*matrix_, colours_);
  }
}

QPointF EchoPlot::device(QPointF pixel) const {
  const PlotSize size = plot_size();
  const QRect plot = plot_rect();
  // Pixel k of the picture has its centre at coordinate k.
  return {(pixel.x() - plot.left()) * static_cast<double>(size.width_px) / plot.width() - 0.5,
          (pixel.y() - plot.top()) * static_cast<double>(size.height_px) / plot.height() - 0.5};
}

QPointF EchoPlot::pixel_of(const Cursor& cursor) const {
  const PlotSize size = plot_size();
  const QRect plot = plot_rect();
  const double x = x_of_range(view(), size, cursor.range_m);
  const double y = y_of_time(view(), size, cursor.time_s);
  return {plot.left() + (x + 0.5) * plot.width() / static_cast<double>(size.width_px),
          plot.top() + (y + 0.5) * plot.height() / static_cast<double>(size.height_px)};
}

std::optional<ReadOut> EchoPlot::read_out_at(QPointF pixel) const {
  if (!matrix_ || !plot_rect().contains(pixel.toPoint())) return std::nullopt;
  // The matrix may still be that of another view or size.
  const QPointF at = device(pixel);
  const EchoView shown = view_of(matrix_->window());
  const double x = x_of_range(shown, matrix_->size(), range_at(view(), plot_size(), at.x()));
  const double y = y_of_time(shown, matrix_->size(), time_at(view(), plot_size(), at.y()));
  return read_out(*matrix_, colours_, x, y);
}

std::optional<ReadOut> EchoPlot::read_out_at_cursor(std::size_t cursor) const {
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
  const EchoView shown = view_of(matrix_->window());
  if (shown == view()) return plot;
  const QPointF low = pixel_of({shown.range_start_m, shown.time_start_s});
  const QPointF high = pixel_of({shown.range_end_m, shown.time_end_s});
  return QRectF(QPointF(low.x(), high.y()), QPointF(high.x(), low.y()));
}

QImage EchoPlot::plot_image() const {
  const PlotSize size = plot_size();
  QImage picture(static_cast<int>(size.width_px), static_cast<int>(size.height_px), QImage::Format_RGB32);
  QPainter painter(&picture);
  const QRect plot = plot_rect();
  painter.scale(picture.width() / static_cast<double>(plot.width()),
                picture.height() / static_cast<double>(plot.height()));
  painter.translate(-plot.topLeft());
  paint_plot(painter);
  return picture;
}

void EchoPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  paint_plot(painter);
  paint_axes(painter);
  if (drawn_as_ == DrawAs::pixels && !image_.pixel.empty()) paint_colour_bar(painter);
  paint_cursors(painter);
  if (!rectangle_from_) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
  QColor filled = palette().color(QPalette::Highlight);
  filled.setAlphaF(0.2F);
  painter.setBrush(filled);
  painter.drawRect(QRectF(*rectangle_from_, pointer_).normalized() & QRectF(plot_rect()));
}

void EchoPlot::paint_plot(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.save();
  painter.setClipRect(plot);
  painter.fillRect(plot, QColor(empty_ground(is_dark(palette()))));
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
  const PlotSize& size = matrix_->size();
  painter.fillRect(plot_rect(), colour_of(Role::background, palette()));
  painter.setRenderHint(QPainter::Antialiasing);
  const auto at = [&](const EchoCurve::Point& point) {
    return QPointF(place.left() + (point.x_px + 0.5) * place.width() / static_cast<double>(size.width_px),
                   place.top() + (point.y_px + 0.5) * place.height() / static_cast<double>(size.height_px));
  };
  painter.setPen(QPen(colour_of(Role::faint, palette()), 1.0));
  for (const EchoCurve& curve : curves_.curves) painter.drawLine(at(curve.base_from), at(curve.base_to));
  painter.setPen(QPen(colour_of(Role::curve, palette()), 1.2));
  QPolygonF line;
  for (const EchoCurve& curve : curves_.curves) {
    line.clear();
    for (const EchoCurve::Point& point : curve.points) line.append(at(point));
    painter.drawPolyline(line);
  }
}

void EchoPlot::paint_axes(QPainter& painter) const {
  const QRect plot = plot_rect();
  const double ratio = static_cast<double>(plot_size().width_px) / plot.width();
  const double spacing = fontMetrics().horizontalAdvance(QStringLiteral("00000.000")) * ratio;
  const PlotAxes axes = plot_axes(view(), plot_size(), light_speed_mps_, spacing);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawRect(plot.adjusted(0, 0, -1, -1));
  const int line = fontMetrics().height();
  const auto across = [&](const PlotAxis& axis, bool above) {
    const int edge = above ? plot.top() : plot.bottom() + 1;
    const int step = above ? -tick_length : tick_length;
    for (const PlotAxis::Mark& mark : axis.marks) {
      const double x = plot.left() + (mark.px + 0.5) / ratio;
      painter.drawLine(QPointF(x, edge), QPointF(x, edge + step));
      const QRectF words(x - spacing, above ? edge + step - line : edge + step, 2.0 * spacing, line);
      painter.drawText(words, Qt::AlignCenter, QString::fromStdString(mark.label));
    }
    const int title = above ? edge + step - 2 * line : edge + step + line;
    painter.drawText(QRect(plot.left(), title, plot.width(), line), Qt::AlignCenter,
                     QString::fromStdString(axis.title));
  };
  across(axes.range, false);
  across(axes.delay, true);
  for (const PlotAxis::Mark& mark : axes.time.marks) {
    const double y = plot.top() + (mark.px + 0.5) / ratio;
    painter.drawLine(QPointF(plot.left() - tick_length, y), QPointF(plot.left(), y));
    const QRectF words(0.0, y - line, plot.left() - tick_length - gap / 2.0, 2.0 * line);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(mark.label));
  }
  painter.save();
  painter.translate(gap / 2.0, plot.center().y());
  painter.rotate(-90.0);
  painter.drawText(QRect(-plot.height() / 2, 0, plot.height(), line), Qt::AlignCenter,
                   QString::fromStdString(axes.time.title));
  painter.restore();
}

void EchoPlot::paint_colour_bar(QPainter& painter) const {
  const QRect plot = plot_rect();
  const QRect strip(plot.right() + 2 * gap, plot.top(), bar_width, plot.height());
  const double ratio = static_cast<double>(plot_size().height_px) / plot.height();
  const ColourBar bar = colour_bar(colours_, plot_size().height_px, 2.5 * fontMetrics().height() * ratio);
  const QImage picture(reinterpret_cast<const uchar*>(bar.pixel.data()), 1, static_cast<int>(bar.pixel.size()), 4,
                       QImage::Format_ARGB32_Premultiplied);
  painter.drawImage(strip, picture);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawRect(strip.adjusted(0, 0, -1, -1));
  const int line = fontMetrics().height();
  const ColourLimits& limits = colours_.limits;
  for (const Tick& tick : bar.ticks.ticks) {
    const double share = (tick.value - limits.low) / (limits.high - limits.low);
    const double y = strip.bottom() + 1 - share * strip.height();
    painter.drawLine(QPointF(strip.right() + 1, y), QPointF(strip.right() + 1 + tick_length, y));
    painter.drawText(QRectF(strip.right() + tick_length + gap / 2.0 + 1, y - line, width(), 2.0 * line),
                     Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(tick.label));
  }
  const QString unit = QString::fromStdString(bar.ticks.unit);
  const QString name = QString::fromUtf8(title_of(colours_.quantity).data());
  painter.save();
  painter.translate(width() - gap / 2.0, plot.center().y());
  painter.rotate(90.0);
  painter.drawText(QRect(-plot.height() / 2, 0, plot.height(), line), Qt::AlignCenter,
                   unit.isEmpty() ? name : name + QStringLiteral(" [%1]").arg(unit));
  painter.restore();
}

void EchoPlot::paint_cursors(QPainter& painter) const {
  const QRect plot = plot_rect();
  painter.setClipRect(plot);
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (std::size_t i = 0; i < cursors_.size(); ++i) {
    if (!cursors_[i]) continue;
    const QPointF at = pixel_of(*cursors_[i]);
    // Light on dark, so that it is seen on any colour.
    for (const auto& [colour, width] : {std::pair{Qt::black, 3.0}, std::pair{Qt::white, 1.0}}) {
      painter.setPen(QPen(QColor(colour), width, i == 0 ? Qt::SolidLine : Qt::DashLine));
      painter.drawLine(QPointF(plot.left(), at.y()), QPointF(plot.right(), at.y()));
      painter.drawLine(QPointF(at.x(), plot.top()), QPointF(at.x(), plot.bottom()));
    }
    const QRectF label(at + QPointF(3, 3), QSizeF(fontMetrics().height(), fontMetrics().height()));
    painter.fillRect(label, QColor(0, 0, 0, 160));
    painter.drawText(label, Qt::AlignCenter, QString::number(i + 1));
  }
}

}  // namespace sarsim
